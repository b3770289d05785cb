/// \file
/// Random commands and sensor values in range, the same for a seed on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <type_traits>
#include <vector>

namespace scrubjay::oi {

/// SplitMix64 (Steele, Lea, Flood, *Fast Splittable Pseudorandom Number Generators*, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9U;
    z = (z ^ z >> 27) * 0x94D049BB133111EBU;
    return z ^ z >> 31;
  }
  /// From `min` to `max`, both included.
  int between(int min, int max) {
    return min + static_cast<int>(next() % static_cast<std::uint64_t>(std::int64_t{max} - min + 1));
  }

 private:
  std::uint64_t state_;
};

/// Each packet of the model at a value in its accepted range, its ends more often than not.
inline Sensors random_sensors(Random& random, Model model) {
  Sensors sensors;
  for (const PacketInfo& packet : kPackets) {
    if (!packet.exists_on(model)) continue;
    const ValueRange range = accepted_range(packet.id, model);
    const int choice = random.between(0, 4);
    sensors.set(packet.id, choice == 0 ? range.min : choice == 1 ? range.max : random.between(range.min, range.max));
  }
  return sensors;
}

inline SensorId random_id(Random& random, Model model) {
  while (true) {
    if (const auto id = SensorId::of(random.between(0, 255), model)) return *id;
  }
}

/// Fills any part of a command. Lists and ids are those of `model`.
class RandomFill {
 public:
  RandomFill(Random& random, Model model) : random_(random), model_(model) {}

  template <typename T>
  requires std::is_integral_v<T>
  void operator()(T& value) { value = static_cast<T>(random_.next()); }
  template <int Lo, int Hi>
  void operator()(Bounded<Lo, Hi>& value) {
    value = Bounded<Lo, Hi>::clamped(random_.between(Lo - 1, Hi + 1));
  }
  void operator()(Radius& value) {
    const int choice = random_.between(0, 3);
    value = choice == 0   ? Radius::straight()
            : choice == 1 ? Radius::spin_clockwise()
                          : *Radius::of(random_.between(-2000, 2000));
  }
  void operator()(SensorId& value) { value = random_id(random_, model_); }
  template <typename T, std::size_t N>
  void operator()(std::array<T, N>& values) {
    for (T& value : values) (*this)(value);
  }
  template <typename T, std::size_t Min, std::size_t Max>
  void operator()(FixedList<T, Min, Max>& list) {
    std::vector<T> items(static_cast<std::size_t>(random_.between(Min, Max)));
    for (T& item : items) (*this)(item);
    list = *FixedList<T, Min, Max>::of(items);
  }
  template <Fielded T>
  void operator()(T& value) {
    std::apply([&](auto... field) { ((*this)(value.*field), ...); }, T::kFields);
  }

 private:
  Random& random_;
  Model model_;
};

/// Any command that is valid on the model.
inline Command random_command(Random& random, Model model) {
  const auto make = [&]<typename... C>(std::type_identity<std::variant<C...>>) {
    constexpr std::array<Command (*)(), sizeof...(C)> kMake{[]() -> Command { return C{}; }...};
    return kMake[static_cast<std::size_t>(random.between(0, sizeof...(C) - 1))]();
  };
  while (true) {
    Command command = make(std::type_identity<Command>{});
    std::visit(RandomFill(random, model), command);
    if (valid_on(command, model)) return command;
  }
}

}  // namespace scrubjay::oi
