/// \file
/// Driving a robot by keys: what a key means, for how long, and what stops the robot in spite of it.
#pragma once

#include <functional>
#include <optional>
#include <scrubjay/io/keyboard.hpp>
#include <scrubjay/robot/robot.hpp>
#include <stop_token>
#include <string_view>
#include <vector>

namespace scrubjay {

struct KeyDriveParams {
  double max_speed = 0.2;  ///< forward and backward [m/s]
  double max_turn = 1.0;   ///< [rad/s]
  /// Terminals don't say when a key is let go; what they do is repeat it. A key pressed once counts for so long,
  /// until the first repetition, which comes after 0.25 to 0.66 s by the desktops' settings [s] ...
  double first_hold = 0.7;
  /// ... and one that is being repeated counts for so long after each [s].
  double repeated_hold = 0.25;
  double repeat_interval = 0.15;  ///< a key that comes again within it is being repeated [s]
  double silence = 0.25;          ///< after so long without a frame, all keys must be pressed anew [s]
};

/// Turns keys into motion. Up and w, down and s drive; left and a, right and d turn, also while driving; + and - change
/// the speed; q and Ctrl-D end it; every other key stops at once.
class KeyDriver {
 public:
  /// What keeps the robot from doing as it is told.
  enum class Held : std::uint8_t {
    No,
    Bumped,       ///< forward is off, all else is on
    Cliff,        ///< the same
    WheelHangs,   ///< nothing is on
    OnTheCharger  ///< the robot itself refuses to leave
  };

  explicit KeyDriver(const KeyDriveParams& params = {}) : params_(params) {}

  /// `now`: the stamp of the frame that came last [s].
  void press(const Key& key, double now);
  /// What to do on this frame.
  Motion motion(const Frame& frame);
  /// No key counts any more.
  void let_go();

  bool quit() const { return quit_; }
  Held held() const { return held_; }
  /// Of full speed: 0.1 to 1.
  double speed() const { return 0.1 * tenths_; }
  const KeyDriveParams& params() const { return params_; }

 private:
  /// One direction, by the key pressed last.
  struct Axis {
    int sign = 0;
    double pressed = 0.0;  // when [s]
    double until = 0.0;    // it counts [s]
  };

  void hold(Axis& axis, int sign, double now) const;

  KeyDriveParams params_;
  Axis forward_;
  Axis left_;
  int tenths_ = 5;
  bool quit_ = false;
  Held held_ = Held::No;
};

enum class DriveEnd : std::uint8_t { Quit, Stopped, KeyboardGone, RobotGone };

/// The keys since the last call; none at all once there is no keyboard any more.
using KeySource = std::function<std::optional<std::vector<Key>>()>;
/// Somebody who looks on.
using DriveView = std::function<void(const Frame& frame, const Motion& motion, const KeyDriver& driver)>;

/// To be called now and then while the robot is silent, and drive_by_keys() waits for its next frame. Takes the keys:
/// speed and the end count at once, all others when they are pressed again later. False if somebody ends it, or the
/// keyboard is gone; the robot's next() should give none then.
bool heed_keys_in_silence(KeyDriver& driver, const KeySource& keys);

/// Drives until somebody ends it: by key, by `stop`, or because keyboard or robot are gone. However it ends, also by an
/// exception, the robot is told to stop.
DriveEnd drive_by_keys(Robot& robot, KeyDriver& driver, const KeySource& keys, const DriveView& view,
                       const std::stop_token& stop);

}  // namespace scrubjay
