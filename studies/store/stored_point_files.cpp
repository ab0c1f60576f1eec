#include "studies/store/stored_point_files.hpp"

#include "samplers/added.hpp"
#include "studies/point_files/file_sampler.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

/// Made only where a study has points of files, which a study without could not read anyway.
constexpr const char* point_files_table =
    "CREATE TABLE IF NOT EXISTS point_files(sampler TEXT NOT NULL, part INTEGER NOT NULL, file TEXT NOT NULL, "
    "bytes INTEGER NOT NULL, content BLOB NOT NULL, PRIMARY KEY(sampler, part)) WITHOUT ROWID";

/// Bytes in words, the last filled up with zeros.
std::vector<std::uint64_t> in_words(std::string_view bytes) {
    std::vector<std::uint64_t> words((bytes.size() + 7) / 8);
    if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

}  // namespace

void write_point_files(Database& database, const StudySpec& spec) {
    for (const Method& method : spec.methods) {
        const auto* const added = samplers::find_added(method.sampler);
        if (added == nullptr || added->content().empty()) continue;
        database.execute(point_files_table);
        Statement insert(database.handle(), "INSERT OR IGNORE INTO point_files VALUES(?, ?, ?, ?, ?)");
        std::int64_t part = 0;
        for (const auto& [file, bytes] : added->content()) {
            const auto words = in_words(bytes);
            insert.bind(0, std::string_view(method.sampler))
                .bind(1, part++)
                .bind(2, std::string_view(file))
                .bind(3, static_cast<std::int64_t>(bytes.size()))
                .bind(4, std::span<const std::uint64_t>(words))
                .run();
        }
    }
}

void restore_point_files(const Database& database) {
    Statement table(database.handle(), "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'point_files'");
    if (!table.step()) return;
    std::map<std::string, samplers::AddedSampler::Content> contents;
    Statement rows(database.handle(), "SELECT sampler, file, bytes, content FROM point_files ORDER BY sampler, part");
    while (rows.step()) {
        const auto words = rows.integers(3);
        std::string bytes(words.size() * 8, '\0');
        if (!words.empty()) std::memcpy(bytes.data(), words.data(), bytes.size());
        bytes.resize(std::min(bytes.size(), static_cast<std::size_t>(std::max<std::int64_t>(rows.integer(2), 0))));
        contents[rows.text(0)].emplace_back(rows.text(1), std::move(bytes));
    }
    for (auto& [sampler, content] : contents) restore_point_file(sampler, std::move(content));
}

}  // namespace ff::studies
