#include <algorithm>
#include <cmath>
#include <scrubjay/world/relation_error.hpp>
#include <vector>

namespace scrubjay {
namespace {

/// How far a trajectory is from a relation.
struct Deviation {
  double distance = 0.0;  ///< [m]
  double angle = 0.0;     ///< 0 to pi [rad]
};

std::optional<Deviation> deviation(std::span<const StampedPose> trajectory, const Relation& relation, double offset) {
  const auto from = pose_at(trajectory, relation.from - offset);
  if (!from) return std::nullopt;
  const auto to = pose_at(trajectory, relation.to - offset);
  if (!to) return std::nullopt;
  const Pose2 error = inverse(relation.motion) * (inverse(*from) * *to);
  return Deviation{error.position().norm(), std::fabs(error.yaw)};
}

/// Adds up values and their squares, one by one.
class Sums {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
    max_ = std::max(max_, value);
  }
  ErrorStatistics statistics() const {
    if (count_ == 0.0) return {};
    const double mean = sum_ / count_;
    return {mean, std::sqrt(std::max(0.0, squares_ / count_ - mean * mean)), max_};
  }

 private:
  double count_ = 0.0, sum_ = 0.0, squares_ = 0.0, max_ = 0.0;
};

/// Relations that tell one time from another.
std::vector<Relation> telling(std::span<const Relation> relations) {
  constexpr double kShort = 20.0;  // [s]
  constexpr double kMoved = 0.2;   // [m]
  constexpr double kTurned = 0.2;  // [rad]
  std::vector<Relation> found;
  for (const Relation& relation : relations) {
    const bool moves = relation.motion.position().norm() > kMoved || std::fabs(relation.motion.yaw) > kTurned;
    if (moves && std::fabs(relation.to - relation.from) < kShort) found.push_back(relation);
  }
  return found;
}

/// At most `most` of them, evenly spread.
std::vector<Relation> thinned(const std::vector<Relation>& relations, std::size_t most) {
  std::vector<Relation> some;
  const std::size_t step = relations.size() / most + 1;
  for (std::size_t i = 0; i < relations.size(); i += step) some.push_back(relations[i]);
  return some;
}

/// How well an offset fits.
struct Fit {
  double offset = 0.0;
  double score = 0.0;
  std::size_t fitting = 0;
};

Fit fit_of(std::span<const StampedPose> trajectory, std::span<const Relation> relations, double offset) {
  constexpr double kDistance = 0.1;  // [m]
  constexpr double kAngle = 0.1;     // [rad]
  Fit fit{offset, 0.0, 0};
  for (const Relation& relation : relations) {
    const auto error = deviation(trajectory, relation, offset);
    if (!error) continue;
    const double far = error->distance / kDistance;
    const double turned = error->angle / kAngle;
    const double score = 1.0 - far * far - turned * turned;
    if (score <= 0.0) continue;
    fit.score += score;
    ++fit.fitting;
  }
  return fit;
}

/// The best of `count` offsets from `first` on, `step` apart.
Fit best_of(std::span<const StampedPose> trajectory, std::span<const Relation> relations, double first, double step,
            int count) {
  Fit best{first, 0.0, 0};
  for (int i = 0; i < count; ++i) {
    const Fit fit = fit_of(trajectory, relations, first + i * step);
    if (fit.score > best.score) best = fit;
  }
  return best;
}

}  // namespace

std::optional<Pose2> pose_at(std::span<const StampedPose> trajectory, double stamp) {
  const auto after = std::upper_bound(trajectory.begin(), trajectory.end(), stamp,
                                      [](double s, const StampedPose& pose) { return s < pose.stamp; });
  if (after == trajectory.begin()) return std::nullopt;
  const StampedPose& a = *(after - 1);
  if (a.stamp == stamp) return a.pose;
  if (after == trajectory.end()) return std::nullopt;
  const StampedPose& b = *after;
  if (b.stamp - a.stamp > kLongestGap) return std::nullopt;
  const double share = (stamp - a.stamp) / (b.stamp - a.stamp);
  return Pose2{a.pose.x + share * (b.pose.x - a.pose.x), a.pose.y + share * (b.pose.y - a.pose.y),
               wrap_angle(a.pose.yaw + share * angle_difference(b.pose.yaw, a.pose.yaw))};
}

RelationError relation_error(std::span<const StampedPose> trajectory, std::span<const Relation> relations,
                             double offset) {
  RelationError result;
  result.relations = relations.size();
  result.offset = offset;
  Sums distance, distance_squared, angle, angle_squared;
  for (const Relation& relation : relations) {
    const auto error = deviation(trajectory, relation, offset);
    if (!error) continue;
    ++result.matched;
    distance.add(error->distance);
    distance_squared.add(error->distance * error->distance);
    angle.add(error->angle);
    angle_squared.add(error->angle * error->angle);
  }
  result.translation = distance.statistics();
  result.translation_squared = distance_squared.statistics();
  result.rotation = angle.statistics();
  result.rotation_squared = angle_squared.statistics();
  return result;
}

std::optional<double> relation_offset(std::span<const StampedPose> trajectory, std::span<const Relation> relations) {
  const std::vector<Relation> all = telling(relations);
  if (all.empty() || trajectory.empty()) return std::nullopt;
  double first = all.front().from;
  double last = first;
  for (const Relation& relation : all) {
    first = std::min({first, relation.from, relation.to});
    last = std::max({last, relation.from, relation.to});
  }
  // A hundred are enough to find the right second; all of them, to find it to the hundredth.
  constexpr std::size_t kEnough = 100;
  constexpr double kStep = 0.2;  // [s]
  const double least = first - trajectory.back().stamp;
  const double most = last - trajectory.front().stamp;
  const int steps = static_cast<int>(std::min((most - least) / kStep, 1e6)) + 1;
  Fit best = best_of(trajectory, thinned(all, kEnough), least, kStep, steps);
  for (double step = kStep / 10.0; step > 1e-3; step /= 10.0) {
    best = best_of(trajectory, all, best.offset - 20.0 * step, step, 41);
  }
  if (2 * best.fitting < all.size()) return std::nullopt;
  return best.offset;
}

}  // namespace scrubjay
