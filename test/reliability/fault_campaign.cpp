/// \file
/// The fault campaign: many runs over bad wires, what is promised of each of them, and how they fared; see
/// docs/reliability.md. Exit code 1 if a run breaks a promise, 2 for wrong flags.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <numeric>
#include <scrubjay/geometry/elementary.hpp>
#include <thread>
#include <vector>

#include "faulty_run.hpp"

namespace scrubjay::reliability {
namespace {

constexpr double kLongestStaleMotion = 0.2;  // [s]
constexpr double kMapErrorFactor = 2.0;
constexpr std::uint64_t kOnTheWay = 3;  // frames that may not have come yet when the account is closed
constexpr std::uint64_t kFaultStream = 100;
constexpr const char* kWorlds[] = {"room", "apartment", "cluttered_flat"};
constexpr const char* kStrategies[] = {"edge-follow", "contact-frontier"};

struct Flags {
  std::uint64_t runs = 1000;
  std::uint64_t seed = 1;
  double time = 120.0;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool markdown = false;
};

using Sceneries = std::vector<std::unique_ptr<Scenery>>;

/// The same seed, over a bad wire and over a good one.
struct Pair {
  RunSetting setting{};
  RunOutcome faulty{};
  RunOutcome faultless{};
};

/// Some wires are nearly good, others lose every fifth frame: rates are drawn evenly on a scale of magnitudes.
sim::WireFaults draw_faults(Random random) {
  const auto magnitude = [&](double low, double high) { return low * exp(random.uniform() * log(high / low)); };
  sim::WireFaults faults;
  faults.drop = magnitude(1e-5, 1e-3);
  faults.flip = magnitude(1e-5, 1e-3);
  faults.delay = random.uniform(0.0, 0.02);
  faults.silences = random.uniform(0.0, 0.1);
  faults.silence = random.uniform(0.0, 2.0);
  return faults;
}

/// What a seed stands for doesn't depend on the runs beside it.
std::vector<Pair> all_runs(const Flags& flags, const Sceneries& sceneries) {
  std::vector<Pair> pairs;
  for (std::uint64_t seed = flags.seed; seed < flags.seed + flags.runs; ++seed) {
    RunSetting setting;
    setting.scenery = sceneries[seed / std::size(kStrategies) % sceneries.size()].get();
    setting.strategy = kStrategies[seed % std::size(kStrategies)];
    setting.seed = seed;
    setting.faults = draw_faults(Random(seed).fork(kFaultStream));
    setting.time = flags.time;
    pairs.push_back({setting, {}, {}});
  }
  return pairs;
}

/// Each run on one thread from begin to end. What comes out doesn't depend on how many threads there are.
void run_all(std::vector<Pair>& pairs, unsigned threads) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < pairs.size(); i = next++) {
      try {
        pairs[i].faulty = run(pairs[i].setting);
        RunSetting good = pairs[i].setting;
        good.faults = {};
        pairs[i].faultless = run(good);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!failure) failure = std::current_exception();
        next = pairs.size();
      }
    }
  };
  {
    std::vector<std::jthread> pool;
    for (unsigned i = 0; i < threads; ++i) pool.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

/// Why a run breaks a promise; empty if it keeps all of them.
std::string broken_promise(const Pair& pair) {
  const RunOutcome& run = pair.faulty;
  if (run.ended != Ended::Done && run.ended != Ended::TimeLimit) return fmt::format("ended: {}", to_string(run.ended));
  if (!run.stands) return "doesn't stand in Passive at the end";
  if (run.stale_motion > kLongestStaleMotion) return fmt::format("unrenewed motion for {:.3f} s", run.stale_motion);
  if (run.reconnections != run.silences) return "a silence that wasn't overcome";
  const std::uint64_t lost = run.due - run.received;
  if (run.counted + run.false_frames + kOnTheWay < lost)
    return fmt::format("{} frames lost, {} counted", lost, run.counted);
  if (run.map_error > kMapErrorFactor * pair.faultless.map_error) {
    return fmt::format("map error of {:.4f} m; {:.4f} m without faults", run.map_error, pair.faultless.map_error);
  }
  return {};
}

/// Why a run breaks a promise goes to stderr; the number of those that do comes back.
std::size_t report_failures(const std::vector<Pair>& pairs) {
  std::size_t failures = 0;
  for (const Pair& pair : pairs) {
    const std::string why = broken_promise(pair);
    if (why.empty()) continue;
    ++failures;
    fmt::print(stderr, "seed {}, {} in {}: {}\n", pair.setting.seed, pair.setting.strategy, pair.setting.scenery->name,
               why);
  }
  return failures;
}

/// Figures over all runs.
class Table {
 public:
  explicit Table(const std::vector<Pair>& pairs, bool markdown) : pairs_(pairs), markdown_(markdown) {
    if (markdown_) fmt::print("| | median | 95 % | worst | all runs |\n|---|--:|--:|--:|--:|\n");
  }

  /// One figure of each run: its distribution.
  template <typename Figure>
  void spread(const char* name, int digits, Figure figure) const {
    const std::vector<double> values = sorted(figure);
    line(name, fmt::format("{:.{}f}", at(values, 0.5), digits), fmt::format("{:.{}f}", at(values, 0.95), digits),
         fmt::format("{:.{}f}", values.back(), digits), "");
  }
  /// One count of each run, which is added up, too.
  template <typename Figure>
  void count(const char* name, Figure figure) const {
    const std::vector<double> values = sorted(figure);
    line(name, fmt::format("{:.0f}", at(values, 0.5)), fmt::format("{:.0f}", at(values, 0.95)),
         fmt::format("{:.0f}", values.back()),
         fmt::format("{:.0f}", std::accumulate(values.begin(), values.end(), 0.0)));
  }

 private:
  template <typename Figure>
  std::vector<double> sorted(Figure figure) const {
    std::vector<double> values;
    for (const Pair& pair : pairs_) values.push_back(static_cast<double>(figure(pair)));
    std::ranges::sort(values);
    return values;
  }
  static double at(const std::vector<double>& values, double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  }
  void line(const char* name, const std::string& median, const std::string& most, const std::string& worst,
            const std::string& all) const {
    fmt::print(fmt::runtime(markdown_ ? "| {} | {} | {} | {} | {} |\n" : "{:58} {:>8} {:>8} {:>8} {:>9}\n"), name,
               median, most, worst, all);
  }

  const std::vector<Pair>& pairs_;
  bool markdown_;
};

void print_figures(const std::vector<Pair>& pairs, bool markdown) {
  const Table table(pairs, markdown);
  table.spread("motion not told again, while the wire carries bytes [s]", 3,
               [](const Pair& p) { return p.faulty.stale_motion; });
  table.spread("the same by the clock, silences of the wire included [s]", 3,
               [](const Pair& p) { return p.faulty.cut_motion; });
  table.spread("map error [m]", 4, [](const Pair& p) { return p.faulty.map_error; });
  table.spread("map error without faults [m]", 4, [](const Pair& p) { return p.faultless.map_error; });
  table.spread("times the map error without faults", 2,
               [](const Pair& p) { return p.faulty.map_error / p.faultless.map_error; });
  table.spread("position error, root mean square [m]", 3, [](const Pair& p) { return p.faulty.position_error; });
  table.spread("way driven [m]", 1, [](const Pair& p) { return p.faulty.distance; });
  table.count("frames due", [](const Pair& p) { return p.faulty.due; });
  table.count("frames sent", [](const Pair& p) { return p.faulty.sent; });
  table.count("frames that came", [](const Pair& p) { return p.faulty.received; });
  table.count("frames due that didn't come", [](const Pair& p) { return p.faulty.due - p.faulty.received; });
  table.count("... as the client counts them", [](const Pair& p) { return p.faulty.counted; });
  table.count("false frames: damaged, with a checksum that fits", [](const Pair& p) { return p.faulty.false_frames; });
  table.count("values that the client refused", [](const Pair& p) { return p.faulty.rejected_values; });
  table.count("commands that nobody gave, and the robot understood",
              [](const Pair& p) { return p.faulty.foreign_commands; });
  table.count("times that the robot was found deaf, and fed zeros", [](const Pair& p) { return p.faulty.deafnesses; });
  table.count("silences noticed", [](const Pair& p) { return p.faulty.silences; });
  table.count("silences overcome", [](const Pair& p) { return p.faulty.reconnections; });
  table.spread("longest silence, from frame to frame [s]", 2, [](const Pair& p) { return p.faulty.longest_silence; });
  table.count("bytes lost one by one", [](const Pair& p) { return p.faulty.wire.dropped; });
  table.count("bytes with a flipped bit", [](const Pair& p) { return p.faulty.wire.flipped; });
  table.count("bytes lost in silences", [](const Pair& p) { return p.faulty.wire.silenced; });
}

int campaign(const Flags& flags) {
  Sceneries sceneries;
  for (const char* world : kWorlds) {
    sceneries.push_back(std::make_unique<Scenery>(fmt::format("{}/worlds/{}.yaml", SCRUBJAY_SOURCE_DIR, world)));
  }
  std::vector<Pair> pairs = all_runs(flags, sceneries);
  run_all(pairs, flags.threads);
  const std::size_t failures = report_failures(pairs);
  fmt::print("{} of {} runs keep all promises.\n\n", pairs.size() - failures, pairs.size());
  print_figures(pairs, flags.markdown);
  return failures == 0 ? 0 : 1;
}

}  // namespace
}  // namespace scrubjay::reliability

int main(int argc, char** argv) {
  scrubjay::reliability::Flags flags;
  CLI::App app("Runs over bad wires, and what is promised of them.");
  app.add_option("--runs", flags.runs, "how many, each with the seed after the last one's")->check(CLI::PositiveNumber);
  app.add_option("--seed", flags.seed, "of the first run");
  app.add_option("--time", flags.time, "of each run [simulated s]")->check(CLI::PositiveNumber);
  app.add_option("--threads", flags.threads, "which change nothing but the time it takes")->check(CLI::PositiveNumber);
  app.add_flag("--markdown", flags.markdown, "figures as a table of Markdown");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return campaign(flags);
  } catch (const std::exception& error) {
    fmt::print(stderr, "fault_campaign: {}\n", error.what());
    return 1;
  }
}
