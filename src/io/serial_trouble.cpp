#include "serial_trouble.hpp"

#include <fmt/format.h>
#include <grp.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <scrubjay/io/serial_port.hpp>
#include <string>
#include <vector>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

/// Calls `visit` for what is in a folder, as far as that can be read: entries of /proc come and go.
template <typename Visit>
void for_each_entry(const fs::path& folder, Visit visit) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) visit(entry->path());
}

std::string ports_there_are() {
  std::string list;
  for (const fs::path& port : serial_ports()) {
    const std::string adapter = adapter_name(port);
    list += (list.empty() ? "" : ", ") + port.string() + (adapter.empty() ? "" : " (" + adapter + ")");
  }
  return list.empty() ? "there is none on USB: plug the robot's cable in" : "there are: " + list;
}

/// Processes that have `path` open, of those that this user may look into: `minicom (1234)`.
std::string holders(const fs::path& path) {
  std::error_code error;
  const fs::path device = fs::canonical(path, error);
  if (error) return "";
  std::string list;
  for_each_entry("/proc", [&](const fs::path& process) {
    const std::string id = process.filename().string();
    if (id.find_first_not_of("0123456789") != std::string::npos) return;
    bool holds = false;
    for_each_entry(process / "fd", [&](const fs::path& file) { holds |= fs::read_symlink(file, error) == device; });
    if (!holds) return;
    std::string name;
    std::getline(std::ifstream(process / "comm"), name);
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, id);
  });
  return list;
}

/// Which group to join, and how.
std::string permission_advice(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return "its folder can't be searched";
  const group* owner = ::getgrgid(status.st_gid);
  if ((status.st_mode & (S_IRGRP | S_IWGRP)) != (S_IRGRP | S_IWGRP) || owner == nullptr) {
    return fmt::format("its owner alone may use it; try sudo chmod a+rw {}", path.string());
  }
  return fmt::format("its group {0} may use it: run sudo usermod -aG {0} $USER, then log out and in again",
                     owner->gr_name);
}

}  // namespace

std::vector<fs::path> serial_ports(const fs::path& devices) {
  std::vector<fs::path> ports;
  for_each_entry(devices, [&](const fs::path& path) {
    const std::string name = path.filename().string();
    if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) ports.push_back(path);
  });
  std::sort(ports.begin(), ports.end());
  return ports;
}

std::string adapter_name(const fs::path& port, const fs::path& devices) {
  std::string name;
  for_each_entry(devices / "serial" / "by-id", [&](const fs::path& link) {
    std::error_code error;
    if (fs::equivalent(link, port, error)) name = link.filename().string();
  });
  return name;
}

Error serial_open_error(const fs::path& path, int reason) {
  const std::string name = path.string();
  switch (reason) {
    case ENOENT:
    case ENOTDIR:
    case ENODEV:
    case ENXIO:
    case EIO:
      return Error(fmt::format("{}: no such port; {}", name, ports_there_are()));
    case EACCES:
    case EPERM:
      return Error(fmt::format("{}: no permission; {}", name, permission_advice(path)));
    case EISDIR:
    case ENOTTY:
      return Error(fmt::format("{}: is no serial port; {}", name, ports_there_are()));
    case EBUSY:
      return serial_in_use_error(path);
    default:
      return Error(fmt::format("{}: cannot open the port: {}", name, std::strerror(reason)));
  }
}

Error serial_in_use_error(const fs::path& path) {
  const std::string list = holders(path);
  const std::string who = list.empty() ? fmt::format("sudo fuser -v {} says by which program", path.string())
                                       : fmt::format("opened by {}", list);
  return Error(fmt::format("{}: in use; {}, which must be closed first", path.string(), who));
}

}  // namespace scrubjay
