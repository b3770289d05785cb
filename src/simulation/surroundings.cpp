#include "surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <scrubjay/geometry/elementary.hpp>

namespace scrubjay::sim {
namespace {

/// Distance from `p` to the polygon's bounding box, at most: cheap, and never too large.
double distance_to_box(const Polygon& polygon, const Point2& p) {
  Point2 low = polygon.front();
  Point2 high = polygon.front();
  for (const Point2& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return (p - p.cwiseMax(low).cwiseMin(high)).norm();
}

NearSegment near_segment(const Segment2& segment, double albedo) {
  const Point2 along = segment.b - segment.a;
  const double length = along.norm();
  const Point2 normal = length > 0.0 ? Point2(-along.y() / length, along.x() / length) : Point2(1.0, 0.0);
  return {segment, normal, albedo, {0.0, 0.0}, 0.0};
}

/// Corners of a polygon around the unit circle.
const Polygon kOutline = [] {
  constexpr int kSides = 32;
  return disc({0.0, 0.0}, 1.0 / sin_cos(0.5 * kPi - kPi / kSides).sin, kSides);
}();

}  // namespace

Surroundings::Surroundings(const World& world, const SegmentIndex& index, std::vector<double> albedo, double reach)
    : world_(&world), index_(&index), albedo_(std::move(albedo)), reach_(reach) {}

void Surroundings::move_to(const Point2& robot) {
  if (!fresh_ || (robot - center_).squaredNorm() > kMargin * kMargin) refresh(robot);
  add_others(robot);
  double nearest = reach_ * reach_;
  for (NearSegment& near : near_) {
    near.nearest = nearest_point(near.segment, robot);
    const double squared = (near.nearest - robot).squaredNorm();
    near.distance = std::sqrt(squared);
    nearest = std::min(nearest, squared);
  }
  clearance_ = std::sqrt(nearest);
}

void Surroundings::place_others(std::span<const Disc> others, const Point2& robot) {
  others_.assign(others.begin(), others.end());
  move_to(robot);
}

void Surroundings::add_others(const Point2& robot) {
  near_.resize(world_segments_);
  for (const Disc& other : others_) {
    const double far = reach_ + other.radius;
    if ((other.center - robot).squaredNorm() > far * far) continue;
    // Around the disc, not within: whoever touches it is felt to.
    Point2 from = other.center + kOutline.back() * other.radius;
    for (const Point2& corner : kOutline) {
      const Point2 to = other.center + corner * other.radius;
      near_.push_back(near_segment({from, to}, 1.0));
      from = to;
    }
  }
}

void Surroundings::refresh(const Point2& robot) {
  fresh_ = true;
  center_ = robot;
  const double radius = reach_ + kMargin;
  index_->within(robot, radius, found_);
  near_.clear();
  for (const std::uint32_t id : found_) {
    const SolidSegment& solid = index_->segments()[id];
    near_.push_back(near_segment(solid.segment, albedo_[solid.piece]));
  }
  world_segments_ = near_.size();
  near_cliffs_.clear();
  for (const Polygon& cliff : world_->cliffs) {
    if (distance_to_box(cliff, robot) <= radius) near_cliffs_.push_back(&cliff);
  }
  near_carpets_.clear();
  for (const Carpet& carpet : world_->carpets) {
    if (distance_to_box(carpet.outline, robot) <= radius) near_carpets_.push_back(&carpet);
  }
  near_dirt_.clear();
  for (const DirtSpot& spot : world_->dirt) {
    if ((spot.center - robot).norm() <= radius + spot.radius) near_dirt_.push_back(&spot);
  }
}

bool Surroundings::over_cliff(const Point2& p) const {
  return std::any_of(near_cliffs_.begin(), near_cliffs_.end(),
                     [&](const Polygon* cliff) { return contains(*cliff, p); });
}

double Surroundings::carpet_slip(const Point2& p) const {
  double slip = 0.0;
  for (const Carpet* carpet : near_carpets_) {
    if (contains(carpet->outline, p)) slip = std::max(slip, carpet->slip);
  }
  return slip;
}

std::uint8_t Surroundings::dirt(const Point2& p) const {
  std::uint8_t level = 0;
  for (const DirtSpot* spot : near_dirt_) {
    if ((spot->center - p).squaredNorm() <= spot->radius * spot->radius) level = std::max(level, spot->level);
  }
  return level;
}

}  // namespace scrubjay::sim
