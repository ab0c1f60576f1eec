#pragma once

#include "studies/plan/plan.hpp"
#include "studies/store/records.hpp"
#include "studies/store/sqlite.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::studies {

/// Version of the tables in a store; docs/results.md describes them.
inline constexpr int store_schema_version = 2;

/// Adds new values: each different value of a key once, in order, separated by "; ".
void add_context(Context& all, const Context& more);

/// The saved result of a study: its spec, and the trial records. One SQLite file; one transaction per work unit.
class Store {
  public:
    /// Memory that SQLite may use for pages while a study is run.
    static constexpr std::uint64_t page_cache_bytes = 64ULL << 20;

    /// Creates the file for this plan, or opens it to resume.
    /// @param journal  empty: what suits the file system
    /// @throws UserError where the file belongs to another study, with what differs; IoError
    static Store create_or_resume(const std::filesystem::path& file, const StudyPlan& plan,
                                  std::optional<Journal> journal = std::nullopt);
    /// Opens an existing file to read. @throws UserError where it is not a store, or a newer one; IoError where it is
    /// damaged or cannot be read
    static Store open(const std::filesystem::path& file);

    /// Saves a unit in one transaction; saving it again changes nothing. @throws IoError; then nothing of it is saved
    void commit(const UnitRecord& record);
    void set_context(const Context& context);
    /// Leaves one self-contained file, which can be read even in a read-only folder. @return false where another
    /// program has the file open: then its log stays beside it
    bool seal();

    [[nodiscard]] const StudyPlan& plan() const { return plan_; }
    [[nodiscard]] const Database& database() const { return *database_; }
    /// False where an earlier version wrote the file: damage may then have gone unnoticed.
    [[nodiscard]] bool was_checked() const { return was_checked_; }
    [[nodiscard]] Context context() const;
    /// Which of plan().units are saved, by index.
    [[nodiscard]] std::vector<bool> finished_units() const;
    /// Whether all units are saved.
    [[nodiscard]] bool is_complete() const;
    /// Numbers of the trials of a cell that are saved, ascending.
    [[nodiscard]] std::vector<std::uint64_t> saved_trial_numbers(std::size_t cell) const;
    /// The number of these trials.
    [[nodiscard]] std::uint64_t saved_trials(std::size_t cell) const;

    /// Values of one observable of one pair of faces (numbers from 1; 0 for none), by ascending trial. Values that are
    /// not numbers come back as NaN.
    struct Series {
        std::vector<std::uint64_t> trial;
        std::vector<double> value;
    };
    [[nodiscard]] Series series(std::size_t cell, std::string_view observable, int from_face, int to_face) const;
    /// Whether a cell has any value of an observable.
    [[nodiscard]] bool has(std::size_t cell, std::string_view observable) const;
    /// Sum over all trials of an observable of a pair; 0 where there is none.
    [[nodiscard]] std::int64_t total(std::size_t cell, std::string_view observable, int from_face, int to_face) const;

  private:
    Store(std::unique_ptr<Database> database, StudyPlan plan);
    std::unique_ptr<Database> database_;
    StudyPlan plan_;
    bool was_checked_ = true;
};

/// The difference between a store's study and another one; empty where they are the same. @throws UserError, IoError
std::string difference_of_study(const std::filesystem::path& file, const StudySpec& wanted);

/// @throws UserError unless the store, read from `file`, is of this study, with what differs
void expect_same_study(const Database& database, const std::filesystem::path& file, const StudySpec& wanted);

}  // namespace ff::studies
