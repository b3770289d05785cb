#include <gmock/gmock.h>

#include <scrubjay/ros2/keystore.hpp>

#include "io/temporary_folder.hpp"
#include "ros2/security_properties.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

const std::vector<std::string> kFiles{"identity_ca.cert.pem",    "cert.pem",       "key.pem",
                                      "permissions_ca.cert.pem", "governance.p7s", "permissions.p7s"};

class KeystoreTest : public ::testing::Test {
 protected:
  void add_enclave(const std::string& enclave) {
    std::filesystem::create_directories(keystore_ / ("enclaves" + enclave));
    for (const std::string& file : kFiles) keystore_.write("enclaves" + enclave + "/" + file, "");
  }
  std::string path(const std::string& file) const { return (keystore_ / ("enclaves/" + file)).string(); }
  SecurityRequest request(bool enforce, const std::string& enclave_override = "") const {
    return {enforce, keystore_.path().string(), enclave_override};
  }

  TemporaryFolder keystore_;
  std::vector<std::string> warnings_;
};

TEST_F(KeystoreTest, FindsTheFilesOfAnEnclave) {
  add_enclave("/robot1");
  EXPECT_EQ(find_security_files(request(true), "/robot1", warnings_),
            (SecurityFiles{path("robot1/identity_ca.cert.pem"), path("robot1/cert.pem"), path("robot1/key.pem"),
                           path("robot1/permissions_ca.cert.pem"), path("robot1/governance.p7s"),
                           path("robot1/permissions.p7s")}));
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(KeystoreTest, TheRootsEnclaveIsTheFolderOfAll) {
  add_enclave("/");
  EXPECT_EQ(find_security_files(request(true), "/", warnings_)->certificate, path("cert.pem"));
}

TEST_F(KeystoreTest, AnOverrideIsTheEnclaveWhateverTheNodeSays) {
  add_enclave("/robot2");
  EXPECT_EQ(find_security_files(request(true, "/robot2"), "/robot1", warnings_)->certificate, path("robot2/cert.pem"));
}

TEST_F(KeystoreTest, AListOfRevokedCertificatesIsTakenWhereThereIsOne) {
  add_enclave("/robot1");
  keystore_.write("enclaves/robot1/crl.pem", "");
  EXPECT_EQ(find_security_files(request(true), "/robot1", warnings_)->revoked, path("robot1/crl.pem"));
}

TEST_F(KeystoreTest, AKeyMayBeInAToken) {
  add_enclave("/robot1");
  keystore_.write("enclaves/robot1/key.p11", "pkcs11:token=t;object=key\n");
  keystore_.write("enclaves/robot1/cert.p11", "nonsense");
  const SecurityFiles files = *find_security_files(request(true), "/robot1", warnings_);
  EXPECT_EQ(files.private_key, "pkcs11:token=t;object=key");
  EXPECT_EQ(files.certificate, path("robot1/cert.pem"));
}

TEST_F(KeystoreTest, EachMissingFileIsSaidWhereSecurityIsEnforced) {
  for (const std::string& file : kFiles) {
    add_enclave("/robot1");
    std::filesystem::remove(path("robot1/" + file));
    EXPECT_EQ(message_of([&] { find_security_files(request(true), "/robot1", warnings_); }),
              "security is to be enforced, but " + path("robot1/" + file) + " is missing");
  }
}

TEST_F(KeystoreTest, WhatIsMissingIsOnlySaidWhereSecurityIsNotEnforced) {
  add_enclave("/robot1");
  std::filesystem::remove(path("robot1/key.pem"));
  EXPECT_FALSE(find_security_files(request(false), "/robot1", warnings_));
  EXPECT_THAT(warnings_, ElementsAre(HasSubstr("no security")));
}

TEST_F(KeystoreTest, AnEnclaveWithoutAFolderIsSaid) {
  EXPECT_THAT(message_of([&] { find_security_files(request(true), "/robot1", warnings_); }),
              HasSubstr("the enclave /robot1 has no folder " + path("robot1")));
  EXPECT_THAT(message_of([&] {
                find_security_files({true, "", ""}, "/robot1", warnings_);
              }),
              HasSubstr("ROS_SECURITY_KEYSTORE isn't set"));
}

TEST(SecurityPropertiesTest, FilesAreAddressedAsFilesAndTokensAsTheyAre) {
  const auto properties = security_properties({.identity_ca = "/k/ca.pem",
                                               .certificate = "/k/cert.pem",
                                               .private_key = "pkcs11:object=key",
                                               .permissions_ca = "/k/pca.pem",
                                               .governance = "/k/g.p7s",
                                               .permissions = "/k/p.p7s"});
  EXPECT_THAT(properties, Contains(Pair("dds.sec.auth.builtin.PKI-DH.identity_ca", "file:///k/ca.pem")));
  EXPECT_THAT(properties, Contains(Pair("dds.sec.auth.builtin.PKI-DH.private_key", "pkcs11:object=key")));
  EXPECT_EQ(properties.size(), 9U);
}

}  // namespace
}  // namespace scrubjay::ros
