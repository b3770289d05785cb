#include "socket_buffers.hpp"

#include <fmt/format.h>

#include <fstream>

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

std::string buffer_remark(const std::filesystem::path& net_core) {
  const std::string receiving = limit(net_core, "rmem_max");
  const std::string sending = limit(net_core, "wmem_max");
  if (receiving.empty() && sending.empty()) return {};
  return fmt::format(
      "the system's {}{}{} leave sockets less than the {} bytes that large maps want; sudo sysctl -w "
      "net.core.rmem_max={} net.core.wmem_max={}",
      receiving, receiving.empty() || sending.empty() ? "" : ", ", sending, kSocketBuffer, kSocketBuffer,
      kSocketBuffer);
}

}  // namespace scrubjay::ros
