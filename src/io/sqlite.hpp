/// \file
/// A SQLite database, its statements, and what is refused of one that anybody may have made.
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <scrubjay/error.hpp>
#include <span>
#include <string>
#include <string_view>

namespace scrubjay {

/// A statement of SQL. What it is bound to must live until it has run.
class SqliteStatement {
 public:
  /// Parameters are numbered from 1.
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, std::string_view value);
  void bind(int parameter, std::span<const std::byte> value);

  /// Goes on to the next row; false if there is none. Throws Error.
  bool step();
  /// Runs one that gives no row, and makes it ready to be run again. Throws Error.
  void run();

  /// Of the row, columns from 0 on; none where it holds another type, or NULL. Text and bytes are valid until the next
  /// step.
  std::optional<std::int64_t> integer(int column) const;
  std::optional<std::string_view> text(int column) const;
  std::optional<std::span<const std::byte>> blob(int column) const;

 private:
  friend class Sqlite;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  SqliteStatement(sqlite3_stmt* statement, const std::string& name, Error::Kind kind)
      : statement_(statement), name_(name), kind_(kind) {}
  void check(int result) const;

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  std::string name_;
  Error::Kind kind_;
};

class Sqlite {
 public:
  /// A new one, in a file that isn't there. Throws Error (Kind::Failure), as all that is done with it does.
  static Sqlite make(const std::filesystem::path& path);
  /// One to read, which may be anybody's: nothing in it is run but plain tables' reading, and no value takes more
  /// memory than its file has bytes. Throws Error, as all that is done with it does.
  static Sqlite open(const std::filesystem::path& path);

  /// Runs statements without values.
  void run(const char* statements);
  SqliteStatement prepare(std::string_view statement);
  /// Whether there is such a table, of rows that stand in the file, with such a column.
  bool has_column(std::string_view table, std::string_view column);

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  };
  Sqlite(const std::string& uri, int flags, std::string name, Error::Kind kind);
  [[noreturn]] void fail() const;
  bool readable();

  std::unique_ptr<sqlite3, Close> database_;
  std::string name_;
  Error::Kind kind_;
};

}  // namespace scrubjay
