#include "studies/run/merge.hpp"

#include "core/support/error.hpp"
#include "studies/run/parallel.hpp"
#include "studies/run/work.hpp"
#include "studies/store/store_checks.hpp"
#include "studies/trials/until.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace ff::studies {
namespace {

using Units = std::vector<bool>;

/// A walk over the rows of some units of one store.
class Rows {
  public:
    Rows(const Store& store, std::string_view sql, const Units& wanted)
        : plan_(store.plan()), wanted_(wanted), query_(store.database().handle(), sql) {}

    /// The next row of a wanted unit, as text; empty at the end. The first two columns are cell and trial.
    std::optional<std::string> next() {
        while (!ended_ && query_.step()) {
            unit_ = *unit_of(plan_, static_cast<std::size_t>(query_.integer(0)),
                             static_cast<std::uint64_t>(query_.integer(1)));
            if (wanted_[unit_]) return query_.text(2);
        }
        ended_ = true;  // another step would begin again
        return std::nullopt;
    }
    [[nodiscard]] std::size_t unit() const { return unit_; }

  private:
    const StudyPlan& plan_;
    const Units& wanted_;
    Statement query_;
    std::size_t unit_ = 0;
    bool ended_ = false;
};

/// @throws UserError where one of these units differs between two stores
void expect_equal(const Store& a, const Store& b, const Units& units, const std::filesystem::path& name) {
    for (const std::string_view sql :
         {"SELECT cell, first_trial, hex(patch_hits) || '|' || hex(patch_hits_squared) FROM units ORDER BY unit",
          "SELECT cell, trial, format('%s|%d|%d|%s|%!.17g', observable, from_face, to_face, typeof(value), value) "
          "FROM observations ORDER BY cell, observable, from_face, to_face, trial"}) {
        Rows rows_a(a, sql, units);
        Rows rows_b(b, sql, units);
        while (true) {
            const auto row_a = rows_a.next();
            const auto row_b = rows_b.next();
            if (!row_a && !row_b) break;
            if (row_a == row_b && rows_a.unit() == rows_b.unit()) continue;
            throw UserError(
                "{}: unit {} differs from the same unit of the stores before it (one of them is damaged, or was made "
                "by another version of the program). Leave one of them out.",
                name.string(), row_a ? rows_a.unit() : rows_b.unit());
        }
    }
}

/// Adds every row of `file` that the store does not hold.
void copy_rows(const Store& store, const std::filesystem::path& file, bool has_checksums) {
    const Database& database = store.database();
    database.copy_from(file, [&] {
        database.execute(R"(INSERT INTO main.observations SELECT * FROM source.observations WHERE true
                            ORDER BY cell, observable, from_face, to_face, trial ON CONFLICT DO NOTHING)");
        const auto units = fmt::format(
            R"(INSERT INTO main.units SELECT unit, cell, first_trial, trials, patch_hits, patch_hits_squared, {}
               FROM source.units WHERE true ON CONFLICT DO NOTHING)",
            has_checksums ? "checksum" : "NULL");
        database.execute(units.c_str());
        if (!has_checksums) add_checksums(database, file, store.plan());
    });
}

std::vector<std::size_t> indices_where(const Units& units) {
    std::vector<std::size_t> indices;
    for (std::size_t unit = 0; unit < units.size(); ++unit) {
        if (units[unit]) indices.push_back(unit);
    }
    return indices;
}

using Range = CommonTrials::Range;

/// Everything that trials of a cell depend on: cells with equal identities have equal trials.
auto identity(const StudyPlan& plan, const Cell& cell) {
    return std::tuple(cell.canonical, cell.key.word0, cell.key.word1, plan.spec.methods[cell.method].tracer,
                      cell.deterministic);
}

/// First units of all cells, and the end.
std::vector<std::size_t> first_units(const StudyPlan& plan) {
    std::vector<std::size_t> first(plan.cells.size() + 1, plan.units.size());
    for (std::size_t unit = plan.units.size(); unit-- > 0;) first[plan.units[unit].cell] = unit;
    for (std::size_t cell = plan.cells.size(); cell-- > 0;) first[cell] = std::min(first[cell], first[cell + 1]);
    return first;
}

