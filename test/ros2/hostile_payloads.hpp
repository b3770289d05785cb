/// \file
/// What nobody should tell a robot, for each topic that it listens to.
#pragma once

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/message_type.hpp>
#include <string>
#include <vector>

namespace scrubjay::ros {

/// One type of a topic. Offsets are counted from the first byte of the encapsulation.
struct Target {
  std::string topic;
  MessageType type;
  Bytes sound;                           ///< a message that a robot would obey
  std::size_t least = 0;                 ///< so many of its bytes are needed
  std::vector<std::size_t> lengths{};    ///< where it has a length, of a sequence or text
  std::vector<std::size_t> text_ends{};  ///< where a text's NUL is
  std::vector<Bytes> absurd{};           ///< whole messages that no robot can obey
};

/// All that a bridge listens to.
std::vector<Target> targets();

/// Something that is never a message which a robot can obey: cut, noise, in an encapsulation that isn't plain CDR, with
/// a length or a text that goes on for ever, or absurd. Without any byte, now and then.
Bytes malformed(const Target& target, Random& random);

/// The same, of this length at least [bytes].
Bytes malformed_and_long(const Target& target, std::size_t size);

}  // namespace scrubjay::ros
