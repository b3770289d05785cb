#include "doctor_ros2.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <scrubjay/error.hpp>
#include <scrubjay/ros2/bridge.hpp>
#include <scrubjay/ros2/socket_buffers.hpp>

#include "domain_report.hpp"
#include "interrupt.hpp"
#include "ros_options.hpp"

namespace scrubjay::apps {
namespace {

/// Lines that come from any thread.
class Lines {
 public:
  void add(const std::string& line) {
    const std::scoped_lock lock(mutex_);
    all_.push_back(line);
  }
  std::vector<std::string> all() const {
    const std::scoped_lock lock(mutex_);
    return all_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> all_;
};

/// False if somebody asked to stop before.
bool wait_for(double seconds, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any asked;
  std::unique_lock lock(mutex);
  asked.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
  return !stop.stop_requested();
}

}  // namespace

void examine_domain(const RosFlags& flags, double listen, bool json) {
  std::vector<std::string> warnings;
  const ros::ParticipantOptions settings = ros_options(flags, warnings);
  const std::vector<ros::Endpoint> planned = ros::bridge_endpoints(settings.names, ros::kTopics);
  const Interrupt interrupt;
  Lines told;  // outlives the participant
  ros::ParticipantOptions onlooker = settings;
  onlooker.presence = ros::Presence::Onlooker;
  onlooker.tell = [&told](const std::string& line) { told.add(line); };
  const ros::Participant participant(onlooker);
  if (::isatty(STDERR_FILENO) != 0) fmt::print(stderr, "listening to domain {} ...\n", settings.domain);
  if (!wait_for(listen, interrupt.token())) {
    throw Error("interrupted; nothing is known of the domain", Error::Kind::Failure);
  }
  const ros::Survey survey = ros::survey(settings, participant.peers(), planned, participant.strange_discovery_infos());

  std::vector<Finding> findings = ros::diagnose(survey);
  const auto remark = [&](const std::string& what) { findings.push_back({Finding::Kind::Remark, what}); };
  for (const std::string& warning : warnings) remark(warning);
  if (const std::optional<Finding> clamped = ros::clamped_buffers()) findings.push_back(*clamped);
  for (const std::string& line : told.all()) {
    if (line.starts_with(ros::kFromFastDds)) remark(line);  // all else was found above
  }
  fmt::print("{}", json ? domain_json(survey, findings) : domain_text(survey, findings));
  if (!healthy(findings)) throw Error("the domain isn't healthy", Error::Kind::Failure);
}

}  // namespace scrubjay::apps
