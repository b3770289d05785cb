/// \file
/// Files that are there whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

namespace scrubjay {

/// Writes a file so that whoever looks, even after a crash, finds the old content or the new, never a part.
///
/// The bytes go to a temporary file in the same folder, which is synced and then renamed over `path`. A symbolic link
/// is followed, so that the file it names is replaced. A file that was there keeps its permissions. Throws Error
/// (Kind::Failure) with the path and the system's reason when that fails (no such folder, no permission, disc full, not
/// a regular file); `path` is then as it was, and the temporary file is gone.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> content);
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace scrubjay
