/// \file
/// Databases that a test makes, changes or looks into by itself.
#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace scrubjay {

/// Runs statements on a database, which is made where there is none; gives what its rows hold, columns by `|`, rows by
/// line.
inline std::string sql(const std::filesystem::path& path, const std::string& statements) {
  sqlite3* database = nullptr;
  std::string rows;
  const auto add_row = [](void* to, int count, char** values, char**) {
    auto& text = *static_cast<std::string*>(to);
    for (int i = 0; i < count; ++i) text += (i > 0 ? "|" : "") + std::string(values[i] != nullptr ? values[i] : "NULL");
    text += '\n';
    return 0;
  };
  sqlite3_open(path.c_str(), &database);
  sqlite3_exec(database, "PRAGMA synchronous = OFF", nullptr, nullptr, nullptr);
  const bool done = sqlite3_exec(database, statements.c_str(), add_row, &rows, nullptr) == SQLITE_OK;
  const std::string what = sqlite3_errmsg(database);
  sqlite3_close(database);
  if (!done) throw std::runtime_error(what);
  return rows;
}

}  // namespace scrubjay
