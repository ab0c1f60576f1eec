#include "studies/form_factors/store/store.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/contract.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/form_factors/store/stored_request.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/store/store_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Faces count from 1. The view has the columns of matrix.csv, in both directions.
constexpr const char* form_factor_schema = R"(
CREATE TABLE about(key TEXT PRIMARY KEY, value NOT NULL) WITHOUT ROWID;
CREATE TABLE context(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE faces(face INTEGER PRIMARY KEY, name TEXT NOT NULL, area REAL NOT NULL, row_sum REAL NOT NULL,
  row_sum_low REAL NOT NULL, row_sum_high REAL NOT NULL, excludes_one INTEGER NOT NULL);
CREATE TABLE pairs(from_face INTEGER NOT NULL, to_face INTEGER NOT NULL, exchange_area REAL NOT NULL, low REAL NOT NULL,
  high REAL NOT NULL, method TEXT NOT NULL, reason TEXT NOT NULL, samples INTEGER NOT NULL, clipped INTEGER NOT NULL,
  within INTEGER NOT NULL, contradicted INTEGER NOT NULL, PRIMARY KEY(from_face, to_face)) WITHOUT ROWID;
CREATE TABLE repaired(from_face INTEGER NOT NULL, to_face INTEGER NOT NULL, factor REAL NOT NULL,
  PRIMARY KEY(from_face, to_face)) WITHOUT ROWID;
CREATE TABLE dropped(face INTEGER PRIMARY KEY, pairs INTEGER NOT NULL, factor REAL NOT NULL, low REAL NOT NULL,
  high REAL NOT NULL);
CREATE TABLE randomisations(from_face INTEGER NOT NULL, to_face INTEGER NOT NULL, rays_of INTEGER, hidden REAL NOT NULL,
  factors BLOB NOT NULL, PRIMARY KEY(from_face, to_face)) WITHOUT ROWID;
CREATE TABLE warnings(warning TEXT NOT NULL);
CREATE VIEW form_factors AS
  SELECT a.name AS "from", b.name AS "to", exchange_area / a.area AS factor, low / a.area AS low, high / a.area AS high,
    max(high - exchange_area, exchange_area - low) / a.area AS half_width, method, reason, samples, clipped, within
  FROM (SELECT from_face AS i, to_face AS j, * FROM pairs
        UNION ALL SELECT to_face, from_face, * FROM pairs WHERE from_face <> to_face)
  JOIN faces AS a ON a.face = i JOIN faces AS b ON b.face = j;
)";

/// Version of the tables; docs/form-factors.md describes them.
constexpr int matrix_schema_version = 4;
constexpr int without_checksum = 1;
constexpr StoreFormat form_factor_format{FileKind::form_factor_store,
                                         "matrix of form factors",
                                         "about",
                                         matrix_schema_version,
                                         without_checksum,
                                         form_factor_schema,
                                         "DROP TABLE dropped; DROP TABLE randomisations"};

std::int64_t integer(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}

std::string checksum_of_matrix(const Database& database) {
    Digest digest;
    for (const std::string_view sql :
         {"SELECT * FROM about WHERE key <> 'checksum' ORDER BY key", "SELECT * FROM faces ORDER BY face",
          "SELECT * FROM pairs ORDER BY from_face, to_face", "SELECT * FROM repaired ORDER BY from_face, to_face",
          "SELECT warning FROM warnings ORDER BY rowid"})
        add_rows(digest, database, sql);
    // Earlier versions lack these tables.
    if (stored_value(database, form_factor_format, "drop"))
        add_rows(digest, database, "SELECT * FROM dropped ORDER BY face");
    if (stored_value(database, form_factor_format, "randomisations"))
        add_rows(digest, database, "SELECT * FROM randomisations ORDER BY from_face, to_face");
    return in_hexadecimal(digest);
}

