#include "studies/store/store.hpp"

#include "core/support/error.hpp"
#include "studies/spec/study_difference.hpp"
#include "studies/store/store_checks.hpp"
#include "studies/store/store_format.hpp"
#include "studies/store/stored_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::studies {
namespace {

constexpr const char* result_store_schema = R"(
CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE context(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE cells(cell INTEGER PRIMARY KEY, scene TEXT NOT NULL, method TEXT NOT NULL, sampler TEXT NOT NULL,
  estimator TEXT NOT NULL, patches_per_face INTEGER NOT NULL, samples_per_patch INTEGER NOT NULL,
  trials INTEGER NOT NULL);
CREATE TABLE units(unit INTEGER PRIMARY KEY, cell INTEGER NOT NULL, first_trial INTEGER NOT NULL, trials INTEGER NOT NULL,
  patch_hits BLOB NOT NULL, patch_hits_squared BLOB NOT NULL, checksum INTEGER);
CREATE TABLE observations(cell INTEGER NOT NULL, observable TEXT NOT NULL, from_face INTEGER NOT NULL,
  to_face INTEGER NOT NULL, trial INTEGER NOT NULL, value NUMERIC NOT NULL,
  PRIMARY KEY(cell, observable, from_face, to_face, trial)) WITHOUT ROWID;
)";

constexpr int without_checksums = 1;
constexpr StoreFormat result_store_format{FileKind::result_store,
                                          "result store",
                                          "meta",
                                          store_schema_version,
                                          without_checksums,
                                          result_store_schema,
                                          "ALTER TABLE units DROP COLUMN checksum"};

std::optional<std::string> read_meta(const Database& database, std::string_view key) {
    return stored_value(database, result_store_format, key);
}

void write_meta(const Database& database, std::string_view key, std::string_view value) {
    Statement(database.handle(), "INSERT INTO meta VALUES(?, ?)").with(key, value).run();
}

/// Checksum of the rows that say which study this is.
std::string checksum_of_study(const Database& database) {
    Digest digest;
    add_rows(digest, database, "SELECT * FROM meta WHERE key <> 'checksum' ORDER BY key");
    add_rows(digest, database, "SELECT * FROM cells ORDER BY cell");
    return in_hexadecimal(digest);
}

/// Checks the checksums of the study, its cells and its context. Those of units are checked when their rows are read.
void expect_checksums(const Database& database, const std::filesystem::path& file) {
    if (read_meta(database, "checksum") != checksum_of_study(database))
        report_damage(file, "the study is not as it was saved: its checksum differs");
    expect_sound_context(database, file);
}

bool is_empty(const Database& database) {
    Statement objects(database.handle(), "SELECT count(*) FROM sqlite_master");
    objects.step();
    return objects.integer(0) == 0;
}

void write_cells(const Database& database, const StudyPlan& plan) {
    Statement insert(database.handle(), "INSERT INTO cells VALUES(?, ?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        const Method& method = plan.spec.methods[cell.method];
        insert
            .with(i, plan.scenes.name(cell.scene), method.name, method.sampler, method.estimator,
                  cell.subdivision.per_part(), cell.samples_per_patch, cell.trials)
            .run();
    }
}

constexpr std::string_view of_a_pair = "WHERE cell = ? AND observable = ? AND from_face = ? AND to_face = ?";

std::string difference_from(const Database& database, const StudySpec& wanted) {
    const std::string stored = read_meta(database, "study").value_or("");
    const std::string text = to_toml(wanted);
    if (stored != text) return first_difference(stored, text);
    const bool same_tables =
        read_meta(database, "published").value_or("") == (wanted.published ? wanted.published->text : "");
    return same_tables ? "" : "the published tables";
}

/// No row of a unit that was not saved is in the way.
void insert_observations(const Database& database, std::size_t cell, const std::vector<Observation>& observations) {
    Statement insert(database.handle(), "INSERT OR REPLACE INTO observations VALUES(?, ?, ?, ?, ?, ?)");
    for (const Observation& observation : observations) {
        const auto& [observable, from, to, trial, value] = observation;
        insert.with(cell, observable, from, to, trial);
        if (const auto* const count = std::get_if<std::int64_t>(&value))
            insert.bind(5, *count);
        else if (const double number = std::get<double>(value); !std::isnan(number))
            insert.bind(5, number);
        else
            insert.bind(5, std::string_view("nan"));  // SQLite has infinities, but takes NaN for NULL
        insert.run();
    }
}

/// Unless another process has just done it.
void create(Database& database, const StudyPlan& plan) {
    database.execute("BEGIN IMMEDIATE");
    if (is_empty(database)) {
        database.execute(result_store_schema);
        write_meta(database, "schema_version", std::to_string(store_schema_version));
        write_meta(database, "study", to_toml(plan.spec));
        write_meta(database, "published", plan.spec.published ? plan.spec.published->text : "");
        write_cells(database, plan);
        write_outside_code(database, plan.spec);
        write_meta(database, "checksum", checksum_of_study(database));
        write_context(database, {});
    }
    database.execute("COMMIT");
}

/// Upgrades a store of an earlier version to this one.
void upgrade(Database& database, const std::filesystem::path& file, const StudyPlan& plan) {
    database.execute("BEGIN IMMEDIATE");
    // Another process may just have done it.
    if (stored_value(database, result_store_format, "schema_version") == std::to_string(without_checksums)) {
        database.execute("ALTER TABLE units ADD COLUMN checksum INTEGER");
        add_checksums(database, file, plan);
        database.execute(
            fmt::format("UPDATE meta SET value = '{}' WHERE key = 'schema_version'", store_schema_version).c_str());
        write_meta(database, "checksum", checksum_of_study(database));
        write_context(database, read_context(database));
    }
    database.execute("COMMIT");
}

/// Whether it has checksums; where it has, those of the study hold. @throws UserError, IoError
Checksums look_at(const Database& database, const std::filesystem::path& file) {
    if (expect_readable(database, file, result_store_format) == without_checksums) return Checksums::none;
    expect_checksums(database, file);
    return Checksums::saved;
}

}  // namespace

