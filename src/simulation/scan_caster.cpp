#include <algorithm>
#include <cmath>
#include <scrubjay/simulation/scan_caster.hpp>

namespace scrubjay::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kCrowd = 2000;  // segments near the sensor (test/bench/lidar_bench)

constexpr double kRoughness = 1e-4;  // more than two rough bearings are off by [rad]

/// atan2 to within 2e-5 rad, without a branch: enough to find the beams that may meet a segment; the ray test decides.
/// Abramowitz and Stegun, *Handbook of Mathematical Functions*, 4.4.47.
double rough_bearing(double x, double y) {
  const double across = std::fabs(x);
  const double up = std::fabs(y);
  const double z = std::min(across, up) / (std::max(across, up) + 1e-300);
  const double zz = z * z;
  double angle = z * (0.9998660 + zz * (-0.3302995 + zz * (0.1801410 + zz * (-0.0851330 + zz * 0.0208351))));
  angle = up > across ? 0.5 * kPi - angle : angle;
  angle = x < 0.0 ? kPi - angle : angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace

ScanCaster::ScanCaster(const SegmentIndex& index, const LidarModel& lidar)
    : index_(&index), lidar_(lidar), beams_per_turn_(2.0 * kPi / lidar.angle_increment) {
  const auto count = static_cast<std::size_t>(lidar.beams);
  for (std::size_t i = 0; i < count; ++i) {
    beams_.push_back(direction(lidar.angle_min + static_cast<double>(i) * lidar.angle_increment));
  }
  direction_x_.resize(count);
  direction_y_.resize(count);
  ranges_.resize(count);
}

std::span<const double> ScanCaster::cast(const Pose2& sensor) {
  look_around(sensor.position());
  turn_beams(sensor.yaw);
  if (pieces_.size() > kCrowd) return cast_singly(sensor.position());
  view_pieces(sensor.position());
  std::fill(ranges_.begin(), ranges_.end(), std::nextafter(lidar_.max_range, kInfinity));
  const double squared_range = lidar_.max_range * lidar_.max_range * (1.0 + 1e-9);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (views_[i].squared_distance <= squared_range) draw(pieces_[i], views_[i], sensor);
  }
  for (double& range : ranges_) {
    if (range > lidar_.max_range) range = kInfinity;
  }
  return ranges_;
}

/// Among very many segments a ray that ends at the first one is faster than looking at each of them.
std::span<const double> ScanCaster::cast_singly(const Point2& origin) {
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    ranges_[i] = index_->cast(origin, {direction_x_[i], direction_y_[i]}, lidar_.max_range).range;
  }
  return ranges_;
}

void ScanCaster::look_around(const Point2& origin) {
  if (fresh_ && (origin - center_).squaredNorm() <= kMargin * kMargin) return;
  fresh_ = true;
  center_ = origin;
  index_->within(origin, lidar_.max_range + kMargin, found_);
  pieces_.clear();
  for (const std::uint32_t id : found_) {
    const Segment2& segment = index_->segments()[id].segment;
    const Point2 along = segment.b - segment.a;
    pieces_.push_back({segment.a.x(), segment.a.y(), along.x(), along.y()});
  }
  views_.resize(pieces_.size());
}

void ScanCaster::turn_beams(double yaw) {
  const SinCos turn = sin_cos(yaw);
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    direction_x_[i] = turn.cos * beams_[i].x() - turn.sin * beams_[i].y();
    direction_y_[i] = turn.sin * beams_[i].x() + turn.cos * beams_[i].y();
  }
}

void ScanCaster::view_pieces(const Point2& origin) {
  const double ox = origin.x();
  const double oy = origin.y();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    const double ax = piece.ax - ox;
    const double ay = piece.ay - oy;
    const double squared_length = piece.dx * piece.dx + piece.dy * piece.dy;
    const double share = std::clamp(-(ax * piece.dx + ay * piece.dy) / (squared_length + 1e-300), 0.0, 1.0);
    const double near_x = ax + share * piece.dx;
    const double near_y = ay + share * piece.dy;
    views_[i] = {near_x * near_x + near_y * near_y, rough_bearing(ax, ay), rough_bearing(ax + piece.dx, ay + piece.dy)};
  }
}

