// Marking cells, and growing a map, in cells of 5 cm.
#include <benchmark/benchmark.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/grid/contact_model.hpp>
#include <scrubjay/grid/fill_line.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <vector>

namespace scrubjay {
namespace {

const GridGeometry kGrid{0.05, {-5.0, -5.0}, 200, 200};

/// A drive on a circle of 4 m, `step` metres a tick.
class Circle {
 public:
  explicit Circle(double step) : step_(step) {}
  Pose2 next() {
    angle_ = wrap_angle(angle_ + step_ / kRadius);
    const Point2 p = kRadius * direction(angle_);
    return {p.x(), p.y(), wrap_angle(angle_ + 0.5 * kPi)};
  }

 private:
  static constexpr double kRadius = 4.0;
  double step_;
  double angle_ = 0.0;
};

Frame beside_a_wall() {
  Frame frame;
  frame.light_signal = {640, 130, 40, 31, 30, 30};
  return frame;
}

void integrate(benchmark::State& state, const Frame& frame, double step) {
  std::vector<LogOdds> cells(kGrid.size());
  ContactModel model({});
  Circle circle(step);
  for (auto _ : state) {
    model.integrate(frame, circle.next(), {kGrid, cells.data()});
    benchmark::ClobberMemory();
  }
}

/// A tick at 0.1 m/s, of which one in 14 makes a step of the model.
void IntegrateInTheOpen(benchmark::State& state) {
  integrate(state, {}, 0.0015);
}
BENCHMARK(IntegrateInTheOpen);

void IntegrateBesideAWall(benchmark::State& state) {
  integrate(state, beside_a_wall(), 0.0015);
}
BENCHMARK(IntegrateBesideAWall);

/// A step of the model every time.
void IntegrateWholeStepBesideAWall(benchmark::State& state) {
  integrate(state, beside_a_wall(), 0.025);
}
BENCHMARK(IntegrateWholeStepBesideAWall);

void IntegrateBumps(benchmark::State& state) {
  Frame frame = beside_a_wall();
  frame.bump_left = true;
  integrate(state, frame, 0.025);
}
BENCHMARK(IntegrateBumps);

/// The mapper around the model: makes room first.
void UpdateMapper(benchmark::State& state) {
  ContactMapper mapper({}, kGrid.resolution);
  Circle circle(0.0015);
  const Frame frame = beside_a_wall();
  PoseEstimate estimate;
  for (auto _ : state) {
    estimate.pose = circle.next();
    mapper.update(frame, estimate);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(UpdateMapper);

/// A map that grows from nothing to a square of `side` metres, along its diagonal.
void Grow(benchmark::State& state) {
  const double side = static_cast<double>(state.range(0));
  for (auto _ : state) {
    GrowingMap map(kGrid.resolution);
    for (double way = 0.0; way < side; way += 0.02) map.cover({way, way}, 0.3);
    benchmark::DoNotOptimize(map.view().cells);
  }
  state.counters["cells"] = side * side / (kGrid.resolution * kGrid.resolution);
}
BENCHMARK(Grow)->Arg(20)->Arg(160)->Unit(benchmark::kMicrosecond);

/// Trinary cells of a map of 20 x 20 m, for a file.
void MakeOccupancy(benchmark::State& state) {
  GrowingMap map(kGrid.resolution);
  map.cover({10.0, 10.0}, 10.0);
  const GridView<LogOdds> view = map.view();
  for (std::size_t i = 0; i < view.geometry.size(); ++i) view.cells[i] = static_cast<LogOdds>(i * 7919 % 201 - 100);
  for (auto _ : state) benchmark::DoNotOptimize(map.occupancy().cells.data());
}
BENCHMARK(MakeOccupancy)->Unit(benchmark::kMicrosecond);

/// Beams of 0.1 to 5 m from the middle, all around.
std::vector<Point2> beam_ends() {
  Random random(1);
  std::vector<Point2> ends;
  for (int i = 0; i < 4096; ++i) ends.push_back(random.uniform(0.1, 4.9) * direction(random.uniform(-kPi, kPi)));
  return ends;
}

void VisitLine(benchmark::State& state) {
  const std::vector<Point2> ends = beam_ends();
  std::vector<std::uint8_t> cells(kGrid.size());
  for (auto _ : state) {
    for (const Point2& end : ends)
      visit_line(kGrid, {0.01, 0.02}, end, [&](CellIndex c) { cells[kGrid.index(c)] = 1; });
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * ends.size()));
}
BENCHMARK(VisitLine);

/// The same cells.
void FillLine(benchmark::State& state) {
  const std::vector<Point2> ends = beam_ends();
  std::vector<std::uint8_t> cells(kGrid.size());
  const auto in_cells = [](const Point2& p) { return Point2((p - kGrid.origin) / kGrid.resolution); };
  std::vector<LineWalk> walks(ends.size());
  for (auto _ : state) {
    const Point2 from = in_cells({0.01, 0.02});
    for (std::size_t i = 0; i < ends.size(); ++i) walks[i] = line_walk(kGrid.width, from, in_cells(ends[i]));
    for (const LineWalk& walk : walks) fill_line<std::uint8_t>(walk, cells.data(), 1);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * ends.size()));
}
BENCHMARK(FillLine);

}  // namespace
}  // namespace scrubjay