Store::Store(std::unique_ptr<Database> database, StudyPlan plan)
    : database_(std::move(database)), plan_(std::move(plan)) {}

Store Store::create_or_resume(const std::filesystem::path& file, const StudyPlan& plan,
                              std::optional<Journal> wanted_journal) {
    const Journal journal = wanted_journal ? *wanted_journal : journal_in(file.parent_path());
    expect_no_log_of_another(file);
    auto database = std::make_unique<Database>(file, Database::Mode::create_or_open);
    if (is_empty(*database)) create(*database, plan);
    // A log that is not of this file would be written into it on closing.
    database->keep_log_on_close(true);
    expect_readable(*database, file, result_store_format);
    expect_same_study(*database, file, plan.spec);
    expect_intact(*database, file);
    const Checksums checksums = look_at(*database, file);
    expect_rows_of_plan(*database, file, plan, checksums);
    database->keep_log_on_close(false);
    if (checksums == Checksums::none) upgrade(*database, file, plan);
    Store store(std::move(database), plan);
    store.was_checked_ = checksums == Checksums::saved;
    if (!store.is_complete()) {
        // With a write-ahead log a killed run loses at most the unit that it was saving.
        store.database_->execute_in_turn(journal == Journal::write_ahead
                                             ? "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"
                                             : "PRAGMA journal_mode = DELETE; PRAGMA synchronous = FULL");
        store.database_->execute(fmt::format("PRAGMA cache_size = -{}", page_cache_bytes / 1024).c_str());
    }
    return store;
}

Store Store::open(const std::filesystem::path& file) {
    auto database = open_store(file, result_store_format);
    const Checksums checksums = look_at(*database, file);
    restore_outside_code(*database);
    StudySpec spec = parse_study(read_meta(*database, "study").value_or(""), file.string() + " (stored study)");
    if (spec.published) spec.published->text = read_meta(*database, "published").value_or("");
    StudyPlan plan = plan_study(std::move(spec));
    expect_rows_of_plan(*database, file, plan, checksums);
    Store store(std::move(database), std::move(plan));
    store.was_checked_ = checksums == Checksums::saved;
    return store;
}

