/// \file
/// visualization_msgs, as far as we use them.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/messages/sensor_msgs.hpp>

namespace scrubjay::ros {

struct UVCoordinate {
  static constexpr std::string_view kType = "visualization_msgs/msg/UVCoordinate";
  static constexpr std::string_view kHash = "RIHS01_f27f7ed21fe360c6066944f856b801a0c0d1e94e815b6886444b42d90b196a26";
  float u = 0.0F;
  float v = 0.0F;

  static constexpr auto fields() { return std::tuple(field("u", &UVCoordinate::u), field("v", &UVCoordinate::v)); }
  bool operator==(const UVCoordinate&) const = default;
};

struct MeshFile {
  static constexpr std::string_view kType = "visualization_msgs/msg/MeshFile";
  static constexpr std::string_view kHash = "RIHS01_7710ece15a148fb7c9b546364cfb215bb06098087bd6394fe5b73a493508f8c4";
  std::string filename;
  std::vector<std::uint8_t> data;

  static constexpr auto fields() {
    return std::tuple(field("filename", &MeshFile::filename), field("data", &MeshFile::data));
  }
  bool operator==(const MeshFile&) const = default;
};

struct Marker {
  static constexpr std::int32_t kPoints = 8;  // of `type`
  static constexpr std::int32_t kTextViewFacing = 9;
  static constexpr std::int32_t kTriangleList = 11;
  static constexpr std::int32_t kAdd = 0;  // of `action`
  static constexpr std::int32_t kDelete = 2;
  static constexpr std::int32_t kDeleteAll = 3;
  static constexpr std::string_view kType = "visualization_msgs/msg/Marker";
  static constexpr std::string_view kHash = "RIHS01_45b13ccf791f225962bf74e746f9644518855d783a6f42ba0cc14fde2b4f3ce0";
  Header header;
  std::string ns;
  std::int32_t id = 0;
  std::int32_t type = 0;
  std::int32_t action = 0;
  Pose pose;
  Vector3 scale;
  ColorRGBA color;
  Duration lifetime;  ///< 0: for ever
  bool frame_locked = false;
  std::vector<Point> points;
  std::vector<ColorRGBA> colors;  ///< of the points, or none
  std::string texture_resource;
  CompressedImage texture;
  std::vector<UVCoordinate> uv_coordinates;
  std::string text;
  std::string mesh_resource;
  MeshFile mesh_file;
  bool mesh_use_embedded_materials = false;

  static constexpr auto fields() {
    return std::tuple(field("header", &Marker::header), field("ns", &Marker::ns), field("id", &Marker::id),
                      field("type", &Marker::type), field("action", &Marker::action), field("pose", &Marker::pose),
                      field("scale", &Marker::scale), field("color", &Marker::color),
                      field("lifetime", &Marker::lifetime), field("frame_locked", &Marker::frame_locked),
                      field("points", &Marker::points), field("colors", &Marker::colors),
                      field("texture_resource", &Marker::texture_resource), field("texture", &Marker::texture),
                      field("uv_coordinates", &Marker::uv_coordinates), field("text", &Marker::text),
                      field("mesh_resource", &Marker::mesh_resource), field("mesh_file", &Marker::mesh_file),
                      field("mesh_use_embedded_materials", &Marker::mesh_use_embedded_materials));
  }
  static constexpr auto constants() {
    return std::array{Constant{"int32", "ARROW", 0},
                      Constant{"int32", "CUBE", 1},
                      Constant{"int32", "SPHERE", 2},
                      Constant{"int32", "CYLINDER", 3},
                      Constant{"int32", "LINE_STRIP", 4},
                      Constant{"int32", "LINE_LIST", 5},
                      Constant{"int32", "CUBE_LIST", 6},
                      Constant{"int32", "SPHERE_LIST", 7},
                      Constant{"int32", "POINTS", 8},
                      Constant{"int32", "TEXT_VIEW_FACING", 9},
                      Constant{"int32", "MESH_RESOURCE", 10},
                      Constant{"int32", "TRIANGLE_LIST", 11},
                      Constant{"int32", "ADD", 0},
                      Constant{"int32", "MODIFY", 0},
                      Constant{"int32", "DELETE", 2},
                      Constant{"int32", "DELETEALL", 3}};
  }
  bool operator==(const Marker&) const = default;
};

struct MarkerArray {
  static constexpr std::string_view kType = "visualization_msgs/msg/MarkerArray";
  static constexpr std::string_view kHash = "RIHS01_86cb8800b6fb05b5eff1abd7a56f62a5641d3ae9a1c29e78e67e704f1d067dcf";
  std::vector<Marker> markers;

  static constexpr auto fields() { return std::tuple(field("markers", &MarkerArray::markers)); }
  bool operator==(const MarkerArray&) const = default;
};

}  // namespace scrubjay::ros
