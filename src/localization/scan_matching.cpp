#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/localization/scan_matching.hpp>

namespace scrubjay {
namespace {

constexpr double kWindowSigmas = 3.0;     // standard deviations of odometry that the search goes
constexpr double kLeastIncrement = 1e-4;  // no lidar has beams nearer to each other; a message may say 0 [rad]

const LidarModel& lidar_of(const RobotModel& robot) {
  if (!robot.lidar) throw Error("scan matching wants a robot with a lidar; this one has none");
  return *robot.lidar;
}

}  // namespace

ScanMatching::ScanMatching(const RobotModel& robot, const Mapper& mapper, const ScanMatchingParams& params)
    : mapper_(mapper),
      params_(params),
      lidar_(lidar_of(robot)),
      odometry_(robot.drive),
      filter_(params.motion),
      scan_points_(lidar_, {params.max_range}),
      search_(params.beam_weight),
      aligner_(params.alignment),
      compass_(params.compass) {}

const PoseEstimate& ScanMatching::update(const Frame& frame) {
  field_.follow(mapper_.map(), mapper_.changed());
  reckon(frame);
  if (frame.scan) match(frame);
  return estimate_;
}

/// The pose by odometry since the last match.
void ScanMatching::reckon(const Frame& frame) {
  const PoseEstimate& odometry = odometry_.update(frame);
  const bool stands = odometry.pose == last_odometry_;
  const Pose2 step = stands ? Pose2{} : inverse(last_odometry_) * odometry.pose;
  last_odometry_ = odometry.pose;
  way_ += std::sqrt(step.position().squaredNorm());
  turn_ += std::fabs(step.yaw);
  filter_.predict(step);
  estimate_ = {filter_.pose(), filter_.covariance(), odometry.twist, odometry.twist_covariance};
}

void ScanMatching::match(const Frame& frame) {
  const bool stands = way_ < params_.min_travel && turn_ < params_.min_turn;
  const bool begins = !started_ || filter_.pose() == Pose2{};
  if (stands && !begins) return;
  take(frame);
  if (ends_.empty()) return;
  head_by_walls();
  if (begins || lay_over_map()) way_ = turn_ = 0.0;
  started_ = true;
  remember();
}

/// The ends of the frame's scan, and the walls that they are of.
void ScanMatching::take(const Frame& frame) {
  ends_.clear();
  const double increment = std::max(std::fabs(frame.scan->angle_increment), kLeastIncrement);
  for (const Beam& beam : scan_points_.beams(*frame.scan, frame.stamp, estimate_.twist)) {
    if (!beam.hit) continue;
    const Point2 back = beam.origin - beam.end;
    const double range = std::sqrt(back.squaredNorm());
    ends_.push_back(
        {beam.end, back / range, lidar_.noise + lidar_.noise_per_range * range, increment * range, Point2(0.0, 0.0)});
  }
  find_straight_walls(ends_, walls_);
  for (const StraightWall& wall : walls_) {
    if (wall.angle_variance > params_.wall_angle * params_.wall_angle) continue;
    for (ScanEnd& end : std::span(ends_).subspan(wall.first, wall.count)) {
      end.normal = {-wall.along.y(), wall.along.x()};
    }
  }
  search_ends_.clear();
  const std::size_t stride = std::max<std::size_t>(1, ends_.size() / static_cast<std::size_t>(params_.search_beams));
  for (std::size_t i = 0; i < ends_.size(); i += stride) search_ends_.push_back(ends_[i].point);
}

/// Where it hasn't moved yet, the heading is certain, and tells how the house stands.
void ScanMatching::head_by_walls() {
  const std::optional<HeadingError> error = compass_.read(walls_, filter_.pose().yaw);
  if (!error || filter_.pose() == Pose2{}) return;
  filter_.correct_heading(error->off, error->information);
  estimate_.pose = filter_.pose();
  estimate_.covariance = filter_.covariance();
}

/// True if the scan told where the robot is.
bool ScanMatching::lay_over_map() {
  const GridView<const LogOdds> map = mapper_.map();
  if (map.geometry.size() == 0) return false;
  const int known = count_known(map);
  const auto is_match = [&](const ScanAlignment& found) {
    return found.support >= params_.min_support && found.support >= params_.min_share * known;
  };
  ScanAlignment aligned = match_from(filter_);
  if (aligned.support < params_.doubtful_share * known) {
    // Wheels slip at times by far more than they ever do otherwise.
    PoseFilter slipped = filter_;
    slipped.slip(Eigen::Vector3d(params_.window, params_.window, params_.window_angle) / kWindowSigmas);
    const ScanAlignment elsewhere = match_from(slipped);
    const double enough = std::max(params_.slip_gain * aligned.support, aligned.support + params_.slip_support);
    if (elsewhere.support > enough && is_match(elsewhere)) {
      aligned = elsewhere;
      filter_ = slipped;
    }
  }
  if (!is_match(aligned)) return false;
  filter_.correct(aligned.pose, aligned.information);
  estimate_.pose = filter_.pose();
  estimate_.covariance = filter_.covariance();
  return true;
}

/// Matches the scan near a guess.
ScanAlignment ScanMatching::match_from(const PoseFilter& guess) {
  const PosePrior prior{guess.pose(), guess.information()};
  const Eigen::Vector3d variance = guess.covariance().diagonal();
  const double reach = kWindowSigmas * std::sqrt(std::max(variance.x(), variance.y()));
  const double reach_angle = kWindowSigmas * std::sqrt(variance.z());
  const SearchWindow window{
      std::max(1, static_cast<std::int32_t>(std::ceil(std::min(reach, params_.window) / field_.geometry().resolution))),
      std::min(reach_angle, params_.window_angle)};
  return aligner_.align(ends_, surfaces_, field_, prior, search_.best(search_ends_, field_, prior, window));
}

/// How many ends of the scan lie, by odometry, where the map knows anything.
int ScanMatching::count_known(GridView<const LogOdds> map) const {
  int known = 0;
  const SinCos heading = sin_cos(estimate_.pose.yaw);
  for (const ScanEnd& end : ends_) {
    const CellIndex c = map.geometry.cell_at(estimate_.pose.position() + turned(heading, end.point));
    known += map.contains(c) && map[c] != 0;
  }
  return known;
}

/// The scan becomes a part of what later ones are laid over.
void ScanMatching::remember() {
  const SinCos heading = sin_cos(estimate_.pose.yaw);
  for (const ScanEnd& end : ends_) {
    surfaces_.add(estimate_.pose.position() + turned(heading, end.point), turned(heading, end.view),
                  params_.alignment.blur + end.noise, field_);
  }
}

}  // namespace scrubjay
