/// \file
/// The doctor's check of bumpers and wheels by the user's hands.
#pragma once

#include <scrubjay/io/examination.hpp>
#include <scrubjay/io/hand_check.hpp>
#include <stop_token>

namespace scrubjay::apps {

/// Asks on stderr for one thing after the other, with all sensors live beside it where that is a terminal; Enter passes
/// over a step, where stdin is one.
HandCheck check_by_hand(Examination& examination, const std::stop_token& stop);

}  // namespace scrubjay::apps
