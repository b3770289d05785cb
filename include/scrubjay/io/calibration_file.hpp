/// \file
/// Calibrations as YAML.
#pragma once

#include <filesystem>
#include <optional>
#include <scrubjay/mission/calibration_session.hpp>
#include <scrubjay/odometry/calibration.hpp>
#include <string>
#include <vector>

namespace scrubjay {

/// A calibration, of what robot it is, and how it came about.
struct CalibrationRecord {
  std::string model;  ///< a known robot, or the path of a URDF file
  Calibration calibration;
  std::optional<Calibration> deviation{};  ///< standard deviation of each factor
  std::string date{};                      ///< YYYY-MM-DD, or empty
  std::vector<CalibrationDrive> drives{};

  bool operator==(const CalibrationRecord&) const = default;
};

/// Whether `text` looks as YYYY-MM-DD does.
bool is_date(const std::string& text);

/// For write_file_atomically(). Numbers read back the same.
std::string calibration_text(const CalibrationRecord& record);
/// `file` stands in the errors: Error with line and field. The model and the three factors must be there.
CalibrationRecord parse_calibration(const std::string& text, const std::string& file);
CalibrationRecord read_calibration(const std::filesystem::path& path);

}  // namespace scrubjay
