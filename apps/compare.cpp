/// \file
/// `scrubjay compare WORLD...`: strategies against each other, as a table.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <thread>

#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "run_options.hpp"
#include "simulated_run.hpp"

namespace scrubjay::apps {
namespace {

struct CompareFlags {
  std::vector<std::string> worlds;
  std::vector<std::string> strategies;
  std::vector<std::string> noises{"none"};
  std::uint64_t seeds = 3;
  std::vector<std::string> models{"roomba-600"};
  std::string localizer;
  double resolution = 0.05;
  double max_time = 7200.0;
  unsigned threads = 0;
  bool means = false;
  std::optional<std::string> csv;
  OutputFlags output;
};

struct Entry {
  Scenario scenario;
  RunResult run;
};

bool is_strategy(std::string_view name) {
  const std::vector<std::string_view> names = strategy_names();
  return std::ranges::find(names, name) != names.end();
}

/// A robot and a strategy that it can do.
struct Contestant {
  std::string model;
  std::string strategy;
  std::string localizer;
};

/// Each robot with each strategy, or, where none are named, with all that it has the senses for.
std::vector<Contestant> contestants(const CompareFlags& flags) {
  std::vector<Contestant> all;
  for (const std::string& model : flags.models) {
    const RobotModel robot = find_robot(model).model;
    const std::string localizer = flags.localizer.empty() ? std::string(default_localizer(robot)) : flags.localizer;
    Scenario trial;
    trial.localizer = localizer;
    make_estimation(trial, robot);  // throws for one that isn't
    const std::vector<std::string_view> able = strategy_names(robot);
    if (flags.strategies.empty()) {
      for (const std::string_view strategy : able) all.push_back({model, std::string(strategy), localizer});
      continue;
    }
    for (const std::string& strategy : flags.strategies) {
      // With several robots, each takes part with what it can do; a single one must be able to.
      const bool can = std::ranges::find(able, strategy) != able.end();
      if (!can && (flags.models.size() == 1 || !is_strategy(strategy))) make_strategy(strategy, {.robot = robot});
      if (can) all.push_back({model, strategy, localizer});
    }
  }
  return all;
}

std::vector<Entry> all_scenarios(const CompareFlags& flags, const std::vector<Contestant>& all) {
  std::vector<Entry> entries;
  for (const std::string& world : flags.worlds) {
    for (const std::string& noise : flags.noises) {
      for (const Contestant& contestant : all) {
        for (std::uint64_t seed = 1; seed <= flags.seeds; ++seed) {
          Scenario scenario;
          scenario.world = world;
          scenario.model = contestant.model;
          scenario.strategy = contestant.strategy;
          scenario.localizer = contestant.localizer;
          scenario.noise = noise;
          scenario.seed = seed;
          scenario.resolution = flags.resolution;
          scenario.max_time = flags.max_time;
          check_scenario(scenario);
          entries.push_back({scenario, {}});
        }
      }
    }
  }
  return entries;
}

/// Runs all entries, each on one thread from begin to end. What comes out doesn't depend on how many threads there are.
class Workers {
 public:
  Workers(std::vector<Entry>& entries, bool show, const std::stop_token& stop)
      : entries_(entries), show_(show), stop_(stop) {}

  void run(std::size_t threads) {
    std::vector<std::jthread> pool;
    for (std::size_t i = 0; i < threads; ++i) pool.emplace_back([this] { work(); });
    pool.clear();
    if (show_) fmt::print(stderr, "\r\033[K");
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < entries_.size() && !stop_.stop_requested(); i = next_++) {
      try {
        Entry& entry = entries_[i];
        const Stage stage = set_stage(entry.scenario);
        const GroundTruth truth = truth_of(stage, entry.scenario.resolution);
        entry.run = run_simulated(entry.scenario, stage, truth, {}, stop_);
        // A table needs no trajectories, of which there may be thousands.
        entry.run.trajectory = {};
        entry.run.truth->trajectory = {};
      } catch (...) {
        const std::scoped_lock lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_ = entries_.size();
      }
      if (!show_) continue;
      const std::scoped_lock lock(mutex_);
      fmt::print(stderr, "\r\033[K{} of {} runs", ++done_, entries_.size());
    }
  }

