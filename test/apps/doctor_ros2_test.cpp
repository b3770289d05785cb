/// \file
/// `doctor --ros2`, and the runs that it sees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>
#include <ros2/fresh_domain.hpp>
#include <sstream>

#include "command_line.hpp"
#include "driven_terminal.hpp"

namespace scrubjay {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// In a domain of its own, on this machine alone.
class DoctorRos2Test : public testing::Test {
 protected:
  DoctorRos2Test() {
    for (const char* name : {"ROS_DISTRO", "ROS_LOCALHOST_ONLY", "ROS_STATIC_PEERS", "ROS_SECURITY_ENABLE"}) {
      ::unsetenv(name);
    }
    ::setenv("ROS_DOMAIN_ID", std::to_string(domain_.number()).c_str(), 1);
    ::setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST", 1);
  }

  /// What the doctor says as soon as it has found what is awaited, or at last.
  template <class Holds>
  static json report_when(Holds holds) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (true) {
      const Outcome outcome = scrubjay({"doctor", "--ros2", "--listen", "0.7", "--json"});
      const json report = json::parse(outcome.out);
      EXPECT_EQ(report.at("healthy").get<bool>(), outcome.code == 0);
      if (holds(report) || std::chrono::steady_clock::now() > deadline) return report;
    }
  }
  static json report_with_run() {
    return report_when([](const json& report) { return !report.at("runs").empty(); });
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  ros::FreshDomain domain_;
  TemporaryFolder folder_;
};

std::string whats(const json& report) {
  std::string all;
  for (const json& finding : report.at("findings")) all += finding.at("what").get<std::string>() + "\n";
  return all;
}

TEST_F(DoctorRos2Test, SaysThatNobodyIsThereAndWhyThatMayBeInEightyColumns) {
  const Outcome outcome = scrubjay({"doctor", "--ros2", "--listen", "0.5"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  for (const std::string& words :
       {"domain        " + std::to_string(domain_.number()) + ", jazzy, discovery range: localhost\n",
        std::string("problem: Nobody else is in the domain\n"), std::string("   try: ROS_DOMAIN_ID=")}) {
    EXPECT_THAT(outcome.out, HasSubstr(words));
  }
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80U) << line;
}

TEST_F(DoctorRos2Test, ComparesOthersWithTheRunThatIsThere) {
  const Call run({"bridge", own_world("room"), "--out", path("run")});
  const Call other({"explore", own_world("room"), "--ros2", "--out", path("other"), "--ros-args", "-r", "__node:=raven",
                    "-r", "bumper:=feelers"});
  const auto is_whole = [](const json& report) {
    const auto& peers = report.at("peers");
    // Its 28 topics or more, and ros_discovery_info both ways.
    return report.at("runs").size() == 2 && peers.size() == 1 && peers[0].at("endpoints").size() >= 30 &&
           !peers[0].at("nodes").empty();
  };
  const json report = report_when(is_whole);
  ASSERT_TRUE(is_whole(report)) << report;
  EXPECT_TRUE(report.at("healthy")) << whats(report);
  const json& peer = report.at("peers")[0];
  EXPECT_EQ(peer.at("nodes"), json({"/raven"}));
  EXPECT_EQ(peer.at("vendor"), "Fast DDS");
  EXPECT_EQ(peer.at("enclave"), "/");
  const auto fit_of = [&](const std::string& topic) {
    for (const json& endpoint : peer.at("endpoints")) {
      if (endpoint.at("topic") == topic) return endpoint.at("fit").get<std::string>();
    }
    return std::string();
  };
  EXPECT_EQ(fit_of("/map"), "same side");
  EXPECT_EQ(fit_of("/feelers"), "not ours");
  EXPECT_THAT(whats(report), HasSubstr("Both we and /raven write /map, "));

  const std::string map =
      "  writes      /map nav_msgs/msg/OccupancyGrid\n"
      "              reliable, transient_local; hash as ours; we do, too\n";
  std::string text;
  for (int i = 0; i < 30 && text.find(map) == std::string::npos; ++i) {
    text = scrubjay({"doctor", "--ros2", "--listen", "1"}).out;
  }
  EXPECT_THAT(text, HasSubstr("our run       /scrubjay: "));
  EXPECT_THAT(text, HasSubstr("node          /raven\n"));
  EXPECT_THAT(text, HasSubstr(map));
}

TEST_F(DoctorRos2Test, SeesAReplayThatIsANode) {
  ASSERT_EQ(scrubjay({"explore", own_world("room"), "--max-time", "60", "--record", path("run.mcap"), "--out",
                      path("first"), "--quiet"})
                .code,
            0);
  Call replay({"replay", path("run.mcap"), "--ros2", "--out", path("again"), "--quiet"});
  const json report = report_with_run();
  ASSERT_EQ(report.at("runs").size(), 1U);
  EXPECT_EQ(report.at("runs")[0].at("nodes"), json({"/scrubjay"}));
  EXPECT_THAT(whats(report), HasSubstr("Nobody but a run of ours"));
  replay.send(SIGINT);
  const Outcome outcome = replay.wait();
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST_F(DoctorRos2Test, SeesADriveThatIsANodeWhoseWordsWaitForTheEndOfTheScreen) {
  TerminalCall drive({"drive", own_world("room"), "--ros2"});
  ASSERT_TRUE(drive.wait_for("drive, space stops"));
  EXPECT_EQ(report_with_run().at("runs").size(), 1U);
  EXPECT_EQ(drive.shown().find("nobody listens"), std::string::npos);
  drive.type("q");
  EXPECT_EQ(drive.wait(), 0);
  const std::string shown = drive.shown();
  ASSERT_NE(shown.find("nobody listens to any topic of ours"), std::string::npos) << shown;
  EXPECT_GT(shown.find("nobody listens"), shown.find("the robot stands"));
}

TEST_F(DoctorRos2Test, RefusesWhatIsOfAPort) {
  for (const Words& words : {Words{"--ros2", "--port", "/dev/ttyUSB0"}, Words{"--ros2", "--check"},
                             Words{"--ros2", "--ros-distro", "hydro"}, Words{"--ros-distro", "humble"}}) {
    Words all{"doctor"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = scrubjay(all);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  }
}

}  // namespace
}  // namespace scrubjay