/// Calls `draw_beams(begin, end)` for the beams that point between two bearings in the world, counter-clockwise.
template <typename DrawBeams>
void ScanCaster::for_beams(double from, double to, double yaw, const DrawBeams& draw_beams) const {
  const double per_beam = 1.0 / lidar_.angle_increment;
  const double turn = beams_per_turn_;
  const double count = static_cast<double>(ranges_.size());
  double first = (from - yaw - lidar_.angle_min) * per_beam;
  double last = (to - yaw - lidar_.angle_min) * per_beam;
  if (last < first) last += turn;
  const double turns = std::floor(first / turn) * turn;
  const double spare = 1.0 + kRoughness * per_beam;
  first -= turns + spare;
  last -= turns - spare;
  const auto draw_part = [&](double shift) {
    const auto begin = static_cast<std::size_t>(std::clamp(first + shift, 0.0, count));
    const auto end = static_cast<std::size_t>(std::clamp(last + shift + 1.0, 0.0, count));
    draw_beams(begin, end);
  };
  draw_part(0.0);
  if (last >= turn) draw_part(-turn);
  if (first < 0.0) draw_part(turn);
}

/// ray_hit() of segment2.hpp for all beams that may meet the piece. Seen from the sensor the piece runs one way round,
/// counter-clockwise or not; the signs are turned so that it is always the former.
void ScanCaster::draw(const Piece& piece, const View& view, const Pose2& sensor) {
  const double to_a_x = piece.ax - sensor.x;
  const double to_a_y = piece.ay - sensor.y;
  const double cross = to_a_x * piece.dy - to_a_y * piece.dx;
  if (cross == 0.0) return draw_edge_on(piece, view, sensor);
  const double sign = cross > 0.0 ? 1.0 : -1.0;
  const double ahead = sign * cross;
  const double to_x = sign * to_a_x;
  const double to_y = sign * to_a_y;
  const double along_x = sign * piece.dx;
  const double along_y = sign * piece.dy;
  const double* const dx = direction_x_.data();
  const double* const dy = direction_y_.data();
  double* const ranges = ranges_.data();
  for_beams(cross > 0.0 ? view.from : view.to, cross > 0.0 ? view.to : view.from, sensor.yaw,
            [=](std::size_t begin, std::size_t end) {
              // No branches, so that the compiler takes several beams at once.
              for (std::size_t i = begin; i < end; ++i) {
                const double facing = dx[i] * along_y - dy[i] * along_x;
                const double offset = to_x * dy[i] - to_y * dx[i];
                double range = ahead / facing;
                range = facing > 0.0 ? range : kInfinity;
                range = offset >= 0.0 ? range : kInfinity;
                range = offset <= facing ? range : kInfinity;
                ranges[i] = range < ranges[i] ? range : ranges[i];
              }
            });
}

/// The sensor stands in line with the piece: only a beam that runs along it can meet it; every beam does where the
/// sensor stands on it.
void ScanCaster::draw_edge_on(const Piece& piece, const View& view, const Pose2& sensor) {
  const Segment2 segment{{piece.ax, piece.ay}, {piece.ax + piece.dx, piece.ay + piece.dy}};
  const auto draw_beams = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point2 along(direction_x_[i], direction_y_[i]);
      ranges_[i] = std::min(ranges_[i], ray_hit(segment, sensor.position(), along));
    }
  };
  if (view.squared_distance < 1e-12) {
    draw_beams(0, ranges_.size());
  } else {
    for_beams(view.from, view.from, sensor.yaw, draw_beams);
  }
}

}  // namespace scrubjay::sim
