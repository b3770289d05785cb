#include "report_rows.hpp"

#include <fmt/format.h>

namespace scrubjay::apps {
namespace {

constexpr std::size_t kWidth = 79;
constexpr std::size_t kIndent = 14;

}  // namespace

std::string wrapped(std::string_view begin, std::string_view text) {
  std::string out(begin);
  std::size_t column = begin.size();
  bool line_begins = true;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t size = end - at;
    if (!line_begins && column + 1 + size > kWidth) {
      out += '\n' + std::string(begin.size(), ' ');
      column = begin.size();
      line_begins = true;
    }
    if (!line_begins) out += ' ';
    column += size + (line_begins ? 0 : 1);
    out.append(text, at, size);
    line_begins = false;
    at = end + 1;
  }
  return out + '\n';
}

std::string row(std::string_view name, std::string_view text) {
  return wrapped(fmt::format("{:<{}}", name, kIndent), text);
}

std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += wrapped(finding.kind == Finding::Kind::Problem ? "problem: " : "note: ", finding.what);
    if (!finding.advice.empty()) text += wrapped("   try: ", finding.advice);
  }
  if (healthy(findings)) text += "healthy\n";
  return text;
}

nlohmann::json findings_json(const std::vector<Finding>& findings) {
  nlohmann::json json = nlohmann::json::array();
  for (const Finding& finding : findings) {
    json.push_back({{"kind", finding.kind == Finding::Kind::Problem ? "problem" : "remark"},
                    {"what", finding.what},
                    {"advice", finding.advice}});
  }
  return json;
}

}  // namespace scrubjay::apps
