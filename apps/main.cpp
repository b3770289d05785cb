/// \file
/// The command line: finds the subcommand, and turns what goes wrong into one line and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <scrubjay/error.hpp>
#include <scrubjay/nearest_word.hpp>
#include <string>
#include <vector>

#include "commands.hpp"
#include "ros_node.hpp"

namespace scrubjay::apps {
namespace {

int complain(const std::string& what, int code) {
  // Not by fmt::print, which throws where nobody listens any more, as on a terminal that is gone.
  std::fputs(fmt::format("scrubjay: {}\n", what).c_str(), stderr);
  return code;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string no_flag(const CLI::App& command, const std::string& word) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return fmt::format("there is no flag '{}'; did you mean '{}'?", word,
                     nearest_word(word, {flags.begin(), flags.end()}));
}

/// Refuses a word that is no command, and says which one is like it: CLI11 would only say that it wasn't expected.
void expect_command(const CLI::App& app, const std::string& word) {
  if (word.starts_with('-')) {
    if (app.get_option_no_throw(word) == nullptr) throw Error(no_flag(app, word) + " See scrubjay --help");
    return;
  }
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  throw Error(fmt::format("there is no command '{}'; did you mean '{}'? See scrubjay --help", word,
                          nearest_word(word, {names.begin(), names.end()})));
}

/// What is wrong with words that a command doesn't take.
std::string unexpected(const CLI::App& command) {
  const std::vector<std::string> words = command.remaining();
  const auto is_flag = [](const std::string& word) { return word.starts_with('-'); };
  const auto flag = std::find_if(words.begin(), words.end(), is_flag);
  return flag == words.end() ? fmt::format("'{}' is one word too many", words.front()) : no_flag(command, *flag);
}

/// Throws Error if what was printed didn't get where it should, such as to a disc that is full.
void expect_printed() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Error(fmt::format("cannot write the output: {}", std::strerror(errno)), Error::Kind::Failure);
}

int run(std::vector<std::string> words) {
  CLI::App app("Maps rooms with robots that can barely see.", "scrubjay");
  app.set_version_flag("--version", "scrubjay " SCRUBJAY_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(26);
  add_explore(app);
  add_replay(app);
  add_compare(app);
  add_calibrate(app);
  add_emulate(app);
  add_bridge(app);
  add_record(app);
  add_tap(app);
  add_render(app);
  add_rooms(app);
  add_score(app);
  add_info(app);
  add_doctor(app);
  add_drive(app);
  take_ros_words(words);
  if (words.empty()) {
    fmt::print(stderr, "{}", app.help());
    return kWrongInput;
  }
  const std::string word = words.front();
  expect_command(app, word);
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    const CLI::App& command = word.starts_with('-') ? app : *app.get_subcommand(word);
    const bool extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
    const std::string what = extra ? unexpected(command) : first_line(error.what());
    return complain(fmt::format("{}{} scrubjay {}--help", what, what.ends_with('?') ? " See" : "; see",
                                word.starts_with('-') ? "" : word + " "),
                    kWrongInput);
  }
  expect_printed();
  return kSuccess;
}

}  // namespace
}  // namespace scrubjay::apps

int main(int argc, char** argv) {
  using scrubjay::Error;
  using namespace scrubjay::apps;
  // A limit on file sizes is to end in a message, as a full disc does.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run({argv + 1, argv + argc});
  } catch (const Error& error) {
    return complain(error.what(), error.kind() == Error::Kind::Input ? kWrongInput : kFailure);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", kFailure);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailure);
  }
}
