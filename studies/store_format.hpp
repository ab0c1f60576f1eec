#pragma once

#include "studies/sqlite.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ff::studies {

/// What tells one kind of SQLite file of this program from another, and its versions from each other.
struct StoreFormat {
    std::string_view what;  ///< "result store", for messages
    std::string_view keys;  ///< its table of keys and values, one of them schema_version
    int version;            ///< that this program reads and writes
};

/// The value of a key; empty where there is none.
std::optional<std::string> stored_value(const Database& database, const StoreFormat& format, std::string_view key);

/// @throws UserError unless the file is of this format, in the version that this program reads
void expect_readable(const Database& database, const std::filesystem::path& file, const StoreFormat& format);

/// @throws IoError unless SQLite finds every page and row in order
void expect_intact(const Database& database, const std::filesystem::path& file);

/// Opens a file to read it, when both holds. @throws IoError also where there is none
std::unique_ptr<Database> open_store(const std::filesystem::path& file, const StoreFormat& format);

[[noreturn]] void report_damage(const std::filesystem::path& file, const std::string& what);

}  // namespace ff::studies
