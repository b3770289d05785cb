/// \file
/// Parts of a mission that do as they are told, and remember what they were told.
#pragma once

#include <functional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/mapper.hpp>
#include <scrubjay/mission/observer.hpp>
#include <scrubjay/robot/robot.hpp>
#include <vector>

namespace scrubjay::test {

inline constexpr double kTick = 0.015;

/// A frame a tick from 100 s on, as `edit` has it, until there are no more.
class FakeRobot final : public Robot {
 public:
  explicit FakeRobot(int frames, std::function<void(int, Frame&)> edit = {})
      : frames_(frames), edit_(std::move(edit)) {}

  std::optional<Frame> next() override {
    if (given == frames_) return std::nullopt;
    Frame frame;
    frame.stamp = 100.0 + kTick * given;
    if (edit_) edit_(given, frame);
    ++given;
    return frame;
  }
  void drive(const Motion& motion) override { motions.push_back(motion); }
  bool order(const oi::Command&) override {
    ++orders;
    return obeys;
  }
  void stop() override {
    ++stops;
    motions_before_stop = motions.size();
  }

  int given = 0;
  int stops = 0;
  int orders = 0;
  bool obeys = true;  // what it is ordered
  std::vector<Motion> motions;
  std::size_t motions_before_stop = 0;

 private:
  int frames_;
  std::function<void(int, Frame&)> edit_;
};

class FakeLocalizer final : public Localizer {
 public:
  const PoseEstimate& update(const Frame& frame) override {
    estimate_.pose.x += 0.5 * (frame.left_travel + frame.right_travel);
    return estimate_;
  }

 private:
  PoseEstimate estimate_;
};

class FakeMapper final : public Mapper {
 public:
  void update(const Frame&, const PoseEstimate&) override { ++updates; }
  CellRect changed() const override { return {}; }
  GridView<const LogOdds> map() const override { return {}; }
  OccupancyGrid occupancy() const override { return {}; }

  int updates = 0;
};

/// Drives at 0.1 m/s, and is done with its `last`th decision.
class FakeBehavior final : public Behavior {
 public:
  explicit FakeBehavior(int last = 1'000'000) : last_(last) {}

  Decision decide(const Situation&) override { return {{0.1, 0.0}, "driving", ++decisions == last_}; }

  int decisions = 0;

 private:
  int last_;
};

class FakeObserver final : public Observer {
 public:
  void notify(const Snapshot& now) override {
    stamps.push_back(now.frame.stamp);
    done = now.decision.done;
    if (act) act(now);
  }

  std::vector<double> stamps;
  bool done = false;
  std::function<void(const Snapshot&)> act;
};

}  // namespace scrubjay::test
