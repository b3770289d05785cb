/// \file
/// Others in the domain beside a run of ours: what fits, what doesn't, and what to do about it.
#pragma once

#include <cstdint>
#include <scrubjay/finding.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::ros {

/// What a type's hash says of its definition.
enum class HashState : std::uint8_t {
  Same,     ///< as ours
  Other,    ///< its messages are made of other members than ours: what arrives is read wrongly, or not at all
  NotTold,  ///< as by Humble, and by what is no ROS
  Unknown,  ///< a type that we don't speak
};

/// What becomes of an endpoint of others beside ours.
enum class Fit : std::uint8_t {
  Matched,   ///< they hear one another
  Refused,   ///< they would have to do with each other, and don't match
  SameSide,  ///< both write that topic, or both read it
  NotOurs,   ///< a topic that we don't have
};

std::string_view name_of(HashState state);  ///< `same`, `other`, `not told`, `unknown type`
std::string_view name_of(Fit fit);          ///< `matched`, `refused`, `same side`, `not ours`

struct Judgement {
  HashState hash = HashState::NotTold;
  Fit fit = Fit::NotOurs;
  std::string why{};  ///< it is refused, as mismatch() says it

  bool operator==(const Judgement&) const = default;
};

Judgement judge(std::span<const Endpoint> ours, const Endpoint& theirs);

/// Whether it is a part of a service, of which DDS knows two topics.
bool is_of_service(const Endpoint& endpoint);

/// The domain, as a participant saw it that was no node itself.
struct Survey {
  ParticipantOptions settings{};    ///< of the run that others are compared with
  std::vector<Endpoint> ours{};     ///< what it has, or would have
  std::vector<Peer> runs{};         ///< that are there already by its name, with helpers of theirs
  std::vector<Peer> others{};       ///< everybody else
  std::uint64_t strange_infos = 0;  ///< as Participant::strange_discovery_infos()
};

/// Parts `peers` into runs of ours and others. What runs have is what others are compared with; where there is none,
/// `planned` is.
Survey survey(ParticipantOptions settings, std::vector<Peer> peers, std::vector<Endpoint> planned,
              std::uint64_t strange_infos);

/// All that isn't as it should be, the worst first. That nobody else is there is a problem, too.
std::vector<Finding> diagnose(const Survey& survey);

}  // namespace scrubjay::ros
