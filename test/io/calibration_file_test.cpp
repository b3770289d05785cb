#include <gmock/gmock.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/io/calibration_file.hpp>

#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kLeast = "model: create-1\nleft: 1.01\nright: 0.99\naxle: 1.1\n";

std::string calibration_error(const std::string& text) {
  return message_of([&] { parse_calibration(text, "c.yaml"); });
}

CalibrationRecord any_record(Random& random) {
  const auto factor = [&] { return random.uniform(0.5, 2.0); };
  CalibrationRecord record{"my \"own\".urdf", {factor(), factor(), factor()}};
  if (random.below(2) == 0) record.deviation = {random.uniform(), random.uniform(), random.uniform()};
  if (random.below(2) == 0) record.date = "2026-03-31";
  for (std::uint32_t i = random.below(6); i > 0; --i) {
    CalibrationDrive drive{static_cast<CalibrationFigure>(random.below(4))};
    for (std::size_t k = 0; k < number_count(drive.figure); ++k) {
      drive.measured.push_back(random.uniform(-70.0, 70.0));
      drive.residual.push_back(random.uniform(-0.01, 0.01));
    }
    record.drives.push_back(drive);
  }
  return record;
}

TEST(CalibrationFileTest, ReadsWhatItWrites) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const CalibrationRecord record = any_record(random);
    EXPECT_EQ(parse_calibration(calibration_text(record), "c.yaml"), record) << calibration_text(record);
  }
}

TEST(CalibrationFileTest, ModelAndFactorsAreEnough) {
  const CalibrationRecord expected{"create-1", {1.01, 0.99, 1.1}};
  EXPECT_EQ(parse_calibration(kLeast, "c.yaml"), expected);
}

TEST(CalibrationFileTest, ReadsAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_calibration(folder.write("c.yaml", kLeast)).calibration, (Calibration{1.01, 0.99, 1.1}));
  EXPECT_THAT(message_of([&] { read_calibration(folder / "absent.yaml"); }), HasSubstr("absent.yaml"));
}

TEST(CalibrationFileTest, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(calibration_error("model: a\nleft: 1\nright: 1\n"), HasSubstr("c.yaml:1: axle is missing"));
  EXPECT_THAT(calibration_error("left: 1\nright: 1\naxle: 1\n"), HasSubstr("model is missing"));
  EXPECT_THAT(calibration_error("model: a\nleft: 0\nright: 1\naxle: 1\n"),
              HasSubstr("c.yaml:2: left is 0; want a factor from 0.5 to 2"));
  EXPECT_THAT(calibration_error(kLeast + "date: today\n"),
              HasSubstr("c.yaml:5: date is today; want a date as 2026-03-31"));
  EXPECT_THAT(calibration_error(kLeast + "deviation: {left: 0.1, right: -1, axle: 0}\n"),
              HasSubstr("deviation.right is -1"));
  EXPECT_THAT(calibration_error(kLeast + "deviation: 0.1\n"), HasSubstr("deviation"));
  EXPECT_THAT(calibration_error(kLeast + "axis: 1\n"), AllOf(HasSubstr("'axis'"), HasSubstr("did you mean 'axle'?")));
  EXPECT_THAT(calibration_error(kLeast + "drives: [{figure: circle, measured: [1], residual: [1]}]\n"),
              HasSubstr("drives[0].figure is circle; want spin, straight, square-left or square-right"));
  EXPECT_THAT(calibration_error(kLeast + "drives: [{figure: square-left, measured: [1], residual: [1]}]\n"),
              HasSubstr("drives[0].measured is a list of 1; want [x, y] in metres"));
  EXPECT_THAT(calibration_error(kLeast + "drives: [{figure: spin, measured: [1]}]\n"),
              HasSubstr("residual is missing"));
  EXPECT_THAT(calibration_error("- 1\n"), HasSubstr("c.yaml:1"));
}

}  // namespace
}  // namespace scrubjay
