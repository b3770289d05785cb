#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/error.hpp>
#include <scrubjay/io/calibration_file.hpp>

#include "factors.hpp"
#include "file_content.hpp"
#include "yaml_field.hpp"

namespace scrubjay {
namespace {

constexpr double kLargest = 1e4;  // of what can be measured [m, rad]

CalibrationDrive read_drive(const YamlField& field) {
  field.expect_keys({"figure", "measured", "residual"});
  CalibrationDrive drive;
  const YamlField figure = field.at("figure");
  try {
    drive.figure = figure_of(figure.text());
  } catch (const Error&) {
    figure.fail("spin, straight, square-left or square-right");
  }
  const std::size_t count = number_count(drive.figure);
  const std::string_view wanted = count == 2 ? "[x, y] in metres" : "[distance in metres, or turn in radians]";
  const NumberRange range{-kLargest, kLargest};
  drive.measured = field.at("measured").numbers(count, range, wanted);
  drive.residual = field.at("residual").numbers(count, range, wanted);
  return drive;
}

Calibration read_deviation(const YamlField& field) {
  field.expect_keys({"left", "right", "axle"});
  const NumberRange range{0.0, 1.0, false, "a standard deviation from 0 to 1"};
  return {field.at("left").number(range), field.at("right").number(range), field.at("axle").number(range)};
}

}  // namespace

bool is_date(const std::string& text) {
  constexpr std::string_view kForm = "dddd-dd-dd";
  const auto fits = [](char c, char form) { return form == 'd' ? c >= '0' && c <= '9' : c == form; };
  return std::equal(text.begin(), text.end(), kForm.begin(), kForm.end(), fits);
}

std::string calibration_text(const CalibrationRecord& record) {
  const auto& [left, right, axle] = record.calibration;
  std::string text = "# Made by scrubjay calibrate: what wheels and axle really are, as shares of the model's.\n";
  text += fmt::format("model: {}\n", quoted(record.model));
  text += fmt::format("left: {}\nright: {}\naxle: {}\n", left, right, axle);
  if (record.deviation) {
    const Calibration& d = *record.deviation;
    text += fmt::format("deviation: {{left: {}, right: {}, axle: {}}}\n", d.left, d.right, d.axle);
  }
  if (!record.date.empty()) text += fmt::format("date: {}\n", record.date);
  if (!record.drives.empty()) text += "drives:\n";
  for (const CalibrationDrive& drive : record.drives) {
    text += fmt::format("  - {{figure: {}, measured: [{}], residual: [{}]}}\n", to_string(drive.figure),
                        fmt::join(drive.measured, ", "), fmt::join(drive.residual, ", "));
  }
  return text;
}

CalibrationRecord parse_calibration(const std::string& text, const std::string& file) {
  const YamlField root = YamlField::parse(text, file);
  root.expect_keys({"model", "left", "right", "axle", "deviation", "date", "drives"});
  CalibrationRecord record;
  record.model = root.at("model").text();
  record.calibration = read_factors(root);
  if (root.has("deviation")) record.deviation = read_deviation(root.at("deviation"));
  if (root.has("date")) {
    record.date = root.at("date").text();
    if (!is_date(record.date)) root.at("date").fail("a date as 2026-03-31");
  }
  for (const YamlField& drive : root.items_of("drives")) record.drives.push_back(read_drive(drive));
  return record;
}

CalibrationRecord read_calibration(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> file = read_file(path);
  return parse_calibration(std::string(file.begin(), file.end()), path.string());
}

}  // namespace scrubjay
