#include "studies/store/store_checks.hpp"

#include "studies/readers/digest.hpp"
#include "studies/store/store_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

/// Bytes of one of a unit's two sums over patches and faces.
std::int64_t bytes_of_sums(const StudyPlan& plan, const WorkUnit& unit) {
    const Cell& cell = plan.cells[unit.cell];
    return static_cast<std::int64_t>(std::uint64_t{cell.subdivision.patches(plan.scenes[cell.scene])} *
                                     plan.scenes.faces(cell.scene).size() * sizeof(std::uint64_t));
}

std::uint64_t digest_of(const WorkUnit& unit, std::span<const std::uint64_t> hits,
                        std::span<const std::uint64_t> hits_squared) {
    return Digest()
        .add(unit.index)
        .add(unit.cell)
        .add(unit.first_trial)
        .add(unit.trials)
        .add(hits)
        .add(hits_squared)
        .value();
}

Digest digest_of(std::string_view observable, std::int64_t from, std::int64_t to, std::uint64_t trial) {
    return Digest()
        .add(observable)
        .add(static_cast<std::uint64_t>(from))
        .add(static_cast<std::uint64_t>(to))
        .add(trial);
}

/// SQLite takes NaN for NULL; the store has a word for it.
constexpr std::string_view no_number = "nan";

std::uint64_t with_value(Digest digest, double value) {
    return std::isnan(value) ? digest.add(no_number).value() : digest.add_number(value).value();
}

/// The saved data of a unit, and the sums over its rows. Sums of digests do not depend on the order of rows.
struct SavedUnit {
    bool saved = false;
    std::uint64_t digest = 0;
    std::int64_t checksum = 0;
    std::size_t first = 0;  ///< place of its first trial among the saved ones of its cell
};

/// Walks over all rows of a store, and refuses what no run has written.
class Rows {
  public:
    Rows(const Database& database, const std::filesystem::path& file, const StudyPlan& plan)
        : database_(database), file_(file), plan_(plan), units_(plan.units.size()), trials_(plan.cells.size()) {}

    void read(Checksums checksums) {
        read_units(checksums);
        read_observations();
    }
    [[nodiscard]] const std::vector<SavedUnit>& units() const { return units_; }

  private:
    const Database& database_;
    const std::filesystem::path& file_;
    const StudyPlan& plan_;
    std::vector<SavedUnit> units_;
    std::vector<std::size_t> trials_;  ///< number of saved trials of each cell
    /// Rays from each face that hit something or were lost, by the place of the trial in the cell that is being read.
    std::map<std::int64_t, std::vector<std::int64_t>> arrived_;

    void read_units(Checksums checksums) {
        const std::string checksum = checksums == Checksums::saved ? "checksum" : "0";
        Statement rows(database_.handle(),
                       fmt::format("SELECT unit, cell, first_trial, trials, patch_hits, patch_hits_squared, {} FROM "
                                   "units ORDER BY unit",
                                   checksum));
        while (rows.step()) {
            const auto index = static_cast<std::size_t>(rows.integer(0));
            const WorkUnit* unit = index < plan_.units.size() ? &plan_.units[index] : nullptr;
            if (unit == nullptr || static_cast<std::size_t>(rows.integer(1)) != unit->cell ||
                static_cast<std::uint64_t>(rows.integer(2)) != unit->first_trial ||
                static_cast<std::uint64_t>(rows.integer(3)) != unit->trials) {
                report_damage(file_,
                              fmt::format("unit {} is none of this study, or another version cut it otherwise", index));
            }
            if (rows.bytes(4) != rows.bytes(5) || (rows.bytes(4) != 0 && rows.bytes(4) != bytes_of_sums(plan_, *unit)))
                report_damage(file_, fmt::format("unit {} has sums of another number of patches", index));
            units_[index] = {true, digest_of(*unit, rows.integers(4), rows.integers(5)), rows.integer(6),
                             trials_[unit->cell]};
            trials_[unit->cell] += unit->trials;
        }
    }

    void read_observations() {
        Statement rows(database_.handle(),
                       "SELECT cell, observable, from_face, to_face, trial, value FROM observations "
                       "ORDER BY cell, observable, from_face, to_face, trial");
        std::int64_t cell = -1;
        while (rows.step()) {
            if (rows.integer(0) != cell) arrived_.clear();
            cell = rows.integer(0);
            read_observation(rows);
        }
    }

