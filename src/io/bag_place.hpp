/// \file
/// The folder of a new bag, and what becomes of an older bag that is there.
#pragma once

#include <filesystem>
#include <optional>

namespace scrubjay {

/// Makes an empty folder. An older bag of that name is kept beside it with a `~` at its end until the new one is
/// complete, and put back if that can't be written. A bag that an earlier run has put aside so, and that was killed
/// before its own was complete, stays where it is.
class BagPlace {
 public:
  /// Throws Error if the folder holds anything that isn't a bag's, and Error (Kind::Failure) if it can't be made.
  explicit BagPlace(const std::filesystem::path& folder);

  /// As the system knows it, without links.
  const std::filesystem::path& folder() const { return folder_; }
  /// The new bag is complete: the older one goes.
  void keep();
  /// The new bag can't be written: the older one comes back, if there is one.
  void give_up();
  /// There is no new bag to speak of: its folder goes.
  void clear();

 private:
  void move_aside();

  std::filesystem::path folder_;
  std::optional<std::filesystem::path> older_;
};

/// Whether a writer left the file before it was whole: its log or its journal is still beside it.
bool has_sqlite_log(const std::filesystem::path& file);

}  // namespace scrubjay
