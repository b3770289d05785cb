#include "security_properties.hpp"

namespace scrubjay::ros {

std::vector<std::pair<std::string, std::string>> security_properties(const SecurityFiles& files) {
  const auto address = [](const std::string& file) { return file.starts_with("pkcs11:") ? file : "file://" + file; };
  const std::string authentication = "dds.sec.auth.builtin.PKI-DH.";
  const std::string access = "dds.sec.access.builtin.Access-Permissions.";
  std::vector<std::pair<std::string, std::string>> properties{
      {"dds.sec.auth.plugin", "builtin.PKI-DH"},
      {authentication + "identity_ca", address(files.identity_ca)},
      {authentication + "identity_certificate", address(files.certificate)},
      {authentication + "private_key", address(files.private_key)},
      {"dds.sec.crypto.plugin", "builtin.AES-GCM-GMAC"},
      {"dds.sec.access.plugin", "builtin.Access-Permissions"},
      {access + "permissions_ca", address(files.permissions_ca)},
      {access + "governance", address(files.governance)},
      {access + "permissions", address(files.permissions)},
  };
  if (!files.revoked.empty()) properties.emplace_back(authentication + "identity_crl", address(files.revoked));
  return properties;
}

}  // namespace scrubjay::ros
