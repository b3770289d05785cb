#include "sqlite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace scrubjay {
namespace {

[[noreturn]] void fail_with(sqlite3* database, const std::string& name, Error::Kind kind) {
  const std::string what = sqlite3_errmsg(database);
  throw Error(fmt::format("{}: cannot {} the bag: {}", name, kind == Error::Kind::Input ? "read" : "write", what),
              kind);
}

/// A path as SQLite's URIs have it.
std::string uri_of(const std::filesystem::path& path, std::string_view query) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    if (c == '%' || c == '?' || c == '#') {
      uri += fmt::format("%{:02X}", static_cast<unsigned>(c));
    } else {
      uri += c;
    }
  }
  return uri.append(query);
}

/// Bytes of the file and of its log that wasn't written back yet.
std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return 0;
  std::filesystem::path log = path;
  log += "-wal";
  const std::uintmax_t more = std::filesystem::file_size(log, error);
  return error ? size : size + more;
}

}  // namespace

void SqliteStatement::check(int result) const {
  if (result != SQLITE_OK) fail_with(sqlite3_db_handle(statement_.get()), name_, kind_);
}

void SqliteStatement::bind(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), parameter, value));
}

void SqliteStatement::bind(int parameter, std::string_view value) {
  // A text without an address is NULL.
  const char* text = value.empty() ? "" : value.data();
  check(sqlite3_bind_text64(statement_.get(), parameter, text, value.size(), SQLITE_STATIC, SQLITE_UTF8));
}

void SqliteStatement::bind(int parameter, std::span<const std::byte> value) {
  const void* bytes = value.empty() ? "" : static_cast<const void*>(value.data());
  check(sqlite3_bind_blob64(statement_.get(), parameter, bytes, value.size(), SQLITE_STATIC));
}

bool SqliteStatement::step() {
  const int result = sqlite3_step(statement_.get());
  if (result != SQLITE_ROW && result != SQLITE_DONE) {
    fail_with(sqlite3_db_handle(statement_.get()), name_, kind_);
  }
  return result == SQLITE_ROW;
}

void SqliteStatement::run() {
  step();
  check(sqlite3_reset(statement_.get()));
}

std::optional<std::int64_t> SqliteStatement::integer(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_INTEGER) return std::nullopt;
  return sqlite3_column_int64(statement_.get(), column);
}

std::optional<std::string_view> SqliteStatement::text(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_TEXT) return std::nullopt;
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (text == nullptr) return std::nullopt;
  return std::string_view(text, static_cast<std::size_t>(size));
}

std::optional<std::span<const std::byte>> SqliteStatement::blob(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_BLOB) return std::nullopt;
  const auto* bytes = static_cast<const std::byte*>(sqlite3_column_blob(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  if (bytes == nullptr) return std::span<const std::byte>();  // an empty one
  return std::span(bytes, static_cast<std::size_t>(size));
}

Sqlite::Sqlite(const std::string& uri, int flags, std::string name, Error::Kind kind)
    : name_(std::move(name)), kind_(kind) {
  sqlite3* database = nullptr;
  const int result = sqlite3_open_v2(uri.c_str(), &database, flags | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK) fail();
}

Sqlite Sqlite::make(const std::filesystem::path& path) {
  return {uri_of(path, ""), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, path.string(), Error::Kind::Failure};
}

Sqlite Sqlite::open(const std::filesystem::path& path) {
  constexpr int kPatience = 2000;  // with somebody who writes to it just now [ms]
  constexpr std::uintmax_t kLeastLimit = 1 << 20;
  const auto limit = static_cast<int>(std::clamp<std::uintmax_t>(size_of(path), kLeastLimit, 1'000'000'000));
  const auto guarded = [&](std::string_view query) {
    Sqlite database(uri_of(path, query), SQLITE_OPEN_READONLY, path.string(), Error::Kind::Input);
    sqlite3* handle = database.database_.get();
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, limit);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_busy_timeout(handle, kPatience);
    return database;
  };
  Sqlite database = guarded("");
  // A log beside it wants a file made beside it; in a folder that takes none, the file is read without the log.
  if (!database.readable()) database = guarded("?immutable=1");
  database.run("SELECT count(*) FROM sqlite_master");
  return database;
}

bool Sqlite::readable() {
  const int result = sqlite3_exec(database_.get(), "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr);
  return result != SQLITE_CANTOPEN && result != SQLITE_READONLY;
}

void Sqlite::fail() const {
  fail_with(database_.get(), name_, kind_);
}

void Sqlite::run(const char* statements) {
  if (sqlite3_exec(database_.get(), statements, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

SqliteStatement Sqlite::prepare(std::string_view statement) {
  sqlite3_stmt* prepared = nullptr;
  const int result =
      sqlite3_prepare_v2(database_.get(), statement.data(), static_cast<int>(statement.size()), &prepared, nullptr);
  if (result != SQLITE_OK) fail();
  return {prepared, name_, kind_};
}

bool Sqlite::has_column(std::string_view table, std::string_view column) {
  // Views and virtual tables, whose rows are worked out while they are read, have no page of their own.
  SqliteStatement found = prepare(
      "SELECT 1 FROM sqlite_master AS tables JOIN pragma_table_info(tables.name) AS columns "
      "WHERE tables.type = 'table' AND tables.name = ? AND tables.rootpage > 0 AND columns.name = ?");
  found.bind(1, table);
  found.bind(2, column);
  return found.step();
}

}  // namespace scrubjay
