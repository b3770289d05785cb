#include "user_data.hpp"

namespace scrubjay::ros {

std::string ros_type_name(std::string_view dds_name) {
  constexpr std::string_view kMiddle = "::msg::dds_::";
  const std::size_t middle = dds_name.find(kMiddle);
  if (middle == std::string_view::npos || !dds_name.ends_with('_')) return std::string(dds_name);
  const std::string_view last = dds_name.substr(middle + kMiddle.size());
  return std::string(dds_name.substr(0, middle)) + "/msg/" + std::string(last.substr(0, last.size() - 1));
}

}  // namespace scrubjay::ros
