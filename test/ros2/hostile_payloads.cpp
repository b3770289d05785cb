#include "ros2/hostile_payloads.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "ros2/commands_fixture.hpp"

namespace scrubjay::ros {
namespace {

using Encapsulation = std::array<std::uint8_t, 2>;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kWithoutEnd = std::numeric_limits<double>::infinity();
constexpr std::array kNoWishes{kNoNumber, kWithoutEnd, -kWithoutEnd, 1e300, -1e6};

constexpr Encapsulation kBigEndian{0, 0};
/// Parameter lists, all of XCDR2, and what the specification doesn't have.
constexpr std::array<Encapsulation, 12> kStrange{
    {{0, 2}, {0, 3}, {0, 4}, {0, 5}, {0, 6}, {0, 7}, {0, 8}, {0, 9}, {0, 10}, {0, 11}, {1, 1}, {255, 255}}};
constexpr std::array<std::uint32_t, 5> kEndless{0xffff'ffff, 0x8000'0000, 0x7fff'ffff, 0x2000'0000, 0x000f'ffff};

/// Where a text's length is that follows a stamp, as in every header.
constexpr std::size_t kFrameLength = 12;

template <class List>
const auto& one_of(const List& list, Random& random) {
  return list[random.below(static_cast<std::uint32_t>(list.size()))];
}

Bytes noise(std::size_t size, Random& random) {
  Bytes bytes(size);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
  return bytes;
}

Bytes encapsulated(Bytes message, const Encapsulation& id) {
  for (std::size_t i = 0; i < std::min(message.size(), id.size()); ++i) message[i] = static_cast<std::byte>(id[i]);
  return message;
}

Bytes with_length(Bytes message, std::size_t offset, std::uint32_t length) {
  std::memcpy(message.data() + offset, &length, sizeof length);
  return message;
}

template <class M>
Target target(const char* topic, const Bytes& sound) {
  return {topic, kTypeOf<M>, sound, sound.size()};
}

/// Whole messages in which one number of `part`, all of doubles, is none that could be wished for.
template <class M, class Part>
void add_no_wishes(std::vector<Bytes>& absurd, const M& sound, Part M::*part, std::span<const double> no_wishes) {
  static_assert(sizeof(Part) % sizeof(double) == 0);
  for (std::size_t offset = 0; offset < sizeof(Part); offset += sizeof(double)) {
    for (const double bad : no_wishes) {
      M message = sound;
      std::memcpy(reinterpret_cast<char*>(&(message.*part)) + offset, &bad, sizeof bad);
      absurd.push_back(encode(message));
    }
  }
}

std::vector<Target> velocities() {
  Target plain = target<Twist>("cmd_vel", twist(0.2, 0.3));
  add_no_wishes(plain.absurd, Twist{}, &Twist::linear, kNoWishes);
  add_no_wishes(plain.absurd, Twist{}, &Twist::angular, kNoWishes);
  // Fast enough as it is, and no number in the other order of bytes.
  plain.absurd.push_back(encapsulated(twist(std::bit_cast<double>(0x3fc0'0000'0000'f87fU), 0.0), kBigEndian));
  Target stamped = target<TwistStamped>("cmd_vel", twist_stamped(0.2, 0.3));
  TwistStamped message;
  message.header.frame_id = "base_link";
  add_no_wishes(stamped.absurd, message, &TwistStamped::twist, kNoWishes);
  stamped.lengths = {kFrameLength};
  stamped.text_ends = {kFrameLength + 4 + std::strlen("base_link")};
  return {plain, stamped};
}

std::vector<Target> poses() {
  const Pose sound = pose_at(1.0, 2.0, quaternion(0.5));
  Target to = target<PoseStamped>("goal_pose", goal(sound));
  PoseStamped goal_message;
  goal_message.header.frame_id = "map";
  add_no_wishes(to.absurd, goal_message, &PoseStamped::pose, kNoWishes);
  Target at = target<PoseWithCovarianceStamped>("initialpose", initial_pose(sound));
  PoseWithCovarianceStamped place;
  place.header.frame_id = "map";
  add_no_wishes(at.absurd, place, &PoseWithCovarianceStamped::pose, std::array{kNoNumber, kWithoutEnd});
  for (const char* frame : {"odom", "base_link", "", "mapmapmap"}) {
    to.absurd.push_back(goal(sound, frame));
    at.absurd.push_back(initial_pose(sound, frame));
  }
  for (Target* target : {&to, &at}) {
    target->absurd.push_back(encapsulated(target->sound, kBigEndian));
    target->lengths = {kFrameLength};
    target->text_ends = {kFrameLength + 4 + std::strlen("map")};
  }
  return {to, at};
}

std::vector<Target> songs() {
  Target define = target<DefineSong>("define_song", song(1, 2, {60, 62}, {0.5F, 0.25F}));
  define.lengths = {8, 16};
  define.absurd = {song(16, 1, {60}, {0.5F}), song(0, 0, {60}, {0.5F}), song(0, 3, {60, 60}, {0.5F, 0.5F}),
                   song(0, 255, std::vector<std::uint8_t>(255, 60), std::vector<float>(255, 0.5F)),
                   encapsulated(define.sound, kBigEndian)};
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), 1e30F, -1.0F, 4.0F}) {
    define.absurd.push_back(song(0, 1, {60}, {bad}));
  }
  Target play = target<PlaySong>("play_song", encode(PlaySong{1}));
  for (std::uint8_t i = 255; i > 15; --i) play.absurd.push_back(encode(PlaySong{i}));
  return {define, play};
}

std::vector<Target> lights() {
  std::vector<Target> all;
  for (const char* topic : {"debris_led", "spot_led", "dock_led", "check_led"}) {
    Target led = target<Bool>(topic, encode(Bool{true}));
    for (int i = 2; i < 256; ++i) led.absurd.push_back({led.sound[0], led.sound[1], {}, {}, static_cast<std::byte>(i)});
    all.push_back(led);
  }
  Target power = target<UInt8MultiArray>("power_led", octets({128, 255}));
  power.absurd = {octets({})};
  Target digits = target<UInt8MultiArray>("set_ascii", octets({'a', 'b', 'c', 'd'}));
  digits.absurd = {octets({}), octets({31}), octets({'a', 127}), octets({255}), octets({'1', '2', '3', '4', '5'})};
  for (Target* target : {&power, &digits}) {
    target->absurd.push_back(encapsulated(target->sound, kBigEndian));
    target->lengths = {4, 12};
    all.push_back(*target);
  }
  return all;
}

/// What is said by coming alone: the encapsulation is all that there needs to be.
std::vector<Target> signals() {
  std::vector<Target> all{target<Empty>("dock", encode(Empty{})), target<Empty>("undock", encode(Empty{}))};
  for (Target& target : all) target.least = 4;
  return all;
}

}  // namespace

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const auto& some : {velocities(), poses(), songs(), lights(), signals()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

Bytes malformed(const Target& target, Random& random) {
  Bytes message = target.sound;
  switch (random.below(6)) {
    case 0:
      // To a word that is before its last: RTPS fills up the last one, with zeros.
      message.resize(random.below(static_cast<std::uint32_t>((target.least - 1) / 4 * 4 + 1)));
      return message;
    case 1:
      return encapsulated(noise(2 + random.below(400), random), one_of(kStrange, random));
    case 2:
      if (target.lengths.empty()) break;
      return with_length(std::move(message), one_of(target.lengths, random), one_of(kEndless, random));
    case 3:
      if (target.text_ends.empty()) break;
      message[one_of(target.text_ends, random)] = static_cast<std::byte>(1 + random.below(255));
      return message;
    case 4:
      if (target.absurd.empty()) break;
      return one_of(target.absurd, random);
    default:
      break;
  }
  return encapsulated(std::move(message), one_of(kStrange, random));
}

Bytes malformed_and_long(const Target& target, std::size_t size) {
  Bytes message = target.sound;
  message.resize(size, std::byte{'x'});
  if (target.lengths.empty()) return encapsulated(std::move(message), kStrange[0]);
  return with_length(std::move(message), target.lengths.back(), kEndless[0]);
}

}  // namespace scrubjay::ros
