#include "summary.hpp"

#include <fmt/format.h>

namespace scrubjay::apps {

void print_summary(const RunResult& run, const std::filesystem::path& folder, const OutputFlags& flags) {
  if (flags.json) return fmt::print("{}", metrics_json(run));
  if (flags.quiet) return;
  const Report& report = run.report;
  fmt::print("{} after {:.0f} s: {:.1f} m driven, {} bumps\n", to_string(report.ended), report.time, report.distance,
             report.bumps);
  if (report.stuck) fmt::print("stuck at ({:.2f}, {:.2f}) in the map\n", report.stuck->x(), report.stuck->y());
  if (run.truth) {
    const MapScore& score = run.truth->score;
    fmt::print("coverage {:.1f} %, IoU {:.3f}, walls: recall {:.3f}, precision {:.3f}\n", 100.0 * score.coverage,
               score.iou, score.wall_recall, score.wall_precision);
    if (!run.truth->trajectory.empty()) {
      fmt::print("pose error: {:.3f} m RMS, {:.3f} m at the end\n", run.truth->error.ate,
                 run.truth->error.final_distance);
    }
  }
  if (run.cpu_time > 0.0) {
    fmt::print("{:.0f} times real time ({:.2f} s)\n", report.time / run.cpu_time, run.wall_time);
  }
  fmt::print("picture: {}\n", (folder / "map.png").string());
}

}  // namespace scrubjay::apps