void Store::commit(const UnitRecord& record) {
    const WorkUnit& unit = plan_.units.at(record.unit);
    if (database_->has_moved()) {
        throw IoError("{}: moved or removed while the study ran. What was saved is in it.", database_->file());
    }
    database_->execute("BEGIN IMMEDIATE");
    Statement(database_->handle(), "INSERT INTO units VALUES(?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING")
        .with(unit.index, unit.cell, unit.first_trial, unit.trials, record.patch_hits, record.patch_hits_squared,
              checksum(unit, record))
        .run();
    if (database_->changes() > 0) insert_observations(*database_, unit.cell, record.observations);
    database_->execute("COMMIT");
}

void Store::set_context(const Context& context) {
    database_->execute("BEGIN IMMEDIATE");
    write_context(*database_, context);
    database_->execute("COMMIT");
}

bool Store::seal() {
    return database_->execute_unless_busy("PRAGMA journal_mode = DELETE");
}

void add_context(Context& all, const Context& more) {
    for (const auto& [key, value] : more) {
        std::string& known = all[key];
        const std::string wrapped = "; " + known + "; ";
        if (wrapped.find("; " + value + "; ") != std::string::npos) continue;
        known += known.empty() ? value : "; " + value;
    }
}

Context Store::context() const {
    return read_context(*database_);
}

std::vector<bool> Store::finished_units() const {
    std::vector<bool> finished(plan_.units.size(), false);
    Statement query(database_->handle(), "SELECT unit FROM units");
    while (query.step()) finished.at(static_cast<std::size_t>(query.integer(0))) = true;
    return finished;
}

bool Store::is_complete() const {
    const auto finished = finished_units();
    return std::ranges::find(finished, false) == finished.end();
}

std::vector<std::uint64_t> Store::saved_trial_numbers(std::size_t cell) const {
    std::vector<std::uint64_t> numbers;
    Statement query(database_->handle(), "SELECT first_trial, trials FROM units WHERE cell = ? ORDER BY first_trial");
    query.with(cell);
    while (query.step()) {
        const auto first = static_cast<std::uint64_t>(query.integer(0));
        const auto count = static_cast<std::uint64_t>(query.integer(1));
        for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(first + i);
    }
    return numbers;
}

std::uint64_t Store::saved_trials(std::size_t cell) const {
    Statement query(database_->handle(), "SELECT coalesce(sum(trials), 0) FROM units WHERE cell = ?");
    query.with(cell).step();
    return static_cast<std::uint64_t>(query.integer(0));
}

Store::Series Store::series(std::size_t cell, std::string_view observable, int from_face, int to_face) const {
    Statement query(database_->handle(),
                    fmt::format("SELECT trial, value FROM observations {} ORDER BY trial", of_a_pair));
    query.with(cell, observable, from_face, to_face);
    Series series;
    while (query.step()) {
        series.trial.push_back(static_cast<std::uint64_t>(query.integer(0)));
        series.value.push_back(query.is_number(1) ? query.real(1) : std::numeric_limits<double>::quiet_NaN());
    }
    return series;
}

bool Store::has(std::size_t cell, std::string_view observable) const {
    Statement query(database_->handle(), "SELECT 1 FROM observations WHERE cell = ? AND observable = ? LIMIT 1");
    return query.with(cell, observable).step();
}

std::int64_t Store::total(std::size_t cell, std::string_view observable, int from_face, int to_face) const {
    Statement query(database_->handle(), fmt::format("SELECT coalesce(sum(value), 0) FROM observations {}", of_a_pair));
    query.with(cell, observable, from_face, to_face);
    query.step();
    return query.integer(0);
}

std::string difference_of_study(const std::filesystem::path& file, const StudySpec& wanted) {
    expect_no_log_of_another(file);
    const Database database(file, Database::Mode::read_only);
    if (is_empty(database)) return {};  // left by a run that ended before it began
    expect_readable(database, file, result_store_format);
    return difference_from(database, wanted);
}

void expect_same_study(const Database& database, const std::filesystem::path& file, const StudySpec& wanted) {
    const std::string difference = difference_from(database, wanted);
    if (difference.empty()) return;
    throw UserError("{}: holds another study (differs in {}). Choose another --out, or remove the folder.",
                    file.string(), difference);
}

}  // namespace ff::studies
