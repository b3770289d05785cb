/// \file
/// A keystore of SROS 2 for a test, made by openssl's command line.
#pragma once

#include <scrubjay/ros2/keystore.hpp>
#include <string>

#include "io/temporary_folder.hpp"

namespace scrubjay::ros {

/// With an authority of its own, which others don't know.
class TestKeystore {
 public:
  /// `domain`: for which its governance and permissions are.
  explicit TestKeystore(int domain);

  /// False where there is no openssl.
  bool made() const { return made_; }
  /// Makes an enclave that may read and write the DDS topics in `allowed` (patterns as in `rt/*`), and no others.
  SecurityFiles enclave(const std::string& name, const std::string& allowed);
  std::string path() const { return folder_.path().string(); }

 private:
  bool run(const std::string& words);
  void sign(const std::string& from, const std::string& to);

  int domain_;
  bool made_ = true;
  TemporaryFolder folder_;
};

}  // namespace scrubjay::ros