void write_about(const Database& database, const KeptMatrix& kept) {
    write_request(database, form_factor_format, kept.source, kept.request);
    const Matrix& matrix = kept.matrix;
    Statement insert(database.handle(), "INSERT INTO about VALUES(?, ?)");
    const auto write = [&](std::string_view key, auto value) { run_with(insert, key, value); };
    write("entry_level", matrix.entry_level);
    write("surfaces", matrix.surfaces);
    write("samples", matrix.samples);
    write("rays", matrix.rays);
    write("lost_rays", matrix.lost_rays);
    write("interrupted", matrix.interrupted);
    if (matrix.leak > 0) write("leak", matrix.leak);
    if (!matrix.randomisations.empty()) write("randomisations", matrix.randomisations.size());
    if (matrix.repaired) write("repair_possible", matrix.repaired->possible);
}

void write_faces(const Database& database, const KeptMatrix& kept) {
    const Scene& scene = kept.scene;
    Statement insert(database.handle(), "INSERT INTO faces VALUES(?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < scene.faces.size(); ++i) {
        const RowSum& row = kept.matrix.rows[i];
        run_with(insert, i + 1, scene.faces[i], kept.matrix.areas[i], row.value, row.low, row.high, row.excludes_one);
    }
}

void write_dropped(const Database& database, const Matrix& matrix) {
    Statement insert(database.handle(), "INSERT INTO dropped VALUES(?, ?, ?, ?, ?)");
    for (std::size_t face = 0; face < matrix.faces(); ++face) {
        const DroppedExchange& sum = matrix.rows[face].dropped;
        if (sum.pairs > 0) run_with(insert, face + 1, sum.pairs, sum.value, sum.low, sum.high);
    }
}

void write_pairs(const Database& database, const Matrix& matrix) {
    Statement insert(database.handle(), "INSERT INTO pairs VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const FaceExchange& pair : matrix.exchanges) {
        run_with(insert, pair.from + 1, pair.to + 1, pair.value, pair.low, pair.high, method_of(pair), reason_of(pair),
                 pair.samples, pair.clipped, pair.within, pair.contradicted);
    }
}

/// The values are single numbers, two in each word of the blob.
void write_randomisations(const Database& database, const Matrix& matrix) {
    Statement insert(database.handle(), "INSERT INTO randomisations VALUES(?, ?, ?, ?, ?)");
    for (const PairRandomisations& pair : matrix.randomisations) {
        const auto words = std::bit_cast<std::array<std::uint64_t, randomisations / 2>>(pair.values);
        insert.with(pair.from + 1, pair.to + 1, pair.rays_of ? *pair.rays_of + 1 : 0, static_cast<double>(pair.hidden))
            .bind(4, std::span<const std::uint64_t>(words))
            .run();
    }
}

void write_repaired(const Database& database, const Matrix::Sparse& factors) {
    Statement insert(database.handle(), "INSERT INTO repaired VALUES(?, ?, ?)");
    for (Eigen::Index i = 0; i < factors.outerSize(); ++i) {
        for (Matrix::Sparse::InnerIterator entry(factors, i); entry; ++entry)
            run_with(insert, i + 1, entry.col() + 1, entry.value());
    }
}

/// Reads one file, and refuses what no run has written.
class MatrixReader {
    std::filesystem::path file_;
    std::unique_ptr<Database> database_;

    StoredKeys about_{*database_, form_factor_format, file_};

    void expect(bool sound, std::string_view what) const { about_.expect(sound, what); }

  public:
    explicit MatrixReader(const std::filesystem::path& file)
        : file_(file), database_(open_store(file, form_factor_format)) {}

    KeptMatrix read() const {
        KeptMatrix kept;
        kept.was_checked =
            stored_value(*database_, form_factor_format, "schema_version") != std::to_string(without_checksum);
        if (kept.was_checked) expect_checksums();
        std::tie(kept.source, kept.request) = read_request(about_);
        kept.scene = with_added_faces(make_scene(kept.source), kept.request.surroundings);
        read_matrix(kept.matrix);
        read_faces(kept.matrix, kept.scene);
        read_pairs(kept.matrix);
        if (kept.request.drop > 0) read_dropped(kept.matrix);
        if (about_.has("randomisations")) read_randomisations(kept.matrix);
        read_repaired(kept);
        Statement warnings(database_->handle(), "SELECT warning FROM warnings ORDER BY rowid");
        while (warnings.step()) kept.warnings.push_back(warnings.text(0));
        kept.context = read_context(*database_);
        return kept;
    }

