/// \file
/// What files call the dialects of the Open Interface.
#pragma once

#include <array>
#include <scrubjay/oi/model.hpp>
#include <string_view>
#include <utility>

namespace scrubjay {

inline constexpr std::array<std::pair<std::string_view, oi::Model>, 3> kDialectNames{
    {{"create-2", oi::Model::Create2}, {"create-1", oi::Model::Create1}, {"roomba-400", oi::Model::Roomba400}}};

}  // namespace scrubjay
