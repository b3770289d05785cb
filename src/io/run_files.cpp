#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/map_picture.hpp>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/io/run_folder.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/trajectory_file.hpp>

namespace scrubjay {
namespace {

using Json = nlohmann::ordered_json;

/// Micrometres and microseconds are enough for people, and keep the files readable.
double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

Json pose_json(const Pose2& pose) {
  return {{"x", rounded(pose.x)}, {"y", rounded(pose.y)}, {"theta", rounded(pose.yaw)}};
}

Json leftovers_json(const std::vector<Leftover>& leftovers) {
  Json list = Json::array();
  for (const Leftover& left : leftovers) {
    list.push_back({{"x", rounded(left.where.x())},
                    {"y", rounded(left.where.y())},
                    {"size_m", rounded(left.size)},
                    {"why", left.why}});
  }
  return list;
}

Json statistics_json(const ErrorStatistics& error) {
  return {{"mean", rounded(error.mean)}, {"std", rounded(error.deviation)}, {"max", rounded(error.max)}};
}

void add_reference(Json& json, const LogReference& reference) {
  json["ate_m"] = rounded(reference.error.ate);
  json["final_error_m"] = rounded(reference.error.final_distance);
  json["final_heading_error_rad"] = rounded(reference.error.final_heading);
  if (const auto& error = reference.relations) {
    json["relations"] = {{"relations", error->relations},
                         {"matched", error->matched},
                         {"clock_offset_s", rounded(error->offset)},
                         {"translation_m", statistics_json(error->translation)},
                         {"translation_squared_m2", statistics_json(error->translation_squared)},
                         {"rotation_rad", statistics_json(error->rotation)},
                         {"rotation_squared_rad2", statistics_json(error->rotation_squared)}};
  }
  json["log"] = reference.log;
  json["poses"] = reference.poses;
}

Json link_json(const LinkReport& link) {
  return {{"frames", link.frames},
          {"lost_frames", link.lost_frames},
          {"bad_bytes", link.bad_bytes},
          {"silences", link.silences},
          {"reconnections", link.reconnections},
          {"longest_silence_s", rounded(link.longest_silence)},
          {"watchdog_stops", link.watchdog_stops}};
}

std::string title_of(const RunResult& run) {
  if (run.reference) return fmt::format("{}, {}", run.reference->log, run.reference->poses);
  const std::string world = std::filesystem::path(run.scenario.world).stem().string();
  return world.empty() ? run.scenario.strategy : fmt::format("{}, {}", world, run.scenario.strategy);
}

std::string timing_json(const RunResult& run) {
  const double time = run.report.time;
  const Json json{{"wall_time_s", rounded(run.wall_time)},
                  {"cpu_time_s", rounded(run.cpu_time)},
                  {"times_real_time", run.cpu_time > 0.0 ? rounded(time / run.cpu_time) : 0.0}};
  return json.dump(2) + "\n";
}

Image picture_of(const RunResult& run) {
  MapPicture picture;
  picture.map = run.map.view();
  for (const StampedPose& point : run.trajectory) picture.trajectory.push_back(point.pose);
  picture.robot = run.report.pose;
  picture.robot_radius = run.robot_radius;
  picture.start = Pose2{};
  for (const Pose2& bump : run.bumps) picture.bumps.push_back(bump * Point2(run.robot_radius, 0.0));
  if (run.report.stuck) picture.stuck.push_back(*run.report.stuck);
  for (const Leftover& left : run.report.leftovers) picture.left.push_back(left.where);
  if (run.truth) {
    picture.true_walls = run.truth->walls;
    picture.dock = run.truth->dock;
  }
  picture.title = title_of(run);
  return draw_map(picture);
}

}  // namespace

std::string metrics_json(const RunResult& run) {
  Json json;
  if (run.truth) json["start"] = pose_json(run.truth->start);
  json["ended"] = to_string(run.report.ended);
  json["simulated_time_s"] = rounded(run.report.time);
  json["distance_m"] = rounded(run.report.distance);
  json["bumps"] = run.report.bumps;
  if (run.truth && !run.truth->trajectory.empty()) json["contacts"] = run.truth->contacts;
  json["pose"] = pose_json(run.report.pose);
  if (run.report.stuck) json["stuck"] = {{"x", rounded(run.report.stuck->x())}, {"y", rounded(run.report.stuck->y())}};
  json["left"] = leftovers_json(run.report.leftovers);
  if (run.truth) {
    const MapScore& score = run.truth->score;
    json["coverage"] = rounded(score.coverage);
    json["iou"] = rounded(score.iou);
    json["wall_precision"] = rounded(score.wall_precision);
    json["wall_recall"] = rounded(score.wall_recall);
    json["followed_wall_precision"] = rounded(score.followed_wall_precision);
    json["followed_wall_recall"] = rounded(score.followed_wall_recall);
    if (!run.truth->trajectory.empty()) {
      json["ate_m"] = rounded(run.truth->error.ate);
      json["final_error_m"] = rounded(run.truth->error.final_distance);
      json["final_heading_error_rad"] = rounded(run.truth->error.final_heading);
    }
  }
  if (run.reference) {
    add_reference(json, *run.reference);
    return json.dump(2) + "\n";
  }
  if (run.link) json["link"] = link_json(*run.link);
  json["strategy"] = run.scenario.strategy;
  json["localizer"] = run.scenario.localizer;
  json["model"] = run.scenario.model;
  json["noise"] = run.scenario.noise;
  json["seed"] = run.scenario.seed;
  return json.dump(2) + "\n";
}

void write_run(const std::filesystem::path& folder, const RunResult& run) {
  const RunFolder prepared(folder);
  AtomicFiles files;
  add_map(files, folder / "map", run.map.view());
  const std::vector<std::uint8_t> png = encode_png(picture_of(run));
  files.add(folder / "map.png", std::as_bytes(std::span(png)));
  files.add(folder / "trajectory.tum", trajectory_text(run.trajectory));
  if (run.truth && !run.truth->trajectory.empty()) {
    files.add(folder / "ground_truth.tum", trajectory_text(run.truth->trajectory));
  }
  if (run.reference) {
    files.add(folder / "reference.tum", trajectory_text(run.reference->trajectory));
  } else {
    files.add(folder / "scenario.yaml", scenario_text(run.scenario));
  }
  files.add(folder / "timing.json", timing_json(run));
  files.add(folder / "metrics.json", metrics_json(run));
  files.commit();
}

std::vector<Segment2> walls_in_map(const World& world, const Pose2& start) {
  const Pose2 map_from_world = inverse(start);
  std::vector<Segment2> walls;
  for (const SolidSegment& solid : solid_segments(world)) {
    walls.push_back({map_from_world * solid.segment.a, map_from_world * solid.segment.b});
  }
  return walls;
}

}  // namespace scrubjay
