#include "urdf_model.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <scrubjay/error.hpp>

#include "file_content.hpp"

namespace scrubjay {
namespace {

/// Keeps urdfdom's complaints: the last one is the reason.
class LastComplaint : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override { last_ = text; }
  const std::string& last() const { return last_; }

 private:
  std::string last_;
};

}  // namespace

UrdfFile read_urdf(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_file(path);
  UrdfFile file{std::string(bytes.begin(), bytes.end()), nullptr};
  LastComplaint complaint;
  console_bridge::useOutputHandler(&complaint);
  file.model = urdf::parseURDF(file.text);
  console_bridge::restorePreviousOutputHandler();
  if (!file.model) {
    const std::string reason = complaint.last().substr(0, complaint.last().find('\n'));
    throw Error(fmt::format("{}: {}; want a URDF robot", path.string(), reason.empty() ? "it isn't XML" : reason));
  }
  return file;
}

}  // namespace scrubjay