  std::vector<Entry>& entries_;
  bool show_;
  std::stop_token stop_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

/// The figures of the table, in its order.
struct Column {
  const char* title;
  const char* format;
  double (*value)(const RunResult&);
};

const Column kColumns[] = {
    {"coverage", "{:.3f}", [](const RunResult& r) { return r.truth->score.coverage; }},
    {"IoU", "{:.3f}", [](const RunResult& r) { return r.truth->score.iou; }},
    {"recall", "{:.3f}", [](const RunResult& r) { return r.truth->score.wall_recall; }},
    {"precision", "{:.3f}", [](const RunResult& r) { return r.truth->score.wall_precision; }},
    {"followed recall", "{:.3f}", [](const RunResult& r) { return r.truth->score.followed_wall_recall; }},
    {"followed precision", "{:.3f}", [](const RunResult& r) { return r.truth->score.followed_wall_precision; }},
    {"distance [m]", "{:.0f}", [](const RunResult& r) { return r.report.distance; }},
    {"time [s]", "{:.0f}", [](const RunResult& r) { return r.report.time; }},
    {"contacts", "{:.0f}", [](const RunResult& r) { return static_cast<double>(r.truth->contacts); }},
    {"ATE [m]", "{:.3f}", [](const RunResult& r) { return r.truth->error.ate; }},
};

std::string csv_text(const std::vector<Entry>& entries) {
  std::string text = "world,noise,robot,strategy,seed,ended";
  for (const Column& column : kColumns) text += fmt::format(",{}", column.title);
  text += '\n';
  for (const Entry& entry : entries) {
    const Scenario& s = entry.scenario;
    text += fmt::format("{},{},{},{},{},{}", s.world, s.noise, s.model, s.strategy, s.seed,
                        to_string(entry.run.report.ended));
    for (const Column& column : kColumns) text += fmt::format(",{:.6g}", column.value(entry.run));
    text += '\n';
  }
  return text;
}

std::string table_head() {
  std::string text = "| world | noise | robot | strategy |";
  std::string rule = "|---|---|---|---|";
  for (const Column& column : kColumns) {
    text += fmt::format(" {} |", column.title);
    rule += "---:|";
  }
  return text + '\n' + rule + '\n';
}

/// A row of means over some runs.
std::string table_row(const std::string& world, const std::vector<const Entry*>& runs) {
  const Scenario& s = runs.front()->scenario;
  std::string text = fmt::format("| {} | {} | {} | {} |", world, s.noise, s.model, s.strategy);
  for (const Column& column : kColumns) {
    double sum = 0.0;
    for (const Entry* entry : runs) sum += column.value(entry->run);
    text += fmt::format(" {} |", fmt::format(fmt::runtime(column.format), sum / static_cast<double>(runs.size())));
  }
  return text + '\n';
}

/// A row a world, noise, robot and strategy: means over the seeds.
std::string markdown(const std::vector<Entry>& entries, std::uint64_t seeds) {
  constexpr std::size_t kLongestName = 14;
  std::string text = table_head();
  for (std::size_t i = 0; i < entries.size(); i += seeds) {
    std::vector<const Entry*> runs;
    for (std::size_t k = i; k < i + seeds; ++k) runs.push_back(&entries[k]);
    text += table_row(std::filesystem::path(entries[i].scenario.world).stem().string().substr(0, kLongestName), runs);
  }
  return text;
}

/// A row a noise, robot and strategy: means over all worlds and seeds.
std::string summary(const CompareFlags& flags, const std::vector<Contestant>& all, const std::vector<Entry>& entries) {
  std::string text = table_head();
  for (const std::string& noise : flags.noises) {
    for (const Contestant& contestant : all) {
      std::vector<const Entry*> runs;
      for (const Entry& entry : entries) {
        const Scenario& s = entry.scenario;
        const bool same = s.noise == noise && s.model == contestant.model && s.strategy == contestant.strategy;
        if (same) runs.push_back(&entry);
      }
      text += table_row(fmt::format("all {}", flags.worlds.size()), runs);
    }
  }
  return text;
}

void compare(const CompareFlags& flags) {
  if (flags.seeds < 1 || flags.seeds > 10000) throw Error(fmt::format("--seeds is {}; want 1 to 10000", flags.seeds));
  const std::vector<Contestant> all = contestants(flags);
  std::vector<Entry> entries = all_scenarios(flags, all);
  const Interrupt interrupt;
  const unsigned wanted = flags.threads > 0 ? flags.threads : std::max(1u, std::thread::hardware_concurrency());
  const auto threads = std::min<std::size_t>(wanted, entries.size());
  Workers(entries, progress_wanted(flags.output.quiet), interrupt.token()).run(threads);
  if (interrupt.token().stop_requested()) throw Error("stopped before the table was complete", Error::Kind::Failure);
  if (flags.csv) write_file_atomically(*flags.csv, csv_text(entries));
  fmt::print("{}", flags.means ? summary(flags, all, entries) + '\n' : "");
  fmt::print("{}", markdown(entries, flags.seeds));
}

}  // namespace

void add_compare(CLI::App& app) {
  CLI::App* command = app.add_subcommand("compare", "Run strategies in worlds and print a table");
  const auto flags = std::make_shared<CompareFlags>();
  command->add_option("WORLD", flags->worlds, "worlds, plans or maps")->required();
  command->add_option("--strategies", flags->strategies, "comma-separated (all that the robot can do)")->delimiter(',');
  command->add_option("--noise", flags->noises, "profiles, comma-separated (none)")->delimiter(',');
  command->add_option("--seeds", flags->seeds, "runs from seed 1 to this, averaged (3)")->check(whole_number);
  command->add_option("--model", flags->models, "robots, comma-separated (roomba-600)")->delimiter(',');
  command->add_option("--localizer", flags->localizer, "odometry, scan-matching (what the senses allow)");
  command->add_option("--resolution", flags->resolution, "side of a map cell [m] (0.05)")->check(number);
  command->add_option("--max-time", flags->max_time, "simulated seconds (7200)")->check(number);
  command->add_option("--threads", flags->threads, "runs at the same time (a core each)")->check(whole_number);
  command->add_flag("--means", flags->means, "begin with a table of means over all worlds");
  command->add_option("--csv", flags->csv, "every run, as a file of comma-separated values");
  command->add_flag("--quiet", flags->output.quiet, "print no progress");
  command->callback([flags] { compare(*flags); });
}

}  // namespace scrubjay::apps
