/// \file
/// The files that a secured participant needs (SROS 2).
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/ros2/environment.hpp>
#include <string>
#include <vector>

namespace scrubjay::ros {

/// Of one enclave: paths, or `pkcs11:` addresses where the enclave has a `.p11` file in place of one.
struct SecurityFiles {
  std::string identity_ca;
  std::string certificate;
  std::string private_key;
  std::string permissions_ca;
  std::string governance;
  std::string permissions;
  std::string revoked{};  ///< certificates that hold no more; empty: no such list

  bool operator==(const SecurityFiles&) const = default;
};

/// The files of an enclave (`/`, `/robot1`) in `<keystore>/enclaves`, as rcl and rmw_dds_common look for them.
///
/// What is missing is an Error that says which file or folder if security is to be enforced; else it is a line in
/// `warnings`, and there are none: the participant is an open one.
std::optional<SecurityFiles> find_security_files(const SecurityRequest& request, const std::string& enclave,
                                                 std::vector<std::string>& warnings);

}  // namespace scrubjay::ros
