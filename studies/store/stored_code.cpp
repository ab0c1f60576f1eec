#include "studies/store/stored_code.hpp"

#include "core/estimators/added.hpp"
#include "samplers/outside/added.hpp"
#include "studies/point_files/file_sampler.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace ff::studies {
namespace {

/// Made only where a study has points of files, which a study without could not read anyway.
constexpr const char* point_files_table =
    "CREATE TABLE IF NOT EXISTS point_files(sampler TEXT NOT NULL, part INTEGER NOT NULL, file TEXT NOT NULL, "
    "bytes INTEGER NOT NULL, content BLOB NOT NULL, PRIMARY KEY(sampler, part)) WITHOUT ROWID";

/// Declarations of samplers whose points code from outside makes.
constexpr const char* outside_samplers_table =
    "CREATE TABLE IF NOT EXISTS outside_samplers(sampler TEXT PRIMARY KEY, summary TEXT NOT NULL, details TEXT NOT "
    "NULL, base INTEGER NOT NULL, randomised INTEGER NOT NULL, most_dimension INTEGER NOT NULL, nanoseconds REAL NOT "
    "NULL) WITHOUT ROWID";

/// Made only where a study has such estimators.
constexpr const char* outside_estimators_table =
    "CREATE TABLE IF NOT EXISTS outside_estimators(estimator TEXT PRIMARY KEY, summary TEXT NOT NULL, details TEXT NOT "
    "NULL, sizes INTEGER NOT NULL, randomised INTEGER NOT NULL, nanoseconds REAL NOT NULL) WITHOUT ROWID";

/// Bytes in words, the last filled up with zeros.
std::vector<std::uint64_t> in_words(std::string_view bytes) {
    std::vector<std::uint64_t> words((bytes.size() + 7) / 8);
    if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

void write_file(Database& database, const samplers::AddedSampler& added) {
    database.execute(point_files_table);
    Statement insert(database.handle(), "INSERT OR IGNORE INTO point_files VALUES(?, ?, ?, ?, ?)");
    std::int64_t part = 0;
    for (const auto& [file, bytes] : added.content()) {
        insert.with(added.entry().info.name, part++, file, bytes.size(), in_words(bytes)).run();
    }
}

void write_declaration(Database& database, const samplers::SamplerInfo& info) {
    database.execute(outside_samplers_table);
    Statement(database.handle(), "INSERT OR IGNORE INTO outside_samplers VALUES(?, ?, ?, ?, ?, ?, ?)")
        .with(info.name, info.summary, info.details, info.sizes == samplers::Sizes::powers ? info.base : 0,
              info.randomised, info.most_dimension, info.nanoseconds)
        .run();
}

void write_declaration(Database& database, const EstimatorInfo& info) {
    database.execute(outside_estimators_table);
    Statement(database.handle(), "INSERT OR IGNORE INTO outside_estimators VALUES(?, ?, ?, ?, ?, ?)")
        .with(info.name, info.summary, info.details, info.own_points, info.randomised, info.nanoseconds)
        .run();
}

void restore_files(const Database& database) {
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

/// Whether a table has the cost of points or trials, on which the division into units of work depends; earlier stores
/// do not.
bool has_cost_in(const Database& database, std::string_view table) {
    Statement column(database.handle(), "SELECT 1 FROM pragma_table_info(?) WHERE name = 'nanoseconds'");
    return column.with(table).step();
}

/// Adds the samplers that a store declares. A sampler that is loaded already does not change.
void restore_declarations(const Database& database) {
    const bool has_cost = has_cost_in(database, "outside_samplers");
    Statement rows(database.handle(), "SELECT * FROM outside_samplers");
    while (rows.step()) {
        samplers::SamplerInfo traits;
        if (const std::int64_t base = rows.integer(3); base >= 2) {
            traits.sizes = samplers::Sizes::powers;
            traits.base = static_cast<std::uint32_t>(base);
        }
        traits.randomised = rows.integer(4) != 0;
        if (has_cost) traits.nanoseconds = rows.real(6);
        traits.most_dimension =
            static_cast<std::size_t>(std::clamp<std::int64_t>(rows.integer(5), 1, std::int64_t{max_dimension}));
        samplers::add(std::make_unique<samplers::AddedSampler>(
            samplers::AddedSampler::Texts{rows.text(0), rows.text(1), rows.text(2)}, traits,
            std::vector<std::uint64_t>{}, nullptr));
    }
}

void restore_estimators(const Database& database) {
    const bool has_cost = has_cost_in(database, "outside_estimators");
    Statement rows(database.handle(), "SELECT * FROM outside_estimators");
    while (rows.step()) {
        const double cost = has_cost ? rows.real(5) : 0;
        add(std::make_unique<AddedEstimator>(AddedEstimator::Texts{rows.text(0), rows.text(1), rows.text(2)},
                                             program_traits(rows.integer(3) != 0, rows.integer(4) != 0, cost), nullptr,
                                             nullptr));
    }
}

}  // namespace

void write_outside_code(Database& database, const StudySpec& spec) {
    for (const Method& method : spec.methods) {
        const auto* const sampler = samplers::find_added(method.sampler);
        if (sampler == nullptr) continue;
        if (sampler->content().empty())
            write_declaration(database, sampler->entry().info);
        else
            write_file(database, *sampler);
    }
    for (const Method& method : spec.methods) {
        if (const auto* const estimator = find_added_estimator(method.estimator))
            write_declaration(database, estimator->entry().info);
    }
}

void restore_outside_code(const Database& database) {
    if (database.has_table("point_files")) restore_files(database);
    if (database.has_table("outside_samplers")) restore_declarations(database);
    if (database.has_table("outside_estimators")) restore_estimators(database);
}

}  // namespace ff::studies