  private:
    void expect_checksums() const {
        if (stored_value(*database_, form_factor_format, "checksum") != checksum_of_matrix(*database_))
            report_damage(file_, "it is not as it was saved: its checksum differs");
        expect_sound_context(*database_, file_);
    }

    void read_matrix(Matrix& matrix) const {
        matrix.entry_level = about_.real("entry_level");
        matrix.surfaces = about_.count("surfaces");
        matrix.samples = about_.count("samples");
        matrix.rays = about_.count("rays");
        matrix.lost_rays = about_.count("lost_rays");
        matrix.interrupted = about_.count("interrupted") != 0;
        if (about_.has("leak")) matrix.leak = about_.real("leak");
    }

    void read_faces(Matrix& matrix, const Scene& scene) const {
        Statement query(database_->handle(),
                        "SELECT face, name, area, row_sum, row_sum_low, row_sum_high, excludes_one FROM faces "
                        "ORDER BY face");
        while (query.step()) {
            const std::size_t i = matrix.areas.size();
            expect(i < scene.faces.size() && query.integer(0) == integer(i + 1) && query.text(1) == scene.faces[i],
                   "a face");
            matrix.areas.push_back(query.real(2));
            matrix.rows.push_back({query.real(3), query.real(4), query.real(5), query.integer(6) != 0});
            expect(matrix.areas.back() > 0 && std::isfinite(matrix.areas.back()), "an area");
        }
        expect(matrix.areas.size() == scene.faces.size(), "a number of faces");
    }

    /// Index of a face by the number in a column.
    [[nodiscard]] std::size_t face(const Statement& query, int column, std::size_t faces) const {
        const std::int64_t number = query.integer(column);
        expect(number >= 1 && number <= integer(faces), "a number of a face");
        return static_cast<std::size_t>(number - 1);
    }

    static std::pair<std::size_t, std::size_t> place(const FaceExchange& pair) { return {pair.from, pair.to}; }

    void read_pairs(Matrix& matrix) const {
        Statement query(database_->handle(),
                        "SELECT from_face, to_face, exchange_area, low, high, samples, clipped, within, contradicted, "
                        "method, reason FROM pairs ORDER BY from_face, to_face");
        while (query.step()) {
            const std::size_t from = face(query, 0, matrix.faces());
            const std::size_t to = face(query, 1, matrix.faces());
            expect(from <= to && (matrix.exchanges.empty() || place(matrix.exchanges.back()) < std::pair(from, to)),
                   "a pair");
            FaceExchange& pair = matrix.exchanges.emplace_back(no_exchange(from, to));
            pair.value = query.real(2);
            pair.low = query.real(3);
            pair.high = query.real(4);
            pair.samples = static_cast<std::uint64_t>(query.integer(5));
            pair.clipped = query.integer(6) != 0;
            pair.within = query.integer(7) != 0;
            pair.contradicted = query.integer(8) != 0;
            expect(0 <= pair.low && pair.low <= pair.value && pair.value <= pair.high && std::isfinite(pair.high),
                   "an interval");
            expect(set_method(pair, query.text(9), query.text(10)), "a method");
        }
    }

