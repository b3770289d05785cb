#include "ros2/test_keystore.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace scrubjay::ros {
namespace {

constexpr const char* kXmlHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
)";

/// As `ros2 security create_keystore` has it: nobody without a certificate, all encrypted.
std::string governance(int domain) {
  return fmt::format(R"({}<domain_access_rules><domain_rule>
  <domains><id>{}</id></domains>
  <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
  <enable_join_access_control>true</enable_join_access_control>
  <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
  <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
  <rtps_protection_kind>SIGN</rtps_protection_kind>
  <topic_access_rules><topic_rule>
    <topic_expression>*</topic_expression>
    <enable_discovery_protection>true</enable_discovery_protection>
    <enable_liveliness_protection>true</enable_liveliness_protection>
    <enable_read_access_control>true</enable_read_access_control>
    <enable_write_access_control>true</enable_write_access_control>
    <metadata_protection_kind>ENCRYPT</metadata_protection_kind>
    <data_protection_kind>ENCRYPT</data_protection_kind>
  </topic_rule></topic_access_rules>
</domain_rule></domain_access_rules></dds>
)",
                     kXmlHead, domain);
}

std::string permissions(const std::string& enclave, int domain, const std::string& allowed) {
  const std::string topics =
      fmt::format("<topics><topic>ros_discovery_info</topic><topic>{}</topic></topics>", allowed);
  return fmt::format(R"({}<permissions><grant name="{}">
  <subject_name>CN={}</subject_name>
  <validity><not_before>2020-01-01T00:00:00</not_before><not_after>2120-01-01T00:00:00</not_after></validity>
  <allow_rule>
    <domains><id>{}</id></domains>
    <publish>{}</publish>
    <subscribe>{}</subscribe>
  </allow_rule>
  <default>DENY</default>
</grant></permissions></dds>
)",
                     kXmlHead, enclave, enclave, domain, topics, topics);
}

}  // namespace

TestKeystore::TestKeystore(int domain) : domain_(domain) {
  run("ecparam -name prime256v1 -genkey -noout -out ca.key");
  run("req -x509 -new -key ca.key -sha256 -days 3650 -subj /CN=sros2CA -out ca.pem");
  folder_.write("governance.xml", governance(domain));
  sign("governance.xml", "governance.p7s");
}

SecurityFiles TestKeystore::enclave(const std::string& name, const std::string& allowed) {
  const std::string to = "enclaves" + name;
  std::filesystem::create_directories(folder_ / to);
  run(fmt::format("ecparam -name prime256v1 -genkey -noout -out {}/key.pem", to));
  // With another separator, as the name has slashes: a name of several parts begins and ends by its first character.
  folder_.write(to + "/request.cnf", fmt::format("[req]\nprompt=no\ndistinguished_name=name\n[name]\nCN={}\n", name));
  run(fmt::format("req -new -key {0}/key.pem -config {0}/request.cnf -out {0}/request.pem", to));
  run(
      fmt::format("x509 -req -in {0}/request.pem -CA ca.pem -CAkey ca.key -CAcreateserial -sha256 -days 3650 -out "
                  "{0}/cert.pem",
                  to));
  folder_.write(to + "/permissions.xml", permissions(name, domain_, allowed));
  sign(to + "/permissions.xml", to + "/permissions.p7s");
  for (const char* authority : {"identity_ca.cert.pem", "permissions_ca.cert.pem"}) {
    std::filesystem::copy_file(folder_ / "ca.pem", folder_ / (to + "/" + authority));
  }
  std::filesystem::copy_file(folder_ / "governance.p7s", folder_ / (to + "/governance.p7s"));
  std::vector<std::string> warnings;
  return *find_security_files({.enforce = true, .keystore = path(), .enclave_override = ""}, name, warnings);
}

bool TestKeystore::run(const std::string& words) {
  made_ = made_ && std::system(fmt::format("cd '{}' && openssl {} >/dev/null 2>&1", path(), words).c_str()) == 0;
  return made_;
}

void TestKeystore::sign(const std::string& from, const std::string& to) {
  run(fmt::format("smime -sign -text -md sha256 -in {} -signer ca.pem -inkey ca.key -out {}", from, to));
}

}  // namespace scrubjay::ros
