/// \file
/// The families of robots that speak the Open Interface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace scrubjay::oi {

/// A dialect of the Open Interface.
enum class Model : std::uint8_t {
  Create2,    ///< Roomba 500, 600 and Create 2: packets 7 to 58, stream
  Create1,    ///< iRobot Create: packets 7 to 42, stream, scripts
  Roomba400,  ///< the Serial Command Interface: packets 7 to 26, no stream
};

inline constexpr std::size_t kModelCount = 3;

/// The order in which to ask a robot for its dialect: whoever answers to a richer one may answer to the others as well.
inline constexpr std::array<Model, kModelCount> kRichestFirst{Model::Create2, Model::Create1, Model::Roomba400};

/// Some of the models.
class ModelSet {
 public:
  constexpr ModelSet() = default;
  constexpr ModelSet(Model model) : bits_(static_cast<std::uint8_t>(1U << static_cast<unsigned>(model))) {}
  constexpr bool contains(Model model) const { return (bits_ & ModelSet(model).bits_) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  friend constexpr ModelSet operator|(ModelSet a, ModelSet b) {
    ModelSet both;
    both.bits_ = a.bits_ | b.bits_;
    return both;
  }
  bool operator==(const ModelSet&) const = default;

 private:
  std::uint8_t bits_ = 0;
};

constexpr ModelSet operator|(Model a, Model b) {
  return ModelSet(a) | ModelSet(b);
}

inline constexpr ModelSet kAllModels = Model::Create2 | Model::Create1 | ModelSet(Model::Roomba400);

}  // namespace scrubjay::oi
