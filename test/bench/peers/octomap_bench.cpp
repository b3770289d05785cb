// OctoMap's tree of the same scans at the same poses: one layer of voxels, each cell along each beam.
#include <octomap/octomap.h>

#include <bench/logged_scans.hpp>

namespace scrubjay::bench {
namespace {

struct Cloud {
  octomap::point3d origin;
  octomap::Pointcloud points;  // returns alone, in the map's frame
};

std::vector<Cloud> clouds(const LoggedScans& log) {
  std::vector<Cloud> out;
  for (const LoggedScan& scan : log.scans) {
    Cloud& cloud = out.emplace_back();
    cloud.origin = octomap::point3d(static_cast<float>(scan.pose.x), static_cast<float>(scan.pose.y), 0.0F);
    for (std::size_t i = 0; i < scan.scan.ranges.size(); ++i) {
      if (!scan.scan.returned(scan.scan.ranges[i])) continue;
      const double range = static_cast<double>(scan.scan.ranges[i]);
      const double bearing = scan.scan.angle_min + static_cast<double>(i) * scan.scan.angle_increment;
      const Point2 end = scan.pose * Point2(range * direction(bearing));
      cloud.points.push_back(static_cast<float>(end.x()), static_cast<float>(end.y()), 0.0F);
    }
  }
  return out;
}

void OctomapMapping(benchmark::State& state, const char* name) {
  const LoggedScans& log = logged_scans(state, name);
  if (log.scans.empty()) return;
  const std::vector<Cloud> scans = clouds(log);
  for ([[maybe_unused]] const auto& _ : state) {
    octomap::OcTree tree(0.05);
    constexpr bool kLazy = true;  // inner nodes once, at the end
    for (const Cloud& scan : scans) tree.insertPointCloud(scan.points, scan.origin, 20.0, kLazy);
    tree.updateInnerOccupancy();
    benchmark::DoNotOptimize(tree.size());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * log.beams());
}
BENCHMARK_CAPTURE(OctomapMapping, intel, kIntel)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(OctomapMapping, freiburg_079, kFreiburg)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench
