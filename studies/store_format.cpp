#include "studies/store_format.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

namespace ff::studies {
namespace {

bool has_table(const Database& database, std::string_view table) {
    Statement query(database.handle(), "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
    return query.bind(0, table).step();
}

}  // namespace

std::optional<std::string> stored_value(const Database& database, const StoreFormat& format, std::string_view key) {
    Statement query(database.handle(), fmt::format("SELECT value FROM {} WHERE key = ?", format.keys));
    query.bind(0, key);
    return query.step() ? std::optional(query.text(0)) : std::nullopt;
}

void expect_readable(const Database& database, const std::filesystem::path& file, const StoreFormat& format) {
    if (!has_table(database, format.keys)) {
        throw UserError(fmt::format("{}: not a {} (no table '{}'). Give a file written by ffstudy.", file.string(),
                                    format.what, format.keys));
    }
    const std::string version = stored_value(database, format, "schema_version").value_or("none");
    if (version != std::to_string(format.version)) {
        throw UserError(
            fmt::format("{}: schema version {} (this program reads {}). Use the version of ffstudy that wrote it.",
                        file.string(), version, format.version));
    }
}

void expect_intact(const Database& database, const std::filesystem::path& file) {
    Statement check(database.handle(), "PRAGMA quick_check(1)");
    const std::string found = check.step() ? check.text(0) : "no answer";
    if (found != "ok") report_damage(file, found);
}

std::unique_ptr<Database> open_store(const std::filesystem::path& file, const StoreFormat& format) {
    if (!std::filesystem::is_regular_file(file)) {
        throw IoError(fmt::format("{}: no such file. Give a folder or file written by ffstudy.", file.string()));
    }
    auto database = std::make_unique<Database>(file, Database::Mode::read_only);
    expect_readable(*database, file, format);
    expect_intact(*database, file);
    return database;
}

void report_damage(const std::filesystem::path& file, const std::string& what) {
    throw IoError(
        fmt::format("{}: damaged ({}). Take a copy, or remove it and run the study again.", file.string(), what));
}

}  // namespace ff::studies
