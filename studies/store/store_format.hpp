#pragma once

#include "studies/readers/file_kind.hpp"
#include "studies/store/sqlite.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

/// What tells one kind of SQLite file of this program from another, and its versions from each other.
struct StoreFormat {
    FileKind kind;
    std::string_view what;  ///< "result store", for messages
    std::string_view keys;  ///< its table of keys and values, one of them schema_version
    int version;            ///< that this program writes
    int oldest;             ///< that it reads
    const char* schema;     ///< SQL that makes its tables
    const char* to_oldest;  ///< SQL that makes the oldest version's of these
};

/// The value of a key; empty where there is none.
std::optional<std::string> stored_value(const Database& database, const StoreFormat& format, std::string_view key);

/// @return its version
/// @throws UserError unless the file is of this format, in a version that this program reads, and its tables are those
///   that the program of that version makes
int expect_readable(const Database& database, const std::filesystem::path& file, const StoreFormat& format);

/// @throws IoError unless SQLite finds every page and row in order
void expect_intact(const Database& database, const std::filesystem::path& file);

/// A file that was made whole has no log. SQLite would believe one that is put beside it.
/// @throws IoError where there is one
void expect_no_log_of_another(const std::filesystem::path& file);

/// Opens a file to read it, when all of that holds. @throws IoError also where there is none
std::unique_ptr<Database> open_store(const std::filesystem::path& file, const StoreFormat& format);

[[noreturn]] void report_damage(const std::filesystem::path& file, const std::string& what);

}  // namespace ff::studies
