#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>

namespace scrubjay {
namespace {

/// A mark of the scan's patch: 0, what a miss takes from the cell, or this.
constexpr std::uint8_t kHit = 255;

const LidarModel& lidar_of(const RobotModel& robot) {
  if (!robot.lidar) throw Error("the robot has no lidar to map with; want one in its model");
  return *robot.lidar;
}

const LidarMapperParams& checked(const LidarMapperParams& params, double resolution) {
  const auto want = [](bool right, const char* name, double value, const char* wanted) {
    if (right) return;
    throw Error("lidar mapping's " + std::string(name) + " is " + std::to_string(value) + "; want " + wanted);
  };
  want(resolution > 0.0 && std::isfinite(resolution), "resolution", resolution, "a positive length in metres");
  want(params.hit > 0.5 && params.hit < 1.0, "hit", params.hit, "more than 0.5 and less than 1");
  want(params.miss > 0.0 && params.miss < 0.5, "miss", params.miss, "more than 0 and less than 0.5");
  want(params.hit_depth >= 0.0 && params.hit_depth <= 1.0, "hit_depth", params.hit_depth, "0 to 1 cells");
  want(params.max_range > 0.0, "max_range", params.max_range, "a positive length in metres");
  want(params.forward_cone > 0.0, "forward_cone", params.forward_cone, "a positive angle in radians");
  want(params.robot_radius >= 0.0, "robot_radius", params.robot_radius, "0 or a positive length in metres");
  return params;
}

Error astray(const Pose2& pose) {
  return Error("a lidar can't map from (" + std::to_string(pose.x) + ", " + std::to_string(pose.y) + ", " +
                   std::to_string(pose.yaw) + "): the pose estimate has gone astray",
               Error::Kind::Failure);
}

/// Bounds in cells that a map can have; false for what is no number.
bool within_reach(const Bounds2& bounds) {
  constexpr double kReach = GrowingMap::kReach;
  return bounds.low.x() > -kReach && bounds.low.y() > -kReach && bounds.high.x() < kReach && bounds.high.y() < kReach;
}

/// The cell that holds a point given in cells.
CellIndex cell_of(const Point2& p) {
  return {static_cast<std::int32_t>(std::floor(p.x())), static_cast<std::int32_t>(std::floor(p.y()))};
}

/// The same where no number is negative.
CellIndex cell_in_patch(const Point2& p) {
  return {static_cast<std::int32_t>(p.x()), static_cast<std::int32_t>(p.y())};
}

Point2 point_of(CellIndex c) {
  return {static_cast<double>(c.x), static_cast<double>(c.y)};
}

/// Rows of a scan's patch are whole blocks, so that compilers make vector instructions of them and nothing else.
constexpr std::int32_t kBlock = 16;

/// Takes the misses from a block of cells, but never below -kMaxLogOdds, and clears the marks.
void take_misses(std::uint8_t* marks, LogOdds* cells) {
  std::array<std::uint8_t, kBlock> misses;
  std::array<LogOdds, kBlock> block;
  std::memcpy(misses.data(), marks, kBlock);
  std::memcpy(block.data(), cells, kBlock);
  std::memset(marks, 0, kBlock);
  for (std::size_t i = 0; i < kBlock; ++i) {
    const auto room = static_cast<std::uint8_t>(block[i] + kMaxLogOdds);
    block[i] = static_cast<LogOdds>(block[i] - std::min(misses[i], room));
  }
  std::memcpy(cells, block.data(), kBlock);
}

}  // namespace

LidarMapper::LidarMapper(const RobotModel& robot, double resolution, const LidarMapperParams& params, double reach)
    : params_(checked(params, resolution)),
      hit_(log_odds(params.hit)),
      miss_(static_cast<std::uint8_t>(-log_odds(params.miss))),
      points_(lidar_of(robot), {params.max_range, params.forward_cone, params.hit_depth * resolution}),
      map_(resolution) {
  if (reach > 0.0) map_.cover(Point2(0.0, 0.0), reach);
}

void LidarMapper::update(const Frame& frame, const PoseEstimate& estimate) {
  changed_ = {};
  if (!frame.scan) return;
  const Pose2& pose = estimate.pose;
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.yaw)) throw astray(pose);
  const Bounds2 bounds = place(points_.beams(*frame.scan, frame.stamp, estimate.twist), pose);
  if (bounds.low.x() > bounds.high.x()) return;  // the scan says nothing
  if (!within_reach(bounds)) throw astray(pose);
  make_room(bounds);
  draw(pose);
  add_to_map(bounds);
}

