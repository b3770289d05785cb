/// \file
/// A symbol for each part of a mission, as large as the part: docs/firmware.sh reads them with nm.
#include <scrubjay/behavior/edge_follow.hpp>
#include <scrubjay/embedded/embedded_mission.hpp>

namespace scrubjay {

extern const char size_of_OiRobot[sizeof(OiRobot)];
extern const char size_of_Odometry[sizeof(Odometry)];
extern const char size_of_ContactModel[sizeof(ContactModel)];
extern const char size_of_EdgeFollow[sizeof(EdgeFollow)];

const char size_of_OiRobot[sizeof(OiRobot)] = {};
const char size_of_Odometry[sizeof(Odometry)] = {};
const char size_of_ContactModel[sizeof(ContactModel)] = {};
const char size_of_EdgeFollow[sizeof(EdgeFollow)] = {};

}  // namespace scrubjay