void copy_whole_units(const Store& target, const std::filesystem::path& file, const std::vector<Range>& ranges,
                      const std::vector<std::size_t>& first_there, const std::vector<std::size_t>& first_here) {
    const Database& database = target.database();
    database.copy_from(file, [&] {
        Statement units(database.handle(), R"(INSERT INTO main.units SELECT unit + ?, ?, first_trial, trials,
                                              patch_hits, patch_hits_squared, NULL FROM source.units
                                              WHERE cell = ? AND first_trial >= ? AND first_trial < ?)");
        Statement rows(database.handle(), R"(INSERT INTO main.observations
                                             SELECT ?, observable, from_face, to_face, trial, value
                                             FROM source.observations WHERE cell = ? AND trial >= ? AND trial < ?)");
        for (const Range& range : ranges) {
            if (range.whole == 0) continue;
            const auto& [there, here, first, whole, begun] = range;
            units.with(first_here[here] - first_there[there], here, there, first, first + whole).run();
            rows.with(here, there, first, first + whole).run();
        }
        add_checksums(database, file, target.plan());
    });
}

Observation observation_of(const Statement& row) {
    const auto* const name = std::ranges::find(observable::all, row.text(0));
    Observation observation{*name, static_cast<int>(row.integer(1)), static_cast<int>(row.integer(2)),
                            static_cast<std::uint64_t>(row.integer(3)), row.integer(4)};
    if (*name == observable::estimate || *name == observable::claim)
        observation.value = row.is_number(4) ? row.real(4) : std::numeric_limits<double>::quiet_NaN();
    return observation;
}

BegunUnit read_begun(const Store& stored, const Range& range) {
    const Database& database = stored.database();
    const std::uint64_t first = range.first + range.whole;
    BegunUnit begun{range.begun, {}};
    Statement unit(database.handle(),
                   "SELECT patch_hits, patch_hits_squared FROM units WHERE cell = ? AND first_trial = ?");
    unit.with(range.there, first).step();
    begun.record.patch_hits = unit.integers(0);
    begun.record.patch_hits_squared = unit.integers(1);
    Statement rows(database.handle(),
                   "SELECT observable, from_face, to_face, trial, value FROM observations "
                   "WHERE cell = ? AND trial >= ? AND trial < ?");
    rows.with(range.there, first, first + range.begun);
    while (rows.step()) begun.record.observations.push_back(observation_of(rows));
    return begun;
}

/// Ranges of finished trials of a cell that both studies have. Its units are cut at the same trials in both, until one
/// of the studies ends.
std::vector<Range> common_ranges(std::span<const WorkUnit> there, std::span<const WorkUnit> here,
                                 const std::vector<bool>& finished, std::uint64_t most) {
    std::vector<Range> ranges;
    bool consecutive = false;
    for (std::size_t i = 0; i < std::min(there.size(), here.size()); ++i) {
        const std::uint64_t trials = there[i].trials;
        if (here[i].first_trial + trials > most || trials > here[i].trials) break;
        if (!finished[there[i].index]) {
            consecutive = false;
            continue;
        }
        if (!consecutive) ranges.push_back({there[i].cell, here[i].cell, here[i].first_trial, 0, 0});
        consecutive = true;
        (trials == here[i].trials ? ranges.back().whole : ranges.back().begun) += trials;
        if (trials < here[i].trials) break;
    }
    return ranges;
}

}  // namespace

