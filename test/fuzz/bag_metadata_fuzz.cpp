/// \file
/// Any text is a metadata.yaml that names files in its own folder alone, or is refused with an Error of one line; and
/// it is a quality of service that reads back as it was written.
#include <algorithm>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  const std::string text(data, data + size);
  const ros::Qos qos = parse_qos(text);
  if (qos.depth < 1 || parse_qos(qos_text(qos)) != qos) std::abort();
  try {
    const BagFolder folder = parse_bag_folder(text, "fuzz");
    const auto leads_elsewhere = [](const std::string& file) {
      return file.empty() || file == "." || file == ".." || file.find('/') != std::string::npos;
    };
    if (std::any_of(folder.files.begin(), folder.files.end(), leads_elsewhere)) std::abort();
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