    void read_dropped(Matrix& matrix) const {
        Statement query(database_->handle(), "SELECT face, pairs, factor, low, high FROM dropped ORDER BY face");
        while (query.step()) {
            DroppedExchange& sum = matrix.rows[face(query, 0, matrix.faces())].dropped;
            expect(query.integer(1) > 0, "a number of pairs");
            sum = {static_cast<std::uint64_t>(query.integer(1)), query.real(2), query.real(3), query.real(4)};
            expect(0 <= sum.low && sum.low <= sum.value && sum.value <= sum.high && std::isfinite(sum.high),
                   "a sum of what was dropped");
            matrix.dropped += sum.pairs;
        }
        expect(matrix.dropped % 2 == 0, "a number of pairs");
        matrix.dropped /= 2;
    }

    void read_randomisations(Matrix& matrix) const {
        Statement query(database_->handle(),
                        "SELECT from_face, to_face, rays_of, hidden, factors FROM randomisations "
                        "ORDER BY from_face, to_face");
        auto next = matrix.exchanges.begin();
        while (query.step()) {
            PairRandomisations& pair = matrix.randomisations.emplace_back();
            pair.from = static_cast<std::uint32_t>(face(query, 0, matrix.faces()));
            pair.to = static_cast<std::uint32_t>(face(query, 1, matrix.faces()));
            if (query.integer(2) != 0) pair.rays_of = static_cast<std::uint32_t>(face(query, 2, matrix.faces()));
            pair.hidden = static_cast<float>(query.real(3));
            next = std::find_if(next, matrix.exchanges.end(), [&](const FaceExchange& exchange) {
                return exchange.from == pair.from && exchange.to == pair.to;
            });
            std::array<std::uint64_t, randomisations / 2> words{};
            const std::vector<std::uint64_t> stored = query.integers(4);
            expect(next != matrix.exchanges.end() && stored.size() == words.size() && pair.hidden >= 0,
                   "values of a pair");
            std::copy(stored.begin(), stored.end(), words.begin());
            pair.values = std::bit_cast<std::array<float, randomisations>>(words);
            expect(std::ranges::all_of(pair.values, [](float value) { return std::isfinite(value); }),
                   "values of a pair");
        }
    }

    void read_repaired(KeptMatrix& kept) const {
        if (!stored_value(*database_, form_factor_format, "repair_possible")) return;
        kept.request.repair = true;
        const auto n = static_cast<Eigen::Index>(kept.matrix.faces());
        std::vector<Eigen::Triplet<double>> entries;
        Statement query(database_->handle(), "SELECT from_face, to_face, factor FROM repaired");
        while (query.step()) {
            const std::size_t from = face(query, 0, kept.matrix.faces());
            const std::size_t to = face(query, 1, kept.matrix.faces());
            entries.emplace_back(static_cast<int>(from), static_cast<int>(to), query.real(2));
        }
        Matrix::Sparse factors(n, n);
        factors.setFromTriplets(entries.begin(), entries.end());
        kept.matrix.repaired = compare_repaired(kept.matrix, factors, about_.count("repair_possible") != 0);
    }
};

}  // namespace

void save_matrix(const std::filesystem::path& file, const KeptMatrix& kept) {
    FF_EXPECT(!std::filesystem::exists(file) || std::filesystem::is_empty(file));
    Database database(file, Database::Mode::create_or_open);
    database.execute("PRAGMA journal_mode = OFF; BEGIN IMMEDIATE");  // an unfinished file is useless
    database.execute(form_factor_schema);
    write_about(database, kept);
    write_faces(database, kept);
    write_pairs(database, kept.matrix);
    write_dropped(database, kept.matrix);
    write_randomisations(database, kept.matrix);
    if (kept.matrix.repaired) write_repaired(database, kept.matrix.repaired->factors);
    Statement warning(database.handle(), "INSERT INTO warnings VALUES(?)");
    for (const std::string& text : kept.warnings) run_with(warning, text);
    write_context(database, kept.context);
    Statement checksum(database.handle(), "INSERT INTO about VALUES('checksum', ?)");
    run_with(checksum, checksum_of_matrix(database));
    database.execute("COMMIT");
}

KeptMatrix load_matrix(const std::filesystem::path& file) {
    return MatrixReader(file).read();
}

}  // namespace ff::studies::form_factors
