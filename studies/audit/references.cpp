#include "studies/audit/references.hpp"

#include "studies/audit/scene_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace ff::studies::audit {
namespace {

struct Row {
    std::size_t error = 0;  ///< figure
    std::size_t value = 0;  ///< figure
};

/// Relative errors of one table for pairs of one exact value.
struct Group {
    std::string table;
    std::string pair_class;
    double exact = 0;
    double uncertainty = 0;  ///< uncertainty of the exact value, where no formula gives it
    std::optional<std::string> printed;
    std::vector<Row> rows{};
};

struct Candidate {
    ReferenceSource source = ReferenceSource::exact;
    std::string text;
    double value = 0;
};

/// Finds the value that an error belongs to: same quantity, same experiment, preferably in the same table.
class Values {
  public:
    explicit Values(const PublishedTables& tables) : tables_(tables) {
        for (std::size_t f = 0; f < tables.figures.size(); ++f) {
            if (tables.figures[f].kind != FigureKind::form_factor) continue;
            first_.try_emplace(key(tables.figures[f], ""), f);
            first_.try_emplace(key(tables.figures[f], tables.figures[f].table), f);
        }
    }

    [[nodiscard]] std::optional<std::size_t> of(std::size_t error) const {
        const Figure& figure = tables_.figures[error];
        for (const std::string& table : {figure.table, std::string()}) {
            const auto found = first_.find(key(figure, table));
            if (found != first_.end()) return found->second;
        }
        return std::nullopt;
    }

  private:
    using Key = std::tuple<std::string, std::string, std::string, std::string, std::uint32_t, std::uint64_t>;

    /// @param table  empty for any
    static Key key(const Figure& figure, const std::string& table) {
        return {table,     figure.method,           figure.from,
                figure.to, figure.patches_per_face, figure.samples_per_patch.value_or(0)};
    }

    const PublishedTables& tables_;
    std::map<Key, std::size_t> first_;  ///< figure
};

std::vector<Group> collect_groups(const PublishedTables& tables, const SceneFacts& facts) {
    std::vector<Group> groups;
    const Values values(tables);
    for (std::size_t f = 0; f < tables.figures.size(); ++f) {
        const Figure& figure = tables.figures[f];
        if (figure.kind != FigureKind::relative_error) continue;
        const std::size_t from = *facts.face(figure.from);
        const std::size_t to = *facts.face(figure.to);
        const Range limits = facts.factor(from, to);
        const double exact = limits.middle();
        if (exact <= 0) continue;
        const double uncertainty = limits.high - exact;
        auto group = std::ranges::find_if(groups, [&](const Group& g) {
            return g.table == figure.table && std::abs(g.exact - exact) < 1e-9 && g.uncertainty == uncertainty;
        });
        if (group == groups.end()) {
            const PairClass kind = pair_class(*facts.scene, static_cast<int>(from), static_cast<int>(to));
            Group fresh{.table = figure.table,
                        .pair_class = std::string(name(kind)),
                        .exact = exact,
                        .uncertainty = uncertainty,
                        .printed = {}};
            if (kind == PairClass::parallel) fresh.printed = tables.reference_parallel;
            if (kind == PairClass::adjacent) fresh.printed = tables.reference_adjacent;
            // A box has several values in one class; the printed one is that of some pair only.
            if (fresh.printed && std::abs(parse_printed(*fresh.printed)->value() / exact - 1) > 0.01) {
                fresh.printed = std::nullopt;
            }
            groups.push_back(std::move(fresh));
            group = groups.end() - 1;
        }
        if (const auto value = values.of(f)) group->rows.push_back({f, *value});
    }
    return groups;
}

std::vector<Candidate> candidates_of(const Group& group) {
    std::vector<Candidate> candidates;
    if (group.printed) {
        candidates.push_back({ReferenceSource::printed, *group.printed, parse_printed(*group.printed)->value()});
    }
    candidates.push_back({ReferenceSource::exact, fmt::format("{:.9f}", group.exact), group.exact});
    if (group.uncertainty > 0) return candidates;
    const int most = group.printed ? parse_printed(*group.printed)->decimals : 8;
    for (int decimals = most - 1; decimals >= 2; --decimals) {
        for (const Rounding rounding : {Rounding::rounded, Rounding::truncated}) {
            const std::string text = print(group.exact, {rounding, Layout::fixed_decimals, decimals});
            candidates.push_back({ReferenceSource::shortened, text, parse_printed(text)->value()});
        }
    }
    return candidates;
}

Range range_of(const Figure& figure, NumberFormat format) {
    return printed_range(figure.printed, format).value_or(Range{1, 0});
}

/// Tests all rows of a group against one candidate and rule, equal rows counting once.
class RowCounter {
  public:
    RowCounter(const PublishedTables& tables, const std::vector<NumberFormat>& formats, Rounding rounding)
        : tables_(tables), formats_(formats), rounding_(rounding) {}

