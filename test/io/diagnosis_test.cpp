#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <io/examined_roomba.hpp>
#include <scrubjay/io/diagnosis.hpp>
#include <scrubjay/simulation/wire_faults.hpp>

namespace scrubjay {
namespace {

using oi::PacketId;

/// What a well robot on a good wire reports.
const DoctorReport& good_report() {
  static const DoctorReport report = [] {
    test::ExaminedRoomba robot;
    Examination examination(robot.roomba, robot.clock());
    examination.find_robot();
    examination.time_replies(20);
    examination.listen(1.0);
    return examination.report();
  }();
  return report;
}

/// A packet that said the same all the time.
void say(DoctorReport& report, PacketId id, std::int32_t value) {
  report.sensors.set(id, value);
  report.history[number(id)] = {value, value, value, value};
}

TEST(DiagnosisTest, FindsNothingWrongWithAWellRobot) {
  for (const oi::Model model : {oi::Model::Create2, oi::Model::Create1, oi::Model::Roomba400}) {
    test::ExaminedRoomba robot(model);
    Examination examination(robot.roomba, robot.clock());
    examination.find_robot();
    examination.time_replies(20);
    examination.listen(1.0);
    EXPECT_THAT(diagnose(examination.report()), testing::IsEmpty()) << static_cast<int>(model);
  }
}

/// One thing that is wrong, and a word of the finding that says so.
struct Illness {
  const char* name;
  const char* word;
  std::function<void(DoctorReport&)> fall_ill;
};

class IllnessTest : public testing::TestWithParam<Illness> {};

TEST_P(IllnessTest, IsFoundAloneWithSomethingToTry) {
  DoctorReport report = good_report();
  GetParam().fall_ill(report);
  const std::vector<Finding> findings = diagnose(report);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, Finding::Kind::Problem);
  EXPECT_THAT(findings[0].what, testing::HasSubstr(GetParam().word));
  EXPECT_NE(findings[0].advice, "");
  EXPECT_FALSE(healthy(findings));
}

INSTANTIATE_TEST_SUITE_P(
    Each, IllnessTest,
    testing::Values(
        Illness{"Silent", "Nobody", [](DoctorReport& r) { r.contact = Contact::Silent; }},
        Illness{"Foreign", "Somebody", [](DoctorReport& r) { r.contact = Contact::Foreign; }},
        Illness{"LinkLost", "went away", [](DoctorReport& r) { r.link_lost = true; }},
        Illness{"NoFrames", "no frames", [](DoctorReport& r) { r.frames = {}; }},
        Illness{"MissingFrames", "missing", [](DoctorReport& r) { r.frames.missing = r.frames.frames / 20; }},
        Illness{"Silence", "silent", [](DoctorReport& r) { r.frames.longest_gap = 0.2; }},
        Illness{"BadValues", "out of range", [](DoctorReport& r) { r.frames.bad_values = 3; }},
        Illness{"Unanswered", "no answer", [](DoctorReport& r) { r.replies.answered -= 2; }},
        Illness{"SlowAnswers", "35 ms", [](DoctorReport& r) { r.replies.p95 = 0.035; }},
        Illness{"EmptyBattery", "nearly empty", [](DoctorReport& r) { say(r, PacketId::BatteryCharge, 200); }},
        Illness{"WornBattery", "0.5 Ah", [](DoctorReport& r) { say(r, PacketId::BatteryCapacity, 500); }},
        Illness{"NoCapacity", "0.0 Ah", [](DoctorReport& r) { say(r, PacketId::BatteryCapacity, 0); }},
        Illness{"LowVoltage", "11.9 V", [](DoctorReport& r) { say(r, PacketId::Voltage, 11'900); }},
        Illness{"HotBattery", "hot", [](DoctorReport& r) { say(r, PacketId::Temperature, 60); }},
        Illness{"ChargingFault", "charge", [](DoctorReport& r) { say(r, PacketId::ChargingState, 5); }},
        Illness{"OpenCliff", "front right", [](DoctorReport& r) { say(r, PacketId::CliffFrontRight, 1); }},
        Illness{"DarkCliff", "left", [](DoctorReport& r) { say(r, PacketId::CliffLeftSignal, 3); }},
        Illness{"StuckBumper", "on the left", [](DoctorReport& r) { say(r, PacketId::BumpsAndWheelDrops, 2); }},
        Illness{"HangingWheel", "wheel", [](DoctorReport& r) { say(r, PacketId::BumpsAndWheelDrops, 8); }},
        Illness{"StuckButton", "button", [](DoctorReport& r) { say(r, PacketId::Buttons, 1); }},
        Illness{"Overcurrent", "right wheel", [](DoctorReport& r) { say(r, PacketId::WheelOvercurrents, 8); }}),
    [](const testing::TestParamInfo<Illness>& illness) { return illness.param.name; });

TEST(DiagnosisTest, ABumpInPassingIsNoIllness) {
  DoctorReport report = good_report();
  report.history[number(PacketId::BumpsAndWheelDrops)] = {0, 3, 0, 3};
  EXPECT_TRUE(healthy(diagnose(report)));
}

TEST(DiagnosisTest, AnEmptyBatteryThatIsBeingChargedIsNoIllness) {
  DoctorReport report = good_report();
  say(report, PacketId::BatteryCharge, 200);
  say(report, PacketId::ChargingState, 2);
  EXPECT_TRUE(healthy(diagnose(report)));
}

TEST(DiagnosisTest, QuirksAreRemarksBehindTheProblems) {
  DoctorReport report = good_report();
  report.quirks.mode_one_too_high = true;
  EXPECT_TRUE(healthy(diagnose(report)));
  EXPECT_EQ(diagnose(report).size(), 1U);
  say(report, PacketId::Temperature, 60);
  const std::vector<Finding> findings = diagnose(report);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].kind, Finding::Kind::Problem);
  EXPECT_EQ(findings[1].kind, Finding::Kind::Remark);
}

TEST(DiagnosisTest, SaysWhatTheHandsDidNotFind) {
  HandCheck hands(oi::Model::Create2);
  hands.skip();
  const std::vector<Finding> findings = diagnose(good_report(), &hands);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].what, testing::HasSubstr("left bumper"));
}

TEST(DiagnosisTest, AWireThatSpoilsFramesIsFoundOut) {
  test::ExaminedRoomba robot;
  sim::WireFaults faults;
  faults.flip = 0.001;
  sim::FaultyChannel wire(robot.roomba, faults, Random(3));
  Examination examination(wire, robot.clock());
  ASSERT_EQ(examination.find_robot(), Contact::Robot);
  examination.listen(10.0);
  const std::vector<Finding> findings = diagnose(examination.report());
  ASSERT_FALSE(findings.empty());
  EXPECT_THAT(findings[0].what, testing::HasSubstr("missing"));
  EXPECT_THAT(findings[0].advice, testing::HasSubstr("cable"));
}

}  // namespace
}  // namespace scrubjay
