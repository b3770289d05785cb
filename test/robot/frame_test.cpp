#include <gtest/gtest.h>

#include <scrubjay/robot/frame.hpp>

namespace scrubjay {
namespace {

TEST(FrameTest, IsBumpedOnEitherSide) {
  EXPECT_FALSE(Frame{}.bumped());
  for (bool Frame::*half : {&Frame::bump_left, &Frame::bump_right}) {
    Frame frame;
    frame.*half = true;
    EXPECT_TRUE(frame.bumped());
    EXPECT_FALSE(frame.wheel_dropped());
  }
}

TEST(FrameTest, HangsOnEitherWheel) {
  EXPECT_FALSE(Frame{}.wheel_dropped());
  for (bool Frame::*wheel : {&Frame::wheel_drop_left, &Frame::wheel_drop_right}) {
    Frame frame;
    frame.*wheel = true;
    EXPECT_TRUE(frame.wheel_dropped());
    EXPECT_FALSE(frame.bumped());
  }
}

TEST(FrameTest, LightSensorsAreTheBitsFromLeftToRight) {
  Frame frame;
  frame.light_flags = 0b100010;
  EXPECT_FALSE(frame.sees(LightSensor::Left));
  EXPECT_TRUE(frame.sees(LightSensor::FrontLeft));
  EXPECT_FALSE(frame.sees(LightSensor::FrontRight));
  EXPECT_TRUE(frame.sees(LightSensor::Right));
}

}  // namespace
}  // namespace scrubjay
