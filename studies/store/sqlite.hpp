#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace ff::studies {

/// A prepared statement. Parameters and columns count from 0.
class Statement {
  public:
    Statement(sqlite3* database, std::string_view sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    Statement& bind(int parameter, std::int64_t value);
    Statement& bind(int parameter, double value);
    Statement& bind(int parameter, std::string_view value);
    Statement& bind(int parameter,
                    std::span<const std::uint64_t> values);  ///< binds a blob of little-endian 64-bit integers

    /// Binds these values to the parameters, from the first one on: flags and whole numbers of any type as integers.
    template <class... Values>
    Statement& with(const Values&... values) {
        int parameter = 0;
        (bind_as_stored(parameter++, values), ...);
        return *this;
    }

    /// True where there is a row to read.
    bool step();
    /// Runs a statement without rows and resets it for the next use.
    void run();

    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] bool is_number(int column) const;
    [[nodiscard]] int columns() const;
    [[nodiscard]] std::int64_t bytes(int column) const;  ///< length of a text or blob, in bytes
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::vector<std::uint64_t> integers(int column) const;

  private:
    template <class Value>
    void bind_as_stored(int parameter, const Value& value) {
        if constexpr (std::is_integral_v<Value>)
            bind(parameter, static_cast<std::int64_t>(value));
        else if constexpr (std::is_convertible_v<const Value&, std::string_view>)
            bind(parameter, std::string_view(value));
        else
            bind(parameter, value);
    }
    void check(int status) const;
    sqlite3* database_;
    sqlite3_stmt* statement_ = nullptr;
};

/// The name of a file for SQLite: absolute, since "file:x" would be read as a URI. @throws IoError where it is too
/// long
std::string sqlite_name(const std::filesystem::path& file);

/// One SQLite file. Every failure is an IoError that names it; a UserError where it is not an SQLite file at all.
class Database {
  public:
    enum class Mode { create_or_open, read_only };
    Database(const std::filesystem::path& file, Mode mode);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    void execute(const char* sql) const;
    /// The same; false where another program has the file open and prevents it.
    [[nodiscard]] bool execute_unless_busy(const char* sql);
    /// The same; waits even where SQLite would refuse at once because two programs wait for each other.
    void execute_in_turn(const char* sql);
    /// Runs `copy` as one transaction, with the tables of another SQLite file readable as source.TABLE.
    void copy_from(const std::filesystem::path& source, const std::function<void()>& copy) const;
    [[nodiscard]] bool has_table(std::string_view name) const;
    /// Number of rows that the last statement inserted.
    [[nodiscard]] std::int64_t changes() const;
    /// Whether a write-ahead log keeps its contents when the file is closed.
    void keep_log_on_close(bool keep);
    /// Whether the file is no longer where it was opened. SQLite would silently continue writing to it.
    [[nodiscard]] bool has_moved() const;
    /// The path as opened, made absolute; empty for a database in memory.
    [[nodiscard]] std::string file() const;
    [[nodiscard]] sqlite3* handle() const { return handle_; }

  private:
    sqlite3* handle_ = nullptr;
};

/// How SQLite makes transactions atomic. A write-ahead log is faster but needs memory shared between processes, which
/// network file systems do not offer; a fully synchronised rollback journal works everywhere.
enum class Journal { write_ahead, rollback };

/// Chooses by the type that statfs(2) names: a rollback journal on network and user-space file systems.
Journal journal_for(std::uint64_t file_system_type);

/// The journal for files in this folder. @throws IoError where the system does not tell
Journal journal_in(const std::filesystem::path& folder);

}  // namespace ff::studies
