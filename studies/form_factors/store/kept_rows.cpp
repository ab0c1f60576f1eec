#include "studies/form_factors/store/kept_rows.hpp"

#include "core/support/error.hpp"
#include "studies/form_factors/store/stored_request.hpp"
#include "studies/readers/digest.hpp"

#include <fmt/format.h>

namespace ff::studies::form_factors {
namespace {

constexpr const char* kept_rows_schema = R"(
CREATE TABLE matrix(key TEXT PRIMARY KEY, value NOT NULL) WITHOUT ROWID;
CREATE TABLE rows(face INTEGER PRIMARY KEY, samples BLOB NOT NULL, checksum TEXT NOT NULL);
)";
constexpr int kept_rows_schema_version = 4;
constexpr StoreFormat kept_rows_format{
    FileKind::kept_rows,      "file of sampled rows", "matrix", kept_rows_schema_version,
    kept_rows_schema_version, kept_rows_schema,       "",
};

std::string checksum_of_row(std::span<const std::uint64_t> words) {
    return in_hexadecimal(Digest().add(words));
}

void expect_same(const std::filesystem::path& file, const std::pair<SceneSource, Request>& there,
                 const SceneSource& source, const Request& request) {
    const std::string difference = difference_between(there.first, there.second, source, request);
    if (difference.empty()) return;
    throw UserError(
        "{}: rows of another matrix ({}). Resume with the scene and options that it was begun with, or choose "
        "another --out.",
        file.string(), difference);
}

}  // namespace

KeptRows::KeptRows(const std::filesystem::path& file, const SceneSource& source, const Request& request)
    : file_(file), database_(file, Database::Mode::create_or_open) {
    // Safe whatever happens to the process; if the machine fails, checksums show it.
    database_.execute("PRAGMA synchronous = OFF; BEGIN IMMEDIATE");
    Statement tables(database_.handle(), "SELECT count(*) FROM sqlite_master");
    tables.step();
    if (tables.integer(0) == 0) {
        database_.execute(kept_rows_schema);
        write_request(database_, kept_rows_format, source, request);
    }
    database_.execute("COMMIT");
    expect_readable(database_, file, kept_rows_format);
    expect_same(file, read_request(StoredKeys(database_, kept_rows_format, file)), source, request);
}

void KeptRows::keep(const SampledRow& row) const {
    const std::vector<std::uint64_t> words = to_words(row);
    Statement insert(database_.handle(), "INSERT OR IGNORE INTO rows VALUES(?, ?, ?)");
    run_with(insert, row.row, words, checksum_of_row(words));
}

void KeptRows::read(const std::function<void(SampledRow)>& receive) const {
    Statement query(database_.handle(), "SELECT face, samples, checksum FROM rows ORDER BY face");
    while (query.step()) {
        const std::vector<std::uint64_t> words = query.integers(1);
        std::optional<SampledRow> row = sampled_row(words);
        if (!row || row->row != query.integer(0) || checksum_of_row(words) != query.text(2))
            report_damage(file_, fmt::format("row {} is not as it was saved", query.integer(0)));
        receive(std::move(*row));
    }
}

void KeptRows::take(const std::filesystem::path& file) const {
    const auto [source, request] = read_request(StoredKeys(database_, kept_rows_format, file_));
    expect_same(file, matrix_of_kept_rows(file), source, request);
    database_.copy_from(file, [&] { database_.execute("INSERT OR IGNORE INTO rows SELECT * FROM source.rows"); });
}

std::vector<std::uint32_t> KeptRows::faces() const {
    std::vector<std::uint32_t> faces;
    Statement query(database_.handle(), "SELECT face FROM rows ORDER BY face");
    while (query.step()) faces.push_back(static_cast<std::uint32_t>(query.integer(0)));
    return faces;
}

std::pair<SceneSource, Request> matrix_of_kept_rows(const std::filesystem::path& file) {
    const auto database = open_store(file, kept_rows_format);
    return read_request(StoredKeys(*database, kept_rows_format, file));
}

}  // namespace ff::studies::form_factors
