#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <scrubjay/error.hpp>
#include <scrubjay/ros2/keystore.hpp>

namespace scrubjay::ros {
namespace {

namespace fs = std::filesystem;

/// The address that a `.p11` file holds; empty if it holds none.
std::string address_in(const fs::path& file) {
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text.starts_with("pkcs11:") ? text : std::string();
}

/// Finds the files of one folder, and notes the first that isn't there.
class Finder {
 public:
  explicit Finder(fs::path folder) : folder_(std::move(folder)) {}

  /// `name`.p11 or `name`.pem
  std::string key(const std::string& name) {
    const std::string address = address_in(folder_ / (name + ".p11"));
    return address.empty() ? file(name + ".pem") : address;
  }
  std::string file(const std::string& name) {
    const fs::path path = folder_ / name;
    if (readable(path)) return path.string();
    if (fault_.empty()) {
      fault_ = fmt::format("{} is {}", path.string(), fs::exists(path) ? "not for us to read" : "missing");
    }
    return {};
  }
  std::string file_if_there(const std::string& name) const {
    return readable(folder_ / name) ? (folder_ / name).string() : std::string();
  }
  const std::string& fault() const { return fault_; }

 private:
  static bool readable(const fs::path& path) { return fs::is_regular_file(path) && std::ifstream(path).good(); }

  fs::path folder_;
  std::string fault_;
};

/// Where an enclave's files are; `fault` if nowhere.
fs::path folder_of(const SecurityRequest& request, const std::string& enclave, std::string& fault) {
  if (request.keystore.empty()) {
    fault = "ROS_SECURITY_KEYSTORE isn't set; want the keystore's folder";
    return {};
  }
  const std::string& name = request.enclave_override.empty() ? enclave : request.enclave_override;
  const fs::path enclaves = fs::path(request.keystore) / "enclaves";
  const fs::path folder = name == "/" ? enclaves : enclaves / name.substr(name.starts_with('/') ? 1 : 0);
  if (!fs::is_directory(folder)) {
    fault =
        fmt::format("the enclave {} has no folder {}; `ros2 security create_enclave` makes it", name, folder.string());
  }
  return fs::absolute(folder);
}

}  // namespace

std::optional<SecurityFiles> find_security_files(const SecurityRequest& request, const std::string& enclave,
                                                 std::vector<std::string>& warnings) {
  std::string fault;
  const fs::path folder = folder_of(request, enclave, fault);
  SecurityFiles files;
  if (fault.empty()) {
    Finder find(folder);
    files = {.identity_ca = find.key("identity_ca.cert"),
             .certificate = find.key("cert"),
             .private_key = find.key("key"),
             .permissions_ca = find.key("permissions_ca.cert"),
             .governance = find.file("governance.p7s"),
             .permissions = find.file("permissions.p7s"),
             .revoked = find.file_if_there("crl.pem")};
    fault = find.fault();
  }
  if (fault.empty()) return files;
  if (request.enforce) throw Error("security is to be enforced, but " + fault);
  warnings.push_back("no security, although ROS_SECURITY_ENABLE asks for it: " + fault);
  return std::nullopt;
}

}  // namespace scrubjay::ros
