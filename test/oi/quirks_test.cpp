#include <gtest/gtest.h>

#include <scrubjay/oi/quirks.hpp>

namespace scrubjay::oi {
namespace {

TEST(ReleaseTest, IsReadFromTheBootBanner) {
  EXPECT_EQ(parse_release("bl-start\r\n2007-05-22-1715-L\r\nr3_robot/tags/release-3.5.2:6058 CLEAN\r\nbattery"),
            (Release{3, 5, 2}));
  EXPECT_EQ(parse_release("r3_robot/tags/release-stm32-3.7.5:11220 CLEAN"), (Release{3, 7, 5}));
  EXPECT_EQ(parse_release("release-3.10.12"), (Release{3, 10, 12}));
}

TEST(ReleaseTest, IsNotReadWhereThereIsNone) {
  EXPECT_FALSE(parse_release(""));
  EXPECT_FALSE(parse_release("r3_robot/tags/release-"));
  EXPECT_FALSE(parse_release("release-3.5"));
  EXPECT_FALSE(parse_release("release-3.5."));
  EXPECT_FALSE(parse_release("release-99999999999.1.1"));
  EXPECT_FALSE(parse_release("3.5.2"));
  EXPECT_FALSE(parse_release("release-x battery-3.5.2"));
}

TEST(ReleaseTest, ABrokenMarkDoesntHideALaterOne) {
  EXPECT_EQ(parse_release("release- release-3.4.1:1"), (Release{3, 4, 1}));
}

TEST(ReleaseTest, ComparesByNumbers) {
  EXPECT_LT((Release{3, 4, 0}), (Release{3, 4, 1}));
  EXPECT_LT((Release{3, 9, 9}), (Release{3, 10, 0}));
  EXPECT_LT((Release{2, 9, 9}), (Release{3, 0, 0}));
}

TEST(QuirksTest, AnglesAreDividedUpToRelease340) {
  EXPECT_DOUBLE_EQ(quirks_of({3, 4, 0}).angle_divisor, 0.324056);
  EXPECT_DOUBLE_EQ(quirks_of({3, 4, 1}).angle_divisor, 1.0);
  EXPECT_NEAR(corrected_angle(29, quirks_of({3, 4, 0})), 89.4907, 1e-4);
  EXPECT_DOUBLE_EQ(corrected_angle(-29, quirks_of({3, 5, 2})), -29.0);
}

TEST(QuirksTest, DistanceAndRadiusAreWrongBeforeRelease330) {
  EXPECT_TRUE(quirks_of({3, 2, 9}).distance_wrong);
  EXPECT_TRUE(quirks_of({3, 2, 9}).requested_radius_wrong);
  EXPECT_FALSE(quirks_of({3, 3, 0}).distance_wrong);
  EXPECT_FALSE(quirks_of({3, 3, 0}).requested_radius_wrong);
}

TEST(QuirksTest, ModesOneTooHighAreCorrected) {
  FirmwareQuirks quirks;
  EXPECT_EQ(corrected_mode(3, quirks), OiMode::Full);
  EXPECT_EQ(corrected_mode(4, quirks), std::nullopt);
  quirks.mode_one_too_high = true;
  EXPECT_EQ(corrected_mode(4, quirks), OiMode::Full);
  EXPECT_EQ(corrected_mode(2, quirks), OiMode::Passive);
  EXPECT_EQ(corrected_mode(0, quirks), std::nullopt);
}

TEST(QuirksTest, AModeThatIsOneTooHighShowsWhereTheModeIsKnown) {
  EXPECT_TRUE(is_one_too_high(2, OiMode::Passive));
  EXPECT_FALSE(is_one_too_high(1, OiMode::Passive));
  EXPECT_FALSE(is_one_too_high(3, OiMode::Passive));
}

TEST(QuirksTest, SwappedEncodersAreSwappedBack) {
  FirmwareQuirks quirks;
  EXPECT_EQ(corrected_encoders(1, 2, quirks), (EncoderCounts{1, 2}));
  quirks.swapped_encoders = true;
  EXPECT_EQ(corrected_encoders(1, 2, quirks), (EncoderCounts{2, 1}));
}

TEST(EncoderTest, CountsForwardThroughTheEndOfEitherRange) {
  EXPECT_EQ(encoder_difference(-32768, 32767), 1);
  EXPECT_EQ(encoder_difference(0, 65535), 1);
  EXPECT_EQ(encoder_difference(5, 65530), 11);
}

TEST(EncoderTest, CountsBackwardsThroughZero) {
  EXPECT_EQ(encoder_difference(65535, 0), -1);
  EXPECT_EQ(encoder_difference(32767, -32768), -1);
  EXPECT_EQ(encoder_difference(-3, 2), -5);
}

TEST(EncoderTest, SignedAndUnsignedReadingsAgree) {
  for (int before = 0; before < 65536; before += 257) {
    for (const int travel : {-32768, -500, -1, 0, 1, 500, 32767}) {
      const int now = before + travel;
      EXPECT_EQ(encoder_difference(static_cast<std::uint16_t>(now), before), travel);
      EXPECT_EQ(encoder_difference(static_cast<std::int16_t>(now), static_cast<std::int16_t>(before)), travel);
    }
  }
}

TEST(SafetyTest, WheelDropAndChargerEndSafeMode) {
  EXPECT_EQ(mode_after_safety(OiMode::Safe, {}), OiMode::Safe);
  EXPECT_EQ(mode_after_safety(OiMode::Safe, {.wheel_drop = true}), OiMode::Passive);
  EXPECT_EQ(mode_after_safety(OiMode::Safe, {.charger = true}), OiMode::Passive);
}

TEST(SafetyTest, CliffsEndSafeModeWhileDrivingTowardsThem) {
  const auto after = [](int right, int left) {
    return mode_after_safety(OiMode::Safe, {.cliff = true, .right_velocity = right, .left_velocity = left});
  };
  EXPECT_EQ(after(200, 200), OiMode::Passive);
  EXPECT_EQ(after(200, -199), OiMode::Passive);
  EXPECT_EQ(after(0, 0), OiMode::Safe);
  EXPECT_EQ(after(200, -200), OiMode::Safe);
  EXPECT_EQ(after(-200, -200), OiMode::Safe);
  // Backward: on one wheel the radius is 117.5 mm; at 100 to 400 mm/s it is 195.8 mm.
  EXPECT_EQ(after(-200, 0), OiMode::Passive);
  EXPECT_EQ(after(0, -200), OiMode::Passive);
  EXPECT_EQ(after(-400, -100), OiMode::Safe);
}

TEST(SafetyTest, OtherModesStay) {
  const SafetyInputs all{.wheel_drop = true, .cliff = true, .charger = true, .right_velocity = 1, .left_velocity = 1};
  for (const OiMode mode : {OiMode::Off, OiMode::Passive, OiMode::Full}) EXPECT_EQ(mode_after_safety(mode, all), mode);
}

}  // namespace
}  // namespace scrubjay::oi