    void read_observation(const Statement& row) {
        const auto refuse = [&](std::string_view what) {
            report_damage(file_, fmt::format("'{}' of faces {} and {} in cell {} has {}", row.text(1), row.integer(2),
                                             row.integer(3), row.integer(0), what));
        };
        const auto cell = static_cast<std::size_t>(row.integer(0));
        const auto trial = static_cast<std::uint64_t>(row.integer(4));
        const auto index = unit_of(plan_, cell, trial);
        if (!index || !units_[*index].saved) refuse("values of trials that no unit holds");
        const std::string observable = row.text(1);
        const std::int64_t from = row.integer(2);
        const std::int64_t to = row.integer(3);
        const auto faces = static_cast<std::int64_t>(plan_.scenes.faces(plan_.cells[cell].scene).size());
        const bool known = std::ranges::find(observable::all, observable) != observable::all.end();
        if (!known || from < 1 || from > faces || to < 0 || to > faces) refuse("no such name or face");
        const Digest digest = digest_of(observable, from, to, trial);
        SavedUnit& unit = units_[*index];
        unit.digest += row.is_number(5) ? with_value(digest, row.real(5)) : Digest(digest).add(row.text(5)).value();
        if (observable == observable::estimate || observable == observable::claim) return;
        if (!row.is_number(5) || row.integer(5) < 0) refuse("a negative number");
        std::vector<std::int64_t>& arrived = arrived_[from];
        arrived.resize(trials_[cell]);
        // Rows are in the order of names: numbers of rays come after those of hits and lost rays.
        std::int64_t& sum = arrived[unit.first + (trial - plan_.units[*index].first_trial)];
        if (observable == observable::rays && sum > row.integer(5))
            refuse("fewer rays than have hit something or were lost");
        if (observable != observable::rays && __builtin_add_overflow(sum, row.integer(5), &sum))
            refuse("too large a number");
    }
};

}  // namespace

std::optional<std::size_t> unit_of(const StudyPlan& plan, std::size_t cell, std::uint64_t trial) {
    const auto after = std::upper_bound(
        plan.units.begin(), plan.units.end(), std::pair(cell, trial),
        [](const auto& wanted, const WorkUnit& unit) { return wanted < std::pair(unit.cell, unit.first_trial); });
    if (after == plan.units.begin()) return std::nullopt;
    const WorkUnit& unit = *std::prev(after);
    return unit.cell == cell && trial - unit.first_trial < unit.trials ? std::optional(unit.index) : std::nullopt;
}

std::int64_t checksum(const WorkUnit& unit, const UnitRecord& record) {
    std::uint64_t sum = digest_of(unit, record.patch_hits, record.patch_hits_squared);
    for (const Observation& row : record.observations) {
        const double value = std::visit([](const auto v) { return static_cast<double>(v); }, row.value);
        sum += with_value(digest_of(row.observable, row.from_face, row.to_face, row.trial), value);
    }
    return static_cast<std::int64_t>(sum);
}

void expect_rows_of_plan(const Database& database, const std::filesystem::path& file, const StudyPlan& plan,
                         Checksums checksums) {
    Rows rows(database, file, plan);
    rows.read(checksums);
    if (checksums == Checksums::none) return;
    for (std::size_t unit = 0; unit < rows.units().size(); ++unit) {
        const SavedUnit& found = rows.units()[unit];
        if (found.saved && static_cast<std::int64_t>(found.digest) != found.checksum)
            report_damage(file, fmt::format("unit {} is not as it was saved: its checksum differs", unit));
    }
}

void add_checksums(const Database& database, const std::filesystem::path& file, const StudyPlan& plan) {
    Rows rows(database, file, plan);
    rows.read(Checksums::none);
    Statement update(database.handle(), "UPDATE units SET checksum = ? WHERE unit = ? AND checksum IS NULL");
    for (std::size_t unit = 0; unit < rows.units().size(); ++unit) {
        if (rows.units()[unit].saved) update.with(rows.units()[unit].digest, unit).run();
    }
}

}  // namespace ff::studies
