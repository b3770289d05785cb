/// \file
/// nav_msgs and map_msgs, as far as we use them.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>

namespace scrubjay::ros {

struct MapMetaData {
  static constexpr std::string_view kType = "nav_msgs/msg/MapMetaData";
  static constexpr std::string_view kHash = "RIHS01_2772d4b2000ef2b35dbaeb80fd3946c1369f817fb4f75677d916d27c17d763c8";
  Time map_load_time;
  float resolution = 0.0F;   ///< [m] a cell
  std::uint32_t width = 0;   ///< [cells]
  std::uint32_t height = 0;  ///< [cells]
  Pose origin;               ///< of the lowest left cell's corner

  static constexpr auto fields() {
    return std::tuple(field("map_load_time", &MapMetaData::map_load_time),
                      field("resolution", &MapMetaData::resolution), field("width", &MapMetaData::width),
                      field("height", &MapMetaData::height), field("origin", &MapMetaData::origin));
  }
  bool operator==(const MapMetaData&) const = default;
};

struct OccupancyGrid {
  static constexpr std::string_view kType = "nav_msgs/msg/OccupancyGrid";
  static constexpr std::string_view kHash = "RIHS01_8d348150c12913a31ee0ec170fbf25089e4745d17035792a1ba94d6f0bc0cfc7";
  Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;  ///< row-major from the lowest left cell; -1 unknown, 0 free to 100 occupied

  static constexpr auto fields() {
    return std::tuple(field("header", &OccupancyGrid::header), field("info", &OccupancyGrid::info),
                      field("data", &OccupancyGrid::data));
  }
  bool operator==(const OccupancyGrid&) const = default;
};

/// Pose in header.frame_id, twist in child_frame_id.
struct Odometry {
  static constexpr std::string_view kType = "nav_msgs/msg/Odometry";
  static constexpr std::string_view kHash = "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0";
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;

  static constexpr auto fields() {
    return std::tuple(field("header", &Odometry::header), field("child_frame_id", &Odometry::child_frame_id),
                      field("pose", &Odometry::pose), field("twist", &Odometry::twist));
  }
  bool operator==(const Odometry&) const = default;
};

struct Path {
  static constexpr std::string_view kType = "nav_msgs/msg/Path";
  static constexpr std::string_view kHash = "RIHS01_1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b";
  Header header;
  std::vector<PoseStamped> poses;

  static constexpr auto fields() { return std::tuple(field("header", &Path::header), field("poses", &Path::poses)); }
  bool operator==(const Path&) const = default;
};

/// A rectangle of the map that was published before.
struct OccupancyGridUpdate {
  static constexpr std::string_view kType = "map_msgs/msg/OccupancyGridUpdate";
  static constexpr std::string_view kHash = "RIHS01_c4095b0be2e4363f8978a1570e0293ee093436f1e1c61d99b48502ac317025e8";
  Header header;
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::int8_t> data;

  static constexpr auto fields() {
    return std::tuple(field("header", &OccupancyGridUpdate::header), field("x", &OccupancyGridUpdate::x),
                      field("y", &OccupancyGridUpdate::y), field("width", &OccupancyGridUpdate::width),
                      field("height", &OccupancyGridUpdate::height), field("data", &OccupancyGridUpdate::data));
  }
  bool operator==(const OccupancyGridUpdate&) const = default;
};

}  // namespace scrubjay::ros
