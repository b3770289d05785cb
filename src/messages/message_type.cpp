#include <scrubjay/messages/message_type.hpp>

namespace scrubjay::ros {

std::string dds_type_name(std::string_view name) {
  const std::size_t package_end = name.find('/');
  const std::size_t type_begin = name.rfind('/') + 1;
  return std::string(name.substr(0, package_end)) + "::msg::dds_::" + std::string(name.substr(type_begin)) + "_";
}

}  // namespace scrubjay::ros
