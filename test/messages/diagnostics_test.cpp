#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/messages/diagnostics.hpp>
#include <scrubjay/messages/log_queue.hpp>
#include <thread>

namespace scrubjay::ros {
namespace {

using testing::Contains;
using testing::ElementsAre;

Frame awake() {
  Frame frame;
  frame.mode = oi::OiMode::Safe;
  return frame;
}

Battery full() {
  return {.voltage = 16.0, .current = -0.25, .charge = 2.5, .capacity = 2.6, .temperature = 25.0};
}

TEST(RobotStatusTest, SaysWhatItDoesWhereItCanDoIt) {
  const DiagnosticStatus status = robot_status({}, awake(), "forward");
  EXPECT_EQ(status.level, DiagnosticStatus::kOk);
  EXPECT_EQ(status.message, "forward");
  EXPECT_THAT(status.values,
              ElementsAre(KeyValue{"doing", "forward"}, KeyValue{"mode", "safe"}, KeyValue{"dropped wheels", "none"}));
}

TEST(RobotStatusTest, WarnsWhereItDoesntObey) {
  Frame frame = awake();
  frame.mode = oi::OiMode::Passive;
  EXPECT_EQ(robot_status({}, frame, "").level, DiagnosticStatus::kWarn);
  frame.battery.charging = true;
  EXPECT_EQ(robot_status({}, frame, "").level, DiagnosticStatus::kOk) << "as it should be on its dock";
  frame.mode = oi::OiMode::Off;
  EXPECT_EQ(robot_status({}, frame, "").level, DiagnosticStatus::kWarn);
}

TEST(RobotStatusTest, WarnsOfWheelsThatHangDownAndNamesThem) {
  Frame frame = awake();
  frame.wheel_drop_right = true;
  EXPECT_EQ(robot_status({}, frame, "forward").message, "a wheel has dropped");
  EXPECT_THAT(robot_status({}, frame, "").values, Contains(KeyValue{"dropped wheels", "right"}));
  frame.wheel_drop_left = true;
  EXPECT_THAT(robot_status({}, frame, "").values, Contains(KeyValue{"dropped wheels", "both"}));
}

TEST(RobotStatusTest, SaysNothingOfModesThatALidarRobotHasNot) {
  RobotModel robot;
  robot.open_interface = false;
  const DiagnosticStatus status = robot_status(robot, Frame{}, "looking");
  EXPECT_EQ(status.level, DiagnosticStatus::kOk);
  EXPECT_THAT(status.values, ElementsAre(KeyValue{"doing", "looking"}));
}

TEST(BatteryStatusTest, HasFiguresThatPeopleRead) {
  const DiagnosticStatus status = battery_status(full());
  EXPECT_EQ(status.level, DiagnosticStatus::kOk);
  EXPECT_EQ(status.message, "discharging");
  EXPECT_THAT(status.values, ElementsAre(KeyValue{"charge [%]", "96.2"}, KeyValue{"voltage [V]", "16.00"},
                                         KeyValue{"current [A]", "-0.25"}, KeyValue{"temperature [deg C]", "25"},
                                         KeyValue{"charging", "no"}));
}

TEST(BatteryStatusTest, GrowsWorseAsItEmptiesUnlessItIsCharged) {
  Battery battery = full();
  battery.charge = 0.14 * battery.capacity;
  EXPECT_EQ(battery_status(battery).level, DiagnosticStatus::kWarn);
  EXPECT_EQ(battery_status(battery).message, "low");
  battery.charge = 0.04 * battery.capacity;
  EXPECT_EQ(battery_status(battery).level, DiagnosticStatus::kError);
  battery.charging = true;
  EXPECT_EQ(battery_status(battery).level, DiagnosticStatus::kOk);
  EXPECT_EQ(battery_status(battery).message, "charging");
}

TEST(BatteryStatusTest, HeatIsAWarningAndAFaultOfTheChargerAnError) {
  Battery battery = full();
  battery.temperature = 51.0;
  EXPECT_EQ(battery_status(battery).message, "hot");
  EXPECT_EQ(battery_status(battery).level, DiagnosticStatus::kWarn);
  battery.charger = oi::ChargingState::Fault;
  EXPECT_EQ(battery_status(battery).level, DiagnosticStatus::kError);
  battery.charge = 0.0;
  battery.temperature = 51.0;
  EXPECT_EQ(battery_status(battery).level, DiagnosticStatus::kError);
}

TEST(BatteryStatusTest, OneThatDoesntTellIsNotCalledEmpty) {
  const DiagnosticStatus status = battery_status({});
  EXPECT_EQ(status.level, DiagnosticStatus::kWarn);
  EXPECT_EQ(status.message, "it doesn't tell its charge");
}

TEST(LogQueueTest, GivesEachLineOnceInItsOrder) {
  LogQueue queue;
  queue.add(Log::kInfo, "one");
  queue.add(Log::kWarn, "two");
  EXPECT_THAT(queue.take(), ElementsAre(LogLine{Log::kInfo, "one"}, LogLine{Log::kWarn, "two"}));
  EXPECT_THAT(queue.take(), testing::IsEmpty());
}

TEST(LogQueueTest, LosesTheOldestWhereTooManyWait) {
  LogQueue queue;
  for (std::size_t i = 0; i <= LogQueue::kMost; ++i) queue.add(Log::kInfo, std::to_string(i));
  const auto lines = queue.take();
  EXPECT_EQ(lines.size(), LogQueue::kMost);
  EXPECT_EQ(lines.front().text, "1");
  EXPECT_EQ(lines.back().text, std::to_string(LogQueue::kMost));
}

TEST(LogQueueTest, MayBeFilledFromManyThreads) {
  LogQueue queue;
  std::size_t taken = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        for (int j = 0; j < 200; ++j) queue.add(Log::kInfo, "line");
      });
    }
    for (int i = 0; i < 10; ++i) taken += queue.take().size();
  }
  EXPECT_EQ(taken + queue.take().size(), 800U);
}

}  // namespace
}  // namespace scrubjay::ros
