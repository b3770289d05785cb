/// \file
/// When to try again to reach a robot that has fallen silent.
#pragma once

#include <cstdint>
#include <optional>

namespace scrubjay {

struct ReconnectionParams {
  double first_retry = 0.1;    ///< pause behind the first attempt [s]; doubles each time ...
  double longest_retry = 2.0;  ///< ... up to this
  double give_up = 60.0;       ///< without a frame for this long, the robot is gone [s]
};

/// Attempts with growing pauses between them, and an account of how the link fared. It has no clock: stamps come from
/// whoever reads.
class Reconnection {
 public:
  enum class Step : std::uint8_t {
    Wait,    ///< go on reading
    Retry,   ///< start the robot's session anew, now
    GiveUp,  ///< the robot is gone
  };

  explicit Reconnection(const ReconnectionParams& params = {}) : params_(params) {}

  /// A frame came.
  void alive(double stamp);
  /// A read brought none, and the robot counts as silent.
  Step silent(double stamp);

  std::uint64_t silences() const { return silences_; }            ///< so far
  std::uint64_t reconnections() const { return reconnections_; }  ///< silences that ended with a frame
  double longest_silence() const { return longest_; }             ///< from frame to frame [s]

 private:
  ReconnectionParams params_;
  std::optional<double> last_alive_;
  bool is_silent_ = false;
  double retry_stamp_ = 0.0;  // of the next attempt
  double pause_ = 0.0;        // behind it
  std::uint64_t silences_ = 0;
  std::uint64_t reconnections_ = 0;
  double longest_ = 0.0;
};

}  // namespace scrubjay
