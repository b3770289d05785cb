/// \file
/// `scrubjay calibrate`: finds a robot's wheel and axle factors from a few drives, and writes them down.
#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/calibration_file.hpp>

#include "calibration_site.hpp"
#include "commands.hpp"
#include "data_folder.hpp"
#include "interrupt.hpp"
#include "robot_address.hpp"
#include "run_options.hpp"

namespace scrubjay::apps {
namespace {

struct CalibrateFlags {
  std::string robot = "sim";
  Scenario scenario;
  std::string start;
  std::vector<std::string> drives{"spin", "straight", "square-left", "square-right", "spin"};
  std::uint64_t repeat = 1;
  std::vector<std::string> measured;
  CalibrationFigures figures;
  std::string out = "calibration.yaml";
  std::string date;
  OutputFlags output;
};

std::vector<CalibrationFigure> figures_of(const CalibrateFlags& flags) {
  if (flags.repeat < 1 || flags.repeat > 100) throw Error(fmt::format("--repeat is {}; want 1 to 100", flags.repeat));
  std::vector<CalibrationFigure> figures;
  for (std::uint64_t i = 0; i < flags.repeat; ++i) {
    for (const std::string& name : flags.drives) figures.push_back(figure_of(name));
  }
  return figures;
}

void expect_figures(const CalibrationFigures& figures) {
  const auto expect_length = [](double length, const char* flag) {
    if (length >= 0.3 && length <= 10.0) return;
    throw Error(fmt::format("{} is {}; want 0.3 to 10 m", flag, length));
  };
  expect_length(figures.side, "--side");
  expect_length(figures.straight, "--straight");
  if (figures.turns < 1 || figures.turns > 50) throw Error(fmt::format("--turns is {}; want 1 to 50", figures.turns));
}

void check(const CalibrateFlags& flags) {
  find_oi_robot(flags.scenario.model);
  if (!flags.date.empty() && !is_date(flags.date)) {
    throw Error(fmt::format("--date is '{}'; want a date as 2026-03-31", flags.date));
  }
}

/// To a multiple of `step`; what is next to nothing has no sign.
double rounded(double value, double step) {
  return std::round(value / step) * step + 0.0;
}

void print_drive(const CalibrationDrive& drive) {
  fmt::print("  {:<13}", to_string(drive.figure));
  if (drive.figure == CalibrationFigure::Spin) {
    return fmt::print("{:9.2f} deg {:>22} {:.2f} deg\n", degrees(drive.measured[0]),
                      "left over:", rounded(degrees(drive.residual[0]), 0.01));
  }
  const auto millimetres = [](const std::vector<double>& lengths) {
    std::string text;
    for (const double length : lengths) {
      text += fmt::format("{}{:.0f}", text.empty() ? "" : ", ", rounded(1000.0 * length, 1.0));
    }
    return text;
  };
  fmt::print("{:>9} mm {:>23} {} mm\n", millimetres(drive.measured), "left over:", millimetres(drive.residual));
}

void print_figures(const CalibrationRecord& record, const CalibrateFlags& flags) {
  const Calibration& factors = record.calibration;
  const Calibration& deviation = *record.deviation;
  if (flags.output.json) {
    const nlohmann::json json{
        {"model", record.model},
        {"left", factors.left},
        {"right", factors.right},
        {"axle", factors.axle},
        {"deviation", {{"left", deviation.left}, {"right", deviation.right}, {"axle", deviation.axle}}}};
    return fmt::print("{}\n", json.dump(2));
  }
  if (flags.output.quiet) return;
  for (const CalibrationDrive& drive : record.drives) print_drive(drive);
  const auto line = [](const char* name, double factor, double error) {
    fmt::print("{:<12} {:.4f} +- {:.4f}\n", name, factor, error);
  };
  line("left wheel", factors.left, deviation.left);
  line("right wheel", factors.right, deviation.right);
  line("axle", factors.axle, deviation.axle);
}

/// Prints what was found even if it can't be written: nobody measures twice gladly.
void deliver(const CalibrationRecord& record, const CalibrateFlags& flags) {
  try {
    write_file_atomically(flags.out, calibration_text(record));
  } catch (const Error&) {
    print_figures(record, flags);
    throw;
  }
  print_figures(record, flags);
  if (!flags.output.json && !flags.output.quiet) fmt::print("calibration: {}\n", flags.out);
}

std::unique_ptr<CalibrationSite> simulated(const CalibrateFlags& flags) {
  if (!flags.measured.empty()) throw Error("--measured is for a real robot; a simulated one is measured by its truth");
  Scenario scenario = flags.scenario;
  if (!flags.start.empty()) scenario.start = parse_pose(flags.start, "--start");
  check_scenario(scenario);
  return simulated_site(scenario);
}

std::unique_ptr<CalibrationSite> real(const CalibrateFlags& flags, const SerialAddress& address, std::size_t drives) {
  if (!flags.scenario.world.empty() || !flags.start.empty()) {
    throw Error("a real robot is calibrated where it stands; want neither WORLD nor --start with --robot serial");
  }
  if (!flags.measured.empty() && flags.measured.size() != drives) {
    throw Error(
        fmt::format("--measured holds {} words; want one for each of the {} drives", flags.measured.size(), drives));
  }
  return owned_site(address, flags.scenario.model, CalibrationPrompt(std::cin, flags.measured));
}

std::unique_ptr<CalibrationSite> make_site(const CalibrateFlags& flags, std::size_t drives) {
  const RobotAddress address = parse_robot_address(flags.robot);
  if (const auto* serial = std::get_if<SerialAddress>(&address)) return real(flags, *serial, drives);
  if (std::holds_alternative<InSimulation>(address)) return simulated(flags);
  throw Error(fmt::format("--robot is {}; want sim, or serial:PORT: a recording drives nowhere", flags.robot));
}

/// Until it comes to its end, where somebody can clear the way.
void drive(CalibrationSite& site, CalibrationSession& session, CalibrationFigure figure, const EndOfDrive& plan) {
  while (true) {
    site.prepare(figure, plan);
    const Interrupt interrupt(site.stake());
    try {
      return site.drive(session, figure, interrupt.token());
    } catch (const Error& error) {
      if (!site.mistakes_are_human() || interrupt.token().stop_requested()) throw;
      fmt::print(stderr, "{}\n", error.what());
    }
  }
}

/// Until it is plausible, where somebody can measure again.
void measure(CalibrationSite& site, CalibrationSession& session, CalibrationFigure figure, const EndOfDrive& plan) {
  while (true) {
    const EndOfDrive end = site.measure(figure, plan);
    try {
      return session.measure(end);
    } catch (const Error& error) {
      if (!site.mistakes_are_human()) throw;
      fmt::print(stderr, "{}\n", error.what());
    }
  }
}

void calibrate(const CalibrateFlags& flags) {
  check(flags);
  expect_figures(flags.figures);
  const std::vector<CalibrationFigure> figures = figures_of(flags);
  AtomicFiles().add(flags.out, "");  // nobody is to drive and measure in vain
  const std::unique_ptr<CalibrationSite> site = make_site(flags, figures.size());
  CalibrationSession session(site->model(), flags.figures);
  for (const CalibrationFigure figure : figures) {
    const EndOfDrive plan = session.plan(figure);
    drive(*site, session, figure, plan);
    measure(*site, session, figure, plan);
  }
  const CalibrationFit& fit = session.fit();
  const CalibrationRecord record{flags.scenario.model, fit.calibration, fit.deviation, flags.date, session.drives()};
  deliver(record, flags);
}

}  // namespace

void add_calibrate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("calibrate", "Find a robot's wheel and axle factors by drives");
  const auto flags = std::make_shared<CalibrateFlags>();
  command->add_option("WORLD", flags->scenario.world, "world, plan or map to drive a simulated robot in");
  command->add_option("--robot", flags->robot, "sim, or serial:PORT[@BAUD] (sim)");
  command->add_option("--measured", flags->measured,
                      "of a real robot, a word a drive: what would be\ntyped in, as 3 2004 12,-5 -8,1 20");
  command->add_option("--model", flags->scenario.model, "robot, or a file.urdf (roomba-600)");
  command->add_option("--noise", flags->scenario.noise, "how the simulated robot errs: a profile (none)");
  command->add_option("--seed", flags->scenario.seed, "of the simulated robot's errors (1)")->check(whole_number);
  command->add_option("--start", flags->start, "x,y,theta in the world [m, rad]");
  command->add_option("--drives", flags->drives, "comma-separated: spin, straight, square-left,\nsquare-right")
      ->delimiter(',');
  command->add_option("--repeat", flags->repeat, "times to drive them all (1)")->check(whole_number);
  command->add_option("--side", flags->figures.side, "of the squares [m] (1)")->check(number);
  command->add_option("--straight", flags->figures.straight, "how long it is [m] (2)")->check(number);
  command->add_option("--turns", flags->figures.turns, "of a spin, at most (10)")->check(whole_number);
  command->add_option("--out", flags->out, "the file to write (calibration.yaml)");
  command->add_option("--date", flags->date, "to note in it, as 2026-03-31");
  add_output_flags(*command, flags->output);
  command->callback([flags] { calibrate(*flags); });
}

}  // namespace scrubjay::apps