MergeOutcome merge_stores(const std::vector<std::filesystem::path>& sources, Store& target) {
    const std::size_t count = target.plan().units.size();
    Units seen(count, false);
    Units doubled(count, false);
    std::vector<std::size_t> unchecked;
    Context context = target.context();
    for (const auto& file : sources) {
        const Store source = Store::open(file);
        expect_same_study(source.database(), file, target.plan().spec);
        const Units here = source.finished_units();
        const Units there = target.finished_units();
        Units both(count, false);
        for (std::size_t unit = 0; unit < count; ++unit) {
            both[unit] = here[unit] && there[unit];
            if (here[unit] && seen[unit]) doubled[unit] = true;
            if (here[unit]) seen[unit] = true;
        }
        if (std::ranges::find(both, true) != both.end()) expect_equal(target, source, both, file);
        if (!source.was_checked()) unchecked.push_back(static_cast<std::size_t>(&file - sources.data()));
        copy_rows(target, file, source.was_checked());
        add_context(context, source.context());
    }
    target.set_context(context);
    const Units finished = target.finished_units();
    Units missing = needed_units(target);
    for (std::size_t unit = 0; unit < count; ++unit) missing[unit] = missing[unit] && !finished[unit];
    return {indices_where(missing), indices_where(doubled), std::move(unchecked)};
}

CommonTrials common_trials(const Store& stored, const StudyPlan& plan) {
    const StudyPlan& old = stored.plan();
    std::multimap<decltype(identity(old, old.cells.front())), std::size_t> known;
    for (std::size_t cell = 0; cell < old.cells.size(); ++cell) known.emplace(identity(old, old.cells[cell]), cell);
    const auto first_there = first_units(old);
    const auto first_here = first_units(plan);
    const std::vector<bool> finished = stored.finished_units();
    CommonTrials common;
    for (std::size_t unit = 0; unit < old.units.size(); ++unit) {
        if (finished[unit]) common.left_behind += old.units[unit].trials;
    }
    for (const WorkUnit& unit : plan.units) common.wanted += unit.trials;
    std::uint64_t within = 0;
    std::uint64_t beyond = 0;
    for (std::size_t here = 0; here < plan.cells.size(); ++here) {
        const auto match = known.find(identity(plan, plan.cells[here]));
        if (match == known.end()) continue;
        const std::size_t there = match->second;
        known.erase(match);  // if a study has the same trials twice, each cell gets its own
        const auto units_of = [](const StudyPlan& of, const std::vector<std::size_t>& first, std::size_t cell) {
            return std::span(of.units).subspan(first[cell], first[cell + 1] - first[cell]);
        };
        for (const WorkUnit& unit : units_of(old, first_there, there)) {
            const std::uint64_t end = unit.first_trial + unit.trials;
            const std::uint64_t ours = std::clamp(plan.cells[here].trials, unit.first_trial, end) - unit.first_trial;
            if (finished[unit.index]) within += ours;
            if (finished[unit.index]) beyond += unit.trials - ours;
        }
        const bool adaptive = plan.spec.until && !plan.cells[here].deterministic;
        for (const Range& range :
             common_ranges(units_of(old, first_there, there), units_of(plan, first_here, here), finished,
                           adaptive ? plan.spec.until->pilot : std::numeric_limits<std::uint64_t>::max())) {
            common.reused += range.whole + range.begun;
            common.ranges.push_back(range);
        }
    }
    if (within == common.wanted && within + beyond == common.left_behind) common.beyond = beyond;
    common.left_behind -= common.reused;
    return common;
}

void adopt(const Store& stored, const std::filesystem::path& file, const CommonTrials& common, Store& target,
           unsigned threads) {
    const auto first_here = first_units(target.plan());
    copy_whole_units(target, file, common.ranges, first_units(stored.plan()), first_here);
    std::vector<Range> begun;
    std::ranges::copy_if(common.ranges, std::back_inserter(begun), [](const Range& range) { return range.begun > 0; });
    const Worker worker(target.plan());
    std::mutex stores;
    for_each_index(begun.size(), threads, [&](std::uint64_t i) {
        const Range& range = begun[i];
        const StudyPlan& plan = target.plan();
        std::unique_lock lock(stores);
        BegunUnit first = read_begun(stored, range);
        lock.unlock();
        const auto unit = unit_of(plan, range.here, range.first + range.whole);
        const UnitRecord record = worker.carry_out(plan.units[*unit], std::move(first));
        lock.lock();
        target.commit(record);
    });
}

}  // namespace ff::studies