    [[nodiscard]] bool explains(const Row& row, double reference) const {
        const Figure& error = tables_.figures[row.error];
        const auto number = parse_printed(error.printed);
        const NumberFormat format{rounding_, Layout::fixed_decimals, number ? number->decimals : 0};
        return error_fits(range_of(tables_.figures[row.value], formats_[row.value]), range_of(error, format),
                          reference);
    }
    [[nodiscard]] std::vector<Row> different_rows(const std::vector<Row>& rows) const {
        std::vector<Row> different;
        std::set<std::pair<std::string_view, std::string_view>> seen;
        for (const Row& row : rows) {
            if (seen.emplace(tables_.figures[row.error].printed, tables_.figures[row.value].printed).second)
                different.push_back(row);
        }
        return different;
    }
    [[nodiscard]] std::size_t count(const std::vector<Row>& rows, double reference) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(rows, [&](const Row& row) { return explains(row, reference); }));
    }

  private:
    const PublishedTables& tables_;
    const std::vector<NumberFormat>& formats_;
    Rounding rounding_;
};

InferredReference infer(const Group& group, const RowCounter& counter) {
    const std::vector<Row> rows = counter.different_rows(group.rows);
    const std::vector<Candidate> candidates = candidates_of(group);
    const Candidate& stated = candidates.front();
    const std::size_t by_stated = counter.count(rows, stated.value);
    const Candidate* best = &stated;
    std::size_t by_best = by_stated;
    for (const Candidate& candidate : candidates) {
        const std::size_t explained = counter.count(rows, candidate.value);
        const std::size_t needed =
            candidate.source == ReferenceSource::shortened ? std::max(by_best + 1, by_stated + 2) : by_best + 1;
        if (explained < needed) continue;
        best = &candidate;
        by_best = explained;
    }
    InferredReference result{.table = group.table,
                             .pair_class = group.pair_class,
                             .source = best->source,
                             .text = best->text,
                             .value = best->value,
                             .rows = rows.size(),
                             .explained = by_best,
                             .stated = stated.text,
                             .explained_by_stated = by_stated,
                             .unexplained_by_stated = {}};
    for (const Row& row : group.rows) {
        if (!counter.explains(row, stated.value)) result.unexplained_by_stated.push_back(row.error);
    }
    return result;
}

}  // namespace

bool error_fits(Range value, Range percent, double reference) {
    constexpr double slack = 1e-9;
    const Range possible = deviation(value, reference);
    return possible.low <= percent.high + slack && possible.high >= percent.low - slack;
}

ReferenceInference infer_references(const PublishedTables& tables, const SceneFacts& facts,
                                    const std::vector<NumberFormat>& formats) {
    ReferenceInference result;
    result.reference.resize(tables.figures.size());
    const std::vector<Group> groups = collect_groups(tables, facts);
    std::vector<InferredReference> truncated;
    for (const Group& group : groups) {
        result.references.push_back(infer(group, RowCounter(tables, formats, Rounding::rounded)));
        truncated.push_back(infer(group, RowCounter(tables, formats, Rounding::truncated)));
        if (group.uncertainty > 0) continue;  // too coarse to tell rounding from truncation
        result.rows += result.references.back().rows;
        result.explained_rounded += result.references.back().explained;
        result.explained_truncated += truncated.back().explained;
    }
    if (result.explained_truncated > result.explained_rounded) {
        result.rounding = Rounding::truncated;
        result.references = std::move(truncated);
    }
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const InferredReference& chosen = result.references[g];
        const double stated = groups[g].printed ? parse_printed(*groups[g].printed)->value() : groups[g].exact;
        Reference reference{chosen.value, groups[g].uncertainty};
        if (chosen.source != ReferenceSource::shortened) reference.uncertainty += std::abs(stated - groups[g].exact);
        for (const Row& row : groups[g].rows) result.reference[row.error] = reference;
    }
    return result;
}

}  // namespace ff::studies::audit
