#include "studies/run/merge.hpp"

#include "core/support/error.hpp"
#include "studies/store/store_checks.hpp"
#include "studies/trials/until.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
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
            throw UserError(fmt::format(
                "{}: unit {} differs from the same unit of the stores before it (one of them is damaged, or was made "
                "by another version of the program). Leave one of them out.",
                name.string(), row_a ? rows_a.unit() : rows_b.unit()));
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

}  // namespace

MergeOutcome merge_stores(const std::vector<std::filesystem::path>& sources, Store& target) {
    const std::size_t count = target.plan().units.size();
    Units seen(count, false);
    Units doubled(count, false);
    std::vector<std::size_t> unchecked;
    Context context = target.context();
    for (const auto& file : sources) {
        const Store source = Store::open(file);
        expect_same_study(source, file, target.plan().spec);
        const Units here = source.finished_units();
        const Units there = target.finished_units();
        Units both(count, false);
        for (std::size_t unit = 0; unit < count; ++unit) {
            both[unit] = here[unit] && there[unit];
            if (here[unit] && seen[unit]) doubled[unit] = true;
            if (here[unit]) seen[unit] = true;
        }
        if (std::find(both.begin(), both.end(), true) != both.end()) expect_equal(target, source, both, file);
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

}  // namespace ff::studies