/// What the scan touches, in cells from the map frame's origin.
Bounds2 LidarMapper::place(std::span<const Beam> beams, const Pose2& pose) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds2 bounds{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  const auto include = [&](const Point2& p) {
    bounds.low = bounds.low.cwiseMin(p);
    bounds.high = bounds.high.cwiseMax(p);
  };
  const double per_metre = 1.0 / map_.view().geometry.resolution;
  const Point2 position = per_metre * pose.position();
  if (params_.robot_radius > 0.0) {
    const double radius = per_metre * params_.robot_radius;
    include(position - Point2(radius, radius));
    include(position + Point2(radius, radius));
  }
  const SinCos turn = sin_cos(pose.yaw);
  const double cos = per_metre * turn.cos;
  const double sin = per_metre * turn.sin;
  const auto in_map = [&](const Point2& p) {
    return Point2(position.x() + cos * p.x() - sin * p.y(), position.y() + sin * p.x() + cos * p.y());
  };
  lines_.clear();
  Point2 origin(kInfinity, kInfinity);
  Point2 from = origin;
  for (const Beam& beam : beams) {
    if (beam.origin != origin) {  // once a scan, unless the robot moved during it
      origin = beam.origin;
      from = in_map(origin);
      include(from);
    }
    const Point2 to = in_map(beam.end);
    include(to);
    lines_.push_back({from, to, beam.hit});
  }
  return bounds;
}

void LidarMapper::make_room(const Bounds2& bounds) {
  // The patch lies the same way over the floor whatever the map's corner is, so that what a cell hears doesn't hang on
  // how the map grew. It holds a cell more than the scan touches, as rounding may put a point into the one beside.
  const CellIndex low = cell_of(bounds.low);
  const CellIndex high = cell_of(bounds.high);
  const std::int32_t blocks = (high.x - low.x + 2 + kBlock - 1) / kBlock;
  patch_corner_ = low;
  patch_.resolution = map_.view().geometry.resolution;
  patch_.origin = patch_.resolution * point_of(low);
  patch_.width = blocks * kBlock;
  patch_.height = high.y - low.y + 2;
  map_.cover(CellRect{low, {low.x + patch_.width, low.y + patch_.height}});
  if (marks_.size() < patch_.size()) marks_.resize(patch_.size());
}

void LidarMapper::draw(const Pose2& pose) {
  const GridView<std::uint8_t> marks{patch_, marks_.data()};
  const Point2 corner = point_of(patch_corner_);
  // All walks first: the processor works on many at once, while the end of every line comes as a surprise to it.
  walks_.clear();
  for (const Line& line : lines_) walks_.push_back(line_walk(patch_.width, line.from - corner, line.to - corner));
  for (const LineWalk& walk : walks_) fill_line(walk, marks.cells, miss_);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].hit) marks.cells[walks_[i].end()] = kHit;
  }
  visit_disc(patch_, pose.position(), params_.robot_radius, [&](CellIndex c) {
    const Point2 half(0.5 * patch_.resolution, 0.5 * patch_.resolution);
    const Point2 far_corner = (patch_.center(c) - pose.position()).cwiseAbs() + half;
    if (far_corner.squaredNorm() <= params_.robot_radius * params_.robot_radius) marks[c] = miss_;
  });
}

void LidarMapper::add_to_map(const Bounds2& bounds) {
  const GridView<std::uint8_t> marks{patch_, marks_.data()};
  const GridView<LogOdds> cells = map_.view();
  const Point2 corner = point_of(patch_corner_);
  const CellIndex shift{patch_corner_.x - map_.corner().x, patch_corner_.y - map_.corner().y};
  for (const Line& line : lines_) {
    if (!line.hit) continue;
    const CellIndex end = cell_in_patch(line.to - corner);
    if (marks[end] != kHit) continue;
    update_cell(cells[{end.x + shift.x, end.y + shift.y}], hit_);
    marks[end] = 0;
  }
  const CellIndex last = cell_in_patch(bounds.high - corner);
  for (std::int32_t y = 0; y <= last.y; ++y) {
    std::uint8_t* row = &marks[{0, y}];
    LogOdds* map_row = &cells[{shift.x, y + shift.y}];
    for (std::int32_t x = 0; x <= last.x; x += kBlock) take_misses(row + x, map_row + x);
  }
  changed_ = {shift, {last.x + shift.x + 1, last.y + shift.y + 1}};
}

}  // namespace scrubjay
