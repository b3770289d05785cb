// MRPT's occupancy map of the same scans at the same poses, and how far our map agrees with it.
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <bench/logged_scans.hpp>

namespace scrubjay::bench {
namespace {

constexpr float kResolution = 0.05F;
using MrptMap = mrpt::maps::COccupancyGridMap2D;

struct MrptScan {
  mrpt::poses::CPose3D pose;
  mrpt::obs::CObservation2DRangeScan scan;
};

/// Made beforehand, as our own mapper takes ranges as they lie in memory, too.
std::vector<MrptScan> mrpt_scans(const LoggedScans& log) {
  std::vector<MrptScan> scans;
  for (const LoggedScan& logged : log.scans) {
    MrptScan& scan = scans.emplace_back();
    scan.pose = mrpt::poses::CPose3D(mrpt::poses::CPose2D(logged.pose.x, logged.pose.y, logged.pose.yaw));
    scan.scan.aperture = static_cast<float>(kPi);
    scan.scan.maxRange = static_cast<float>(log.robot.lidar->max_range);
    scan.scan.resizeScan(logged.scan.ranges.size());
    for (std::size_t i = 0; i < logged.scan.ranges.size(); ++i) {
      scan.scan.setScanRange(i, logged.scan.ranges[i]);
      scan.scan.setScanRangeValidity(i, logged.scan.returned(logged.scan.ranges[i]));
    }
  }
  return scans;
}

/// Started as small as ours, but for the cells that it wants.
MrptMap mrpt_map(const std::vector<MrptScan>& scans) {
  MrptMap map(-1.0F, 1.0F, -1.0F, 1.0F, kResolution);
  map.insertionOptions.maxDistanceInsertion = 20.0F;
  map.insertionOptions.considerInvalidRangesAsFreeSpace = false;
  for (const MrptScan& scan : scans) map.insertObservation(scan.scan, scan.pose);
  return map;
}

/// nav2's thresholds, on MRPT's probability of being free.
Occupancy trinary(const MrptMap& map, const Point2& p) {
  const double occupied = 1.0 - static_cast<double>(map.getPos(static_cast<float>(p.x()), static_cast<float>(p.y())));
  if (occupied >= 0.65) return kOccupied;
  return occupied <= 0.196 ? kFree : kUnknown;
}

/// Counters: of the cells that both maps know, those on which they agree; of those that are free (occupied) here, those
/// that are so there; and the reverse.
void report_agreement(benchmark::State& state, const OccupancyGrid& ours, const MrptMap& theirs) {
  double free_both = 0.0, occupied_both = 0.0, free_here = 0.0, occupied_here = 0.0;
  for (std::int32_t y = 0; y < ours.geometry.height; ++y) {
    for (std::int32_t x = 0; x < ours.geometry.width; ++x) {
      const Occupancy here = ours.view()[{x, y}];
      const Occupancy there = trinary(theirs, ours.geometry.center({x, y}));
      if (here == kUnknown || there == kUnknown) continue;
      if (here == there) {
        (here == kFree ? free_both : occupied_both) += 1.0;
      } else {
        (here == kFree ? free_here : occupied_here) += 1.0;
      }
    }
  }
  const double known = free_both + occupied_both + free_here + occupied_here;
  state.counters["known_to_both"] = known;
  state.counters["agree"] = (free_both + occupied_both) / known;
  state.counters["agree_free"] = free_both / (free_both + free_here + occupied_here);
  state.counters["agree_occupied"] = occupied_both / (occupied_both + free_here + occupied_here);
}

void MrptMapping(benchmark::State& state, const char* name) {
  const LoggedScans& log = logged_scans(state, name);
  if (log.scans.empty()) return;
  const std::vector<MrptScan> scans = mrpt_scans(log);
  for ([[maybe_unused]] const auto& _ : state) benchmark::DoNotOptimize(mrpt_map(scans).getSizeX());
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * log.beams());
  report_agreement(state, map_of(log).occupancy(), mrpt_map(scans));
}
BENCHMARK_CAPTURE(MrptMapping, intel, kIntel)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(MrptMapping, freiburg_079, kFreiburg)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench
