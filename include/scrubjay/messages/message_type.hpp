/// \file
/// What others ask of a message's type.
#pragma once

#include <scrubjay/messages/definition.hpp>

namespace scrubjay::ros {

struct MessageType {
  std::string_view name;        ///< as nav_msgs/msg/Path
  std::string_view hash;        ///< as RIHS01_ and 64 hexadecimal digits (REP-2011)
  std::string (*definition)();  ///< its text, and that of all that it is made of
};

template <Message M>
inline constexpr MessageType kTypeOf{M::kType, M::kHash, &definition<M>};

/// `package/msg/Name` as DDS has it: `package::msg::dds_::Name_`.
std::string dds_type_name(std::string_view name);

}  // namespace scrubjay::ros
