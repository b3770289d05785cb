// What a decision costs, by strategy, over ten minutes of the run that it steered itself. An iteration is the whole
// run.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "recorded_run.hpp"

namespace scrubjay::bench {
namespace {

void Decide(benchmark::State& state, const std::string& strategy) {
  const RecordedRun& run = recorded_run(strategy, "none");
  double spent = 0.0;
  for (auto _ : state) {
    const double begin = thread_cpu_time();
    play_mapper(run);
    const double middle = thread_cpu_time();
    play_mapper_and_behavior(run);
    const double decisions = std::max(0.0, thread_cpu_time() - middle - (middle - begin));
    state.SetIterationTime(decisions);
    spent += decisions;
  }
  const double ticks = static_cast<double>(run.ticks.size()) * static_cast<double>(state.iterations());
  state.counters["ns_per_decision"] = 1e9 * spent / ticks;
}
BENCHMARK_CAPTURE(Decide, random_2, "random-2")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decide, random_3, "random-3")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decide, random_look, "random-look")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decide, random_aware, "random-aware")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decide, reactive, "reactive")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Decide, edge_follow, "edge-follow")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench
