#include <algorithm>
#include <scrubjay/messages/definition.hpp>

namespace scrubjay::ros::detail {

std::string short_name(std::string_view type) {
  const std::size_t package_end = type.find('/');
  return std::string(type.substr(0, package_end)) + std::string(type.substr(type.rfind('/')));
}

bool DefinitionText::begin(std::string_view type) {
  if (std::find(added_.begin(), added_.end(), type) != added_.end()) return false;
  if (!added_.empty()) text_ += std::string(80, '=') + "\nMSG: " + short_name(type) + "\n";
  added_.push_back(type);
  return true;
}

void DefinitionText::add_constant(const Constant& constant) {
  text_ += std::string(constant.type) + " " + std::string(constant.name) + "=" + std::to_string(constant.value) + "\n";
}

void DefinitionText::add_field(const std::string& type, std::string_view name) {
  text_ += type + " " + std::string(name) + "\n";
}

}  // namespace scrubjay::ros::detail
