/// \file
/// The command line: finds the subcommand, and turns what goes wrong into one line and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <scrubjay/error.hpp>
#include <scrubjay/nearest_word.hpp>
#include <string>

#include "commands.hpp"

namespace scrubjay::apps {
namespace {

int complain(const std::string& what, int code) {
  fmt::print(stderr, "scrubjay: {}\n", what);
  return code;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Refuses a word that is no command, and says which one is like it: CLI11 would only say that it wasn't expected.
void expect_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw Error(fmt::format("there is no command '{}'; did you mean '{}'? See scrubjay --help", word,
                          nearest_word(word, {names.begin(), names.end()})));
}

int run(int argc, char** argv) {
  CLI::App app("Maps rooms with robots that can barely see.", "scrubjay");
  app.set_version_flag("--version", "scrubjay " SCRUBJAY_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(26);
  add_explore(app);
  add_replay(app);
  add_compare(app);
  add_render(app);
  add_score(app);
  add_info(app);
  if (argc < 2) {
    fmt::print(stderr, "{}", app.help());
    return kWrongInput;
  }
  const std::string word = argv[1];
  expect_command(app, word);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return complain(fmt::format("{}; see scrubjay {}--help", first_line(error.what()),
                                word.starts_with('-') ? "" : word + " "),
                    kWrongInput);
  }
  return kSuccess;
}

}  // namespace
}  // namespace scrubjay::apps

int main(int argc, char** argv) {
  using scrubjay::Error;
  using namespace scrubjay::apps;
  try {
    return run(argc, argv);
  } catch (const Error& error) {
    return complain(error.what(), error.kind() == Error::Kind::Input ? kWrongInput : kFailure);
  } catch (const std::bad_alloc&) {
    return complain("out of memory", kFailure);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailure);
  }
}
