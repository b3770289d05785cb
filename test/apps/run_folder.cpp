#include "run_folder.hpp"

#include <io/temporary_folder.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/trajectory_file.hpp>

namespace scrubjay {

namespace fs = std::filesystem;

const std::set<std::string> kRunFiles{"ground_truth.tum", "map.pgm",       "map.png",     "map.yaml",
                                      "metrics.json",     "scenario.yaml", "timing.json", "trajectory.tum"};

Contents contents_of(const fs::path& folder, bool temporary) {
  Contents contents;
  if (!fs::exists(folder)) return contents;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    if (!temporary && entry.path().filename().string().starts_with(".scrubjay-")) continue;
    contents[name] = entry.is_directory() ? "folder" : content_of(entry.path());
  }
  return contents;
}

Contents repeatable(Contents contents) {
  contents.erase("timing.json");
  return contents;
}

std::set<std::string> names_of(const Contents& contents) {
  std::set<std::string> names;
  for (const auto& [name, content] : contents) names.insert(name);
  return names;
}

namespace {

/// Whether the pixels are as many as the head of a PGM says, and nothing follows.
bool is_whole_pgm(const std::string& text) {
  int width = 0, height = 0, largest = 0, head = 0;
  if (std::sscanf(text.c_str(), "P5\n%d %d\n%d%n", &width, &height, &largest, &head) != 3) return false;
  return text.size() ==
         static_cast<std::size_t>(head) + 1 + static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void expect_whole(const fs::path& folder, const std::string& name, const std::string& content) {
  const auto expect = [](bool holds, const char* what) {
    if (!holds) throw std::runtime_error(what);
  };
  expect(!content.empty(), "is empty");
  if (name.ends_with(".pgm")) expect(is_whole_pgm(content), "has not the pixels that it announces");
  if (name.ends_with(".png")) {
    expect(content.ends_with(std::string("IEND\xae\x42\x60\x82")), "has no end");
    read_image(folder / name);
  }
  if (name.ends_with(".json")) {
    expect(nlohmann::json::parse(content).is_object() && content.ends_with("}\n"), "isn't one JSON object");
  }
  if (name.ends_with(".tum")) {
    expect(content.ends_with("\n"), "ends within a line");
    read_trajectory(folder / name);
  }
  if (name == "map.yaml") {
    expect(content.find("free_thresh") != content.npos && content.ends_with("\n"), "has no end");
    read_map(folder / name);
  }
  if (name == "scenario.yaml") {
    expect(content.find("max_time") != content.npos && content.ends_with("\n"), "has no end");
    read_scenario(folder / name);
  }
}

}  // namespace

std::string broken_result(const fs::path& folder) {
  for (const auto& [name, content] : contents_of(folder, false)) {
    if (!kRunFiles.contains(name) && name != "reference.tum") return name + " is none of a run's files";
    try {
      expect_whole(folder, name, content);
    } catch (const std::exception& error) {
      return name + ": " + error.what();
    }
  }
  return {};
}

nlohmann::json metrics_of(const fs::path& folder) {
  return nlohmann::json::parse(content_of(folder / "metrics.json"));
}

}  // namespace scrubjay
