#pragma once

#include "studies/readers/digest.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/store/records.hpp"
#include "studies/store/sqlite.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

/// Identifies a kind of SQLite file of this program, and its version.
struct StoreFormat {
    FileKind kind;
    std::string_view what;  ///< "result store", for messages
    std::string_view keys;  ///< its table of keys and values, one of them schema_version
    int version;            ///< written by this program
    int oldest;             ///< oldest version that it reads
    const char* schema;     ///< SQL that makes its tables
    const char* to_oldest;  ///< SQL that turns these into the tables that all earlier versions have
};

/// The value of a key; empty where there is none.
std::optional<std::string> stored_value(const Database& database, const StoreFormat& format, std::string_view key);

/// @return its version
/// @throws UserError unless the file is of this format, in a version that this program reads, and its tables are those
///   that the program of that version makes
int expect_readable(const Database& database, const std::filesystem::path& file, const StoreFormat& format);

/// @throws IoError unless SQLite finds every page and row in order
void expect_intact(const Database& database, const std::filesystem::path& file);

/// A sealed file has no log. SQLite would trust one that is placed beside it.
/// @throws IoError where there is one
void expect_no_log_of_another(const std::filesystem::path& file);

/// Opens a file for reading if all of that holds. @throws IoError also where there is none
std::unique_ptr<Database> open_store(const std::filesystem::path& file, const StoreFormat& format);

/// Adds all columns of all rows of a query, with their types.
void add_rows(Digest& digest, const Database& database, std::string_view sql);

// The table `context` of a store, with a checksum of its own: the promise of repeatability does not cover it.

/// Replaces it as a whole; part of the caller's transaction.
void write_context(const Database& database, const Context& context);

Context read_context(const Database& database);

/// @throws IoError where it has changed since it was saved
void expect_sound_context(const Database& database, const std::filesystem::path& file);

[[noreturn]] void report_damage(const std::filesystem::path& file, const std::string& what);

}  // namespace ff::studies
