#include <fmt/format.h>

#include <fstream>
#include <scrubjay/ros2/socket_buffers.hpp>

namespace scrubjay::ros {
namespace {

/// What is in the way: `net.core.rmem_max = 212992`; empty if nothing, or if the system doesn't say.
std::string limit(const std::filesystem::path& net_core, const char* name) {
  std::ifstream file(net_core / name);
  std::uint64_t most = kSocketBuffer;
  if (!(file >> most) || most >= kSocketBuffer) return {};
  return fmt::format("net.core.{}={}", name, most);
}

}  // namespace

std::optional<Finding> clamped_buffers(const std::filesystem::path& net_core) {
  const std::string receiving = limit(net_core, "rmem_max");
  const std::string sending = limit(net_core, "wmem_max");
  if (receiving.empty() && sending.empty()) return std::nullopt;
  return Finding{Finding::Kind::Remark,
                 fmt::format("the system's {}{}{} leave sockets less than the {} bytes that large maps want", receiving,
                             receiving.empty() || sending.empty() ? "" : ", ", sending, kSocketBuffer),
                 fmt::format("sudo sysctl -w net.core.rmem_max={0} net.core.wmem_max={0}", kSocketBuffer)};
}

}  // namespace scrubjay::ros
