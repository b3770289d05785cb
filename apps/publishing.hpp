/// \file
/// What a run tells others in messages of ROS 2, and who they are.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <scrubjay/io/bag_recorder.hpp>
#include <scrubjay/messages/publications.hpp>
#include <scrubjay/mission/background_observer.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/scenario.hpp>

namespace scrubjay::apps {

class RosNode;

/// Where to record, unless the file's name says that its bytes are wanted (.oilog).
bool is_bag(const std::filesystem::path& recording);

/// What a run's time is: of a real robot, of a simulation or a replay that keeps pace with the clock, or of one that is
/// as fast as it can be.
enum class RunTime { Real, Paced, Free };

/// Of a simulation or a replay at so many times real time; 0 is as fast as possible.
inline RunTime run_time(double speed) {
  return speed > 0.0 ? RunTime::Paced : RunTime::Free;
}

class Publishing {
 public:
  /// Nobody is told anything until something of it is asked for. `zstd`: the bag is packed. Throws Error if it can't be
  /// begun.
  explicit Publishing(const std::optional<std::filesystem::path>& bag, bool zstd = false);

  /// `node` is told, too, and what is told of it goes to /rosout; it must outlive this.
  void tell(RosNode& node);
  bool wanted() const { return !sinks_.empty(); }
  /// The observer that publishes, for a run of this scenario by this robot. It has a thread of its own where there is a
  /// clock to keep up with. A real robot never waits for it; a simulated one does before anything would be left out. A
  /// scenario without a model is of a robot that nobody describes.
  Observer& begin(const Scenario& scenario, const RobotModel& robot, RunTime time);
  /// Publishes what the mission left, and how it ended. Throws Error if that failed, or anything before it.
  void finish(GridView<const LogOdds> map, const Report& report);
  /// Completes the bag. Throws Error if that failed.
  void close();

 private:
  std::unique_ptr<BagRecorder> bag_;
  std::vector<ros::MessageSink*> sinks_;
  RosNode* node_ = nullptr;
  std::optional<ros::Publications> publications_;
  std::optional<BackgroundObserver> background_;  // its thread uses all the others
};

}  // namespace scrubjay::apps
