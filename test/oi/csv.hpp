/// \file
/// Tables of facts in CSV, where they are present.
#pragma once

#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace scrubjay::oi {

/// Fields of a line; a field in quotes may hold commas, and quotes written twice.
inline std::vector<std::string> csv_fields(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c != '\r') {
      fields.back() += c;
    }
  }
  return fields;
}

/// Rows by the names in the first line; empty if there is no such file.
inline std::vector<std::map<std::string, std::string>> csv_rows(const std::string& name) {
  std::ifstream file(SCRUBJAY_SHARED_DATA "/../oi/" + name);
  std::vector<std::map<std::string, std::string>> rows;
  std::string line;
  std::vector<std::string> names;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i == 0) rows.emplace_back();
      rows.back()[names[i]] = i < fields.size() ? fields[i] : "";
    }
  }
  return rows;
}

}  // namespace scrubjay::oi
