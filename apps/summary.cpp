#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/octomap_file.hpp>

namespace scrubjay::apps {
namespace {

/// What the robot would have gone to, and why it hasn't: the largest first.
void print_leftovers(std::vector<Leftover> left) {
  if (left.empty()) return;
  constexpr std::size_t kShown = 5;
  std::ranges::stable_sort(left, std::ranges::greater{}, &Leftover::size);
  fmt::print("left: {} {}\n", left.size(), left.size() == 1 ? "place" : "places");
  for (std::size_t i = 0; i < std::min(kShown, left.size()); ++i) {
    fmt::print("  ({:.2f}, {:.2f}), {:.2f} m: {}\n", left[i].where.x(), left[i].where.y(), left[i].size, left[i].why);
  }
  if (left.size() > kShown) fmt::print("  and {} more (metrics.json)\n", left.size() - kShown);
}

/// With commas between thousands.
std::string grouped(std::uint64_t number) {
  if (number < 1000) return std::to_string(number);
  return grouped(number / 1000) + fmt::format(",{:03}", number % 1000);
}

void print_figures(const RunResult& run, const OutputFlags& flags) {
  if (flags.json) return fmt::print("{}", metrics_json(run));
  if (flags.quiet) return;
  const Report& report = run.report;
  const bool feels = run.has_bumper || !run.truth;
  fmt::print("{} after {:.0f} s: {:.1f} m driven, {} {}\n", to_string(report.ended), report.time, report.distance,
             feels ? report.bumps : run.truth->contacts, feels ? "bumps" : "contacts");
  if (report.stuck) fmt::print("stuck at ({:.2f}, {:.2f}) in the map\n", report.stuck->x(), report.stuck->y());
  print_leftovers(report.leftovers);
  if (run.truth) {
    const MapScore& score = run.truth->score;
    fmt::print("coverage {:.1f} %, IoU {:.3f}, walls: recall {:.3f}, precision {:.3f}\n", 100.0 * score.coverage,
               score.iou, score.wall_recall, score.wall_precision);
    if (!run.truth->trajectory.empty()) {
      fmt::print("pose error: {:.3f} m RMS, {:.3f} m at the end\n", run.truth->error.ate,
                 run.truth->error.final_distance);
    }
  }
  if (run.link) fmt::print("{}\n", link_line(*run.link));
  if (run.cpu_time > 0.0) {
    fmt::print("{:.0f} times real time ({:.2f} s)\n", report.time / run.cpu_time, run.wall_time);
  }
}

}  // namespace

std::string link_line(const LinkReport& link) {
  std::string line = fmt::format("link: {} frames, {} lost", grouped(link.frames), grouped(link.lost_frames));
  if (link.bad_bytes > 0) line += fmt::format(", {} stray bytes", grouped(link.bad_bytes));
  if (link.silences > 0) {
    line += fmt::format(", {} {} ({:.1f} s silent)", link.reconnections,
                        link.reconnections == 1 ? "reconnection" : "reconnections", link.longest_silence);
  }
  if (link.watchdog_stops > 0) line += fmt::format(", {} stopped by the watchdog", link.watchdog_stops);
  return line;
}

RunFolder prepare_results(const std::filesystem::path& folder, const OctomapFlags& octomap) {
  RunFolder prepared(folder);
  if (octomap.file) AtomicFiles().add(*octomap.file, "");
  return prepared;
}

void deliver(const RunResult& run, const std::filesystem::path& folder, const OctomapFlags& octomap,
             const OutputFlags& flags) {
  try {
    write_run(folder, run);
    if (octomap.file) write_octomap(*octomap.file, run.map, octomap.height);
  } catch (const Error&) {
    print_figures(run, flags);
    throw;
  }
  print_figures(run, flags);
  if (!flags.json && !flags.quiet) fmt::print("picture: {}\n", (folder / "map.png").string());
}

}  // namespace scrubjay::apps
