#include "studies/store/store_format.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <map>

namespace ff::studies {
namespace {

using Definitions = std::map<std::string, std::string>;  // SQL by table

Definitions definitions(const Database& database) {
    Definitions all;
    Statement query(database.handle(), "SELECT name, sql FROM sqlite_master WHERE type = 'table'");
    while (query.step()) all[query.text(0)] = query.text(1);
    return all;
}

/// A table that is a view, or computes its columns, would not only be read.
void expect_own_tables(const Database& database, const std::filesystem::path& file, const StoreFormat& format,
                       int version) {
    Database model(":memory:", Database::Mode::create_or_open);
    model.execute(format.schema);
    if (version < format.version) model.execute(format.to_oldest);
    const Definitions there = definitions(database);
    for (const auto& [table, sql] : definitions(model)) {
        const auto found = there.find(table);
        if (found != there.end() && found->second == sql) continue;
        throw UserError("{}: not a {} (table '{}' is {}). Give a file written by ffstudy.", file.string(), format.what,
                        table, found == there.end() ? "missing" : "defined otherwise");
    }
}

/// The kind of file in words; empty for a regular file.
std::string_view kind_of_no_file(std::filesystem::file_type type) {
    switch (type) {
        case std::filesystem::file_type::regular:
            return {};
        case std::filesystem::file_type::directory:
            return "a folder, not a file";
        case std::filesystem::file_type::fifo:
            return "a FIFO, not a file";
        case std::filesystem::file_type::not_found:
            return "no such file";
        default:
            return "a device or socket, not a file";
    }
}

void expect_file(const std::filesystem::path& file) {
    std::error_code error;
    const auto type = std::filesystem::status(file, error).type();
    const bool unknown = type == std::filesystem::file_type::none;
    const std::string_view what = kind_of_no_file(type);
    if (what.empty()) return;
    throw IoError("{}: {}. Give a folder or file written by ffstudy.", file.string(), unknown ? error.message() : what);
}

/// @throws UserError for a file of another kind that commands take
void expect_no_other_kind(const std::filesystem::path& file, const StoreFormat& format) {
    std::array<char, 1 << 16> start{};
    std::ifstream in(file, std::ios::binary);
    in.read(start.data(), start.size());
    expect_kind(format.kind, {start.data(), static_cast<std::size_t>(in.gcount())}, file);
}

std::string checksum_of_context(const Database& database) {
    Digest digest;
    add_rows(digest, database, "SELECT * FROM context WHERE key <> 'checksum' ORDER BY key");
    return in_hexadecimal(digest);
}

}  // namespace

std::optional<std::string> stored_value(const Database& database, const StoreFormat& format, std::string_view key) {
    Statement query(database.handle(), fmt::format("SELECT value FROM {} WHERE key = ?", format.keys));
    return query.with(key).step() ? std::optional(query.text(0)) : std::nullopt;
}

int expect_readable(const Database& database, const std::filesystem::path& file, const StoreFormat& format) {
    if (!database.has_table(format.keys)) {
        throw UserError("{}: not a {} (no table '{}'). Give a file written by ffstudy.", file.string(), format.what,
                        format.keys);
    }
    const std::string stored = stored_value(database, format, "schema_version").value_or("none");
    int version = format.oldest;
    while (version <= format.version && stored != std::to_string(version)) ++version;
    if (version > format.version) {
        throw UserError(
            "{}: schema version {} (this program reads {}{}). Use the version of ffstudy that "
            "wrote it.",
            file.string(), stored, format.oldest < format.version ? fmt::format("{} to ", format.oldest) : "",
            format.version);
    }
    expect_own_tables(database, file, format, version);
    return version;
}

void expect_intact(const Database& database, const std::filesystem::path& file) {
    Statement check(database.handle(), "PRAGMA quick_check(1)");
    const std::string found = check.step() ? check.text(0) : "no answer";
    if (found != "ok") report_damage(file, found);
}

void expect_no_log_of_another(const std::filesystem::path& file) {
    // https://sqlite.org/fileformat2.html#file_format_version_numbers
    constexpr std::string_view magic{"SQLite format 3\0", 16};
    constexpr std::size_t read_version = magic.size() + 3;
    constexpr char without_log = 1;
    std::string begin(read_version + 1, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (!in || !begin.starts_with(magic) || begin[read_version] != without_log) return;
    const std::filesystem::path log = file.string() + "-wal";
    std::error_code none;
    if (std::filesystem::file_size(log, none) == 0 || none) return;
    throw IoError(
        "{}: a log beside a file that was made whole (it has none, so the log is of another). Remove the "
        "log, if {} is what you want to keep.",
        log.string(), file.filename().string());
}

std::unique_ptr<Database> open_store(const std::filesystem::path& file, const StoreFormat& format) {
    expect_file(file);
    expect_no_other_kind(file, format);
    expect_no_log_of_another(file);
    auto database = std::make_unique<Database>(file, Database::Mode::read_only);
    expect_readable(*database, file, format);
    expect_intact(*database, file);
    return database;
}

void add_rows(Digest& digest, const Database& database, std::string_view sql) {
    Statement rows(database.handle(), sql);
    while (rows.step()) {
        for (int column = 0; column < rows.columns(); ++column) {
            const bool number = rows.is_number(column);
            digest.add(number ? 1 : 0);
            if (number)
                digest.add_number(rows.real(column)).add(static_cast<std::uint64_t>(rows.integer(column)));
            else
                digest.add(rows.text(column));
        }
    }
}

void write_context(const Database& database, const Context& context) {
    Statement(database.handle(), "DELETE FROM context").run();
    Statement insert(database.handle(), "INSERT INTO context VALUES(?, ?)");
    for (const auto& [key, value] : context) insert.with(key, value).run();
    insert.with("checksum", checksum_of_context(database)).run();
}

Context read_context(const Database& database) {
    Context context;
    Statement query(database.handle(), "SELECT key, value FROM context WHERE key <> 'checksum'");
    while (query.step()) context[query.text(0)] = query.text(1);
    return context;
}

void expect_sound_context(const Database& database, const std::filesystem::path& file) {
    Statement stored(database.handle(), "SELECT value FROM context WHERE key = 'checksum'");
    if (!stored.step() || stored.text(0) != checksum_of_context(database))
        report_damage(file, "the context is not as it was saved: its checksum differs");
}

void report_damage(const std::filesystem::path& file, const std::string& what) {
    throw IoError("{}: damaged ({}). Take a copy, or remove it and run the study again.", file.string(), what);
}

}  // namespace ff::studies
