#include "recorded_run.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/firmware.hpp>
#include <scrubjay/simulation/roomba_body.hpp>
#include <tuple>

namespace scrubjay::bench {
namespace {

constexpr double kResolution = 0.05;

/// A simulated Roomba that keeps what passes between its parts.
class WatchedRoomba final : public ByteChannel {
 public:
  explicit WatchedRoomba(RecordedRun& run)
      : run_(run),
        body_(run.stage.world, run.stage.index, {}, noise(run.profile), Random(1), run.stage.start),
        firmware_({}) {}

  ByteRead read(std::span<std::uint8_t> buffer) override {
    RecordedTick& tick = run_.ticks.emplace_back();
    tick.commands.swap(commands_);
    tick.wanted = firmware_.wanted();
    tick.senses = body_.tick(tick.wanted);
    firmware_.tick(tick.senses, tick.stream);
    std::copy(tick.stream.begin(), tick.stream.end(), buffer.begin());
    return {tick.stream.size(), sim::kTick * static_cast<double>(run_.ticks.size()), true};
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    firmware_.receive(bytes);
    commands_.insert(commands_.end(), bytes.begin(), bytes.end());
    return true;
  }

 private:
  RecordedRun& run_;
  sim::RoombaBody body_;
  sim::Firmware firmware_;
  std::vector<std::uint8_t> commands_;
};

/// Gives a run's stream again, and takes any command.
class PlayedRoomba final : public ByteChannel {
 public:
  explicit PlayedRoomba(const RecordedRun& run) : run_(run) {}

  ByteRead read(std::span<std::uint8_t> buffer) override {
    const std::vector<std::uint8_t>& stream = run_.ticks[tick_++].stream;
    std::copy(stream.begin(), stream.end(), buffer.begin());
    return {stream.size(), sim::kTick * static_cast<double>(tick_), true};
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    benchmark::DoNotOptimize(bytes.data());
    return true;
  }

 private:
  const RecordedRun& run_;
  std::size_t tick_ = 0;
};

RecordedRun record(const std::string& strategy, const std::string& profile, int rooms) {
  RecordedRun run{strategy, profile, Stage(rooms), {}};
  const RobotModel model;
  WatchedRoomba roomba(run);
  OiRobot robot(roomba, model);
  DeadReckoning localizer(model.drive);
  ContactMapper mapper(model, kResolution);
  const auto behavior = make_strategy(strategy, {.robot = model, .random = Random(2)});
  while (const auto frame = robot.next()) {
    RecordedTick& tick = run.ticks.back();
    tick.frame = *frame;
    tick.estimate = localizer.update(*frame);
    mapper.update(tick.frame, tick.estimate);
    const Decision decision = behavior->decide({tick.frame, tick.estimate, mapper.map(), mapper.changed()});
    tick.motion = decision.motion;
    if (decision.done || frame->stamp >= kRecordedTime) break;
    robot.drive(tick.motion);
  }
  return run;
}

}  // namespace

const RecordedRun& recorded_run(const std::string& strategy, const std::string& profile, int rooms) {
  static std::map<std::tuple<std::string, std::string, int>, RecordedRun> runs;
  const std::tuple key(strategy, profile, rooms);
  const auto known = runs.find(key);
  return known != runs.end() ? known->second : runs.emplace(key, record(strategy, profile, rooms)).first->second;
}

void play_body(const RecordedRun& run) {
  sim::RoombaBody body(run.stage.world, run.stage.index, {}, noise(run.profile), Random(1), run.stage.start);
  for (const RecordedTick& tick : run.ticks) benchmark::DoNotOptimize(body.tick(tick.wanted));
}

void play_firmware(const RecordedRun& run) {
  sim::Firmware firmware({});
  std::vector<std::uint8_t> stream;
  for (const RecordedTick& tick : run.ticks) {
    if (!tick.commands.empty()) firmware.receive(tick.commands);
    stream.clear();
    firmware.tick(tick.senses, stream);
    benchmark::DoNotOptimize(stream.data());
  }
}

void play_oi_robot(const RecordedRun& run) {
  PlayedRoomba roomba(run);
  OiRobot robot(roomba, {});
  for (const RecordedTick& tick : run.ticks) {
    benchmark::DoNotOptimize(robot.next());
    robot.drive(tick.motion);
  }
}

void play_odometry(const RecordedRun& run) {
  DeadReckoning localizer({});
  for (const RecordedTick& tick : run.ticks) benchmark::DoNotOptimize(localizer.update(tick.frame));
}

void play_mapper(const RecordedRun& run) {
  ContactMapper mapper({}, kResolution);
  for (const RecordedTick& tick : run.ticks) mapper.update(tick.frame, tick.estimate);
  benchmark::DoNotOptimize(mapper.map().cells);
}

void play_mapper_and_behavior(const RecordedRun& run) {
  ContactMapper mapper({}, kResolution);
  const auto behavior = make_strategy(run.strategy, {.random = Random(2)});
  for (const RecordedTick& tick : run.ticks) {
    mapper.update(tick.frame, tick.estimate);
    benchmark::DoNotOptimize(behavior->decide({tick.frame, tick.estimate, mapper.map(), mapper.changed()}));
  }
}

double thread_cpu_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace scrubjay::bench
