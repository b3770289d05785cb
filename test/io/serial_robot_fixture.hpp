/// \file
/// A robot on a serial port, found and driven.
#pragma once

#include <gtest/gtest.h>

#include <scrubjay/io/serial_robot.hpp>

#include "fake_robot.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {

class SerialRobotTest : public testing::Test {
 protected:
  SerialAddress address(int baud = 115200) const { return {folder_ / "port", baud}; }
  std::filesystem::path port() const { return folder_ / "port"; }

  /// Drives on for so many frames; says how far the left wheel rolled by them.
  static double drive(SerialRobot& robot, int frames, double speed = 0.2) {
    double way = 0.0;
    for (int i = 0; i < frames; ++i) {
      const auto frame = robot.next();
      if (!frame) break;
      way += frame->left_travel;
      robot.drive({speed, 0.0});
    }
    return way;
  }

  TemporaryFolder folder_;
  std::stop_source stop_;
  SerialRobotParams params_{.connect_timeout = 2.0,
                            .renewal = 0.2,
                            .first_retry = 0.02,
                            .longest_retry = 0.1,
                            .give_up = 60.0,
                            .session = OiRobot::Session::Drive,
                            .body = nullptr};
};

}  // namespace scrubjay
