#include "studies/store_checks.hpp"

#include "studies/store_format.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

namespace ff::studies {
namespace {

/// Bytes of one of a unit's two sums over patches and faces.
std::int64_t bytes_of_sums(const StudyPlan& plan, const WorkUnit& unit) {
    const Cell& cell = plan.cells[unit.cell];
    const Scene& scene = plan.scenes[cell.scene];
    return static_cast<std::int64_t>(std::uint64_t{cell.subdivision.patches(scene)} * scene.faces.size() *
                                     sizeof(std::uint64_t));
}

/// @return trials that are saved of each cell
std::vector<std::int64_t> check_units(const Database& database, const std::filesystem::path& file,
                                      const StudyPlan& plan) {
    std::vector<std::int64_t> saved(plan.cells.size(), 0);
    Statement units(database.handle(),
                    "SELECT unit, cell, first_trial, trials, length(patch_hits), length(patch_hits_squared) FROM units "
                    "ORDER BY unit");
    while (units.step()) {
        const auto index = static_cast<std::size_t>(units.integer(0));
        const WorkUnit* unit = index < plan.units.size() ? &plan.units[index] : nullptr;
        if (unit == nullptr || static_cast<std::size_t>(units.integer(1)) != unit->cell ||
            static_cast<std::uint64_t>(units.integer(2)) != unit->first_trial ||
            static_cast<std::uint64_t>(units.integer(3)) != unit->trials) {
            report_damage(file,
                          fmt::format("unit {} is none of this study, or another version cut it otherwise", index));
        }
        const std::int64_t sums = units.integer(4);
        if (sums != units.integer(5) || (sums != 0 && sums != bytes_of_sums(plan, *unit)))
            report_damage(file, fmt::format("unit {} has sums of another number of patches", index));
        saved[unit->cell] += units.integer(3);
    }
    return saved;
}

}  // namespace

void expect_rows_of_plan(const Database& database, const std::filesystem::path& file, const StudyPlan& plan) {
    const std::vector<std::int64_t> saved = check_units(database, file, plan);
    Statement series(database.handle(),
                     "SELECT cell, observable, from_face, to_face, count(*), "
                     "min(CASE WHEN observable IN ('hits', 'rays', 'lost') THEN value ELSE 0 END) "
                     "FROM observations GROUP BY cell, observable, from_face, to_face");
    while (series.step()) {
        const auto cell = static_cast<std::size_t>(series.integer(0));
        const std::string what = fmt::format("'{}' of faces {} and {} in cell {}", series.text(1), series.integer(2),
                                             series.integer(3), series.integer(0));
        if (cell >= saved.size() || series.integer(4) > saved[cell])
            report_damage(file, fmt::format("{} has values of trials that no unit holds", what));
        if (series.real(5) < 0) report_damage(file, fmt::format("{} has a negative number", what));
    }
}

}  // namespace ff::studies
