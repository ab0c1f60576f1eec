#include "studies/audit/findings.hpp"

#include "studies/audit/experiment_model.hpp"
#include "studies/audit/scene_facts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

namespace ff::studies::audit {
namespace {

/// Trailing zeros after the decimal point say nothing.
std::string_view without_zeros(std::string_view text) {
    if (text.find('.') == std::string_view::npos) return text;
    while (text.size() > 1 && text.back() == '0' && text[text.size() - 2] != '.') text.remove_suffix(1);
    return text;
}

int distance(std::string_view printed, std::string_view meant) {
    return std::min(misprint_distance(printed, meant), misprint_distance(without_zeros(printed), without_zeros(meant)));
}

/// Whether a number that is printed in this way can lie in the range.
bool is_possible(std::string_view text, Range values, NumberFormat format, std::optional<std::uint64_t> rays) {
    if (text.size() > 1 && text[0] == '0' && text[1] != '.') return false;  // nobody prints 01.5
    const auto number = parse_printed(text);
    const auto range = number ? printed_range(*number, format) : std::nullopt;
    if (!range) return false;
    const double slack = 1e-6 * printed_unit(number->value(), format);
    const Range both{std::max(range->low, values.low - slack), std::min(range->high, values.high + slack)};
    if (both.low > both.high) return false;
    return !rays || possible_hits(both, *rays).has_value();
}

/// Calls `visit` with every text in which one digit is replaced, inserted, dropped or swapped with the next.
void visit_misprints(const std::string& text, const std::function<void(const std::string&)>& visit) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '.') continue;
        std::string changed = text;
        for (char digit = '0'; digit <= '9'; ++digit) {
            changed[i] = digit;
            visit(changed);
        }
        std::string dropped = text;
        visit(dropped.erase(i, 1));
        if (i + 1 < text.size() && text[i + 1] != '.') {
            std::string swapped = text;
            std::swap(swapped[i], swapped[i + 1]);
            visit(swapped);
        }
    }
    for (std::size_t i = 0; i <= text.size(); ++i) {
        for (char digit = '0'; digit <= '9'; ++digit) {
            std::string inserted = text;
            visit(inserted.insert(i, 1, digit));
        }
    }
}

/// Calls `visit` with every text in which two digits are replaced.
void visit_double_replacements(const std::string& text, const std::function<void(const std::string&)>& visit) {
    std::string changed = text;
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (std::size_t j = i + 1; j < text.size(); ++j) {
            if (text[i] == '.' || text[j] == '.') continue;
            for (changed[i] = '0'; changed[i] <= '9'; ++changed[i]) {
                for (changed[j] = '0'; changed[j] <= '9'; ++changed[j]) visit(changed);
            }
            changed = text;
        }
    }
}

/// The values that a blamed figure should print: the range of its constraint's left side.
Range predicted(const Constraint& constraint, const std::vector<Range>& ranges) {
    Range sum{0, 0};
    for (const Term& term : constraint.terms) {
        const Range part = contribution(constraint, ranges, term);
        sum.low += part.low;
        sum.high += part.high;
    }
    sum.high = std::max(sum.low, sum.high);  // the ends of a point may be rounded past each other
    return sum;
}

/// Whether the blamed suspect could print `values` with everything that is not blamed.
bool agrees(ConstraintSystem system, const std::vector<std::size_t>& blamed, std::size_t suspect, Range values) {
    Blame blame(system.suspects.size(), false);
    for (const std::size_t s : blamed) blame[s] = s != suspect;
    for (Constraint& constraint : system.constraints) {
        if (constraint.suspect == suspect) constraint.values = values;
    }
    return propagate(system, blame).has_value();
}

/// The errors of a deterministic method have any size, so the probability that one lies within a printed unit of its
/// value falls as the reciprocal of this value. In powers of ten, over all pairs.
double distance_from_truth(const ExperimentModel& model, const std::vector<Range>& ranges) {
    const SceneFacts& facts = model.facts;
    double improbability = 0;
    std::set<std::size_t> seen;
    for (const auto& [pair, term] : model.pairs) {
        if (model.system.variables[term.variable].rays || !seen.insert(term.variable).second) continue;
        const Range left = ranges[term.variable];
        const Range truth = facts.factor(pair / facts.faces(), pair % facts.faces());
        const double gap = std::max({0.0, left.low - truth.high / term.factor, truth.low / term.factor - left.high});
        improbability += std::log10(1 + gap / printed_unit(left.low, model.interpretation.values));
    }
    return improbability;
}

JudgedDiagnosis judge(const ExperimentModel& model, Diagnosis diagnosis) {
    JudgedDiagnosis judged;
    judged.improbability = distance_from_truth(model, diagnosis.ranges);
    for (const std::size_t s : diagnosis.blamed) {
        const Suspect& suspect = model.system.suspects[s];
        if (suspect.figures.empty()) {
            judged.improbability += suspect.weight;
            continue;
        }
        const Constraint& constraint = constraint_of(model, s);
        const Figure& figure = model.tables.figures[suspect.figures.front()];
        const auto is_consistent = [&](Range values) { return agrees(model.system, diagnosis.blamed, s, values); };
        Range values = predicted(constraint, diagnosis.ranges);
        std::optional<Range> truth;
        if (figure.kind == FigureKind::form_factor) {
            values = {std::clamp(values.low, 0.0, 1.0), std::clamp(values.high, 0.0, 1.0)};
            const auto from = model.facts.face(figure.from);
            const auto to = model.facts.face(figure.to);
            if (from && to) truth = model.facts.factor(*from, *to);
        }
        Correction correction = correct(figure.printed, values, format_of(figure, model.interpretation),
                                        rays_of(model, constraint), is_consistent, truth);
        correction.figure = suspect.figures.front();
        judged.improbability += suspect.weight * correction.edits;
        if (const auto expected =
                model.distribution ? expectation(model.facts, *model.distribution, figure) : std::nullopt;
            expected && expected->sigma > 0) {
            const double z = (parse_printed(correction.meant)->value() - expected->mean) / expected->sigma;
            judged.improbability += 0.5 * z * z / std::numbers::ln10;
        }
        judged.corrections.push_back(std::move(correction));
    }
    judged.diagnosis = std::move(diagnosis);
    return judged;
}

}  // namespace

Correction correct(std::string_view printed, Range values, NumberFormat format, std::optional<std::uint64_t> rays,
                   const std::function<bool(Range)>& is_consistent, std::optional<Range> truth) {
    Correction result;
    result.printed = printed;
    result.values = values;
    if (rays) result.hits = possible_hits(values, *rays);
    const double middle = values.middle();
    const double unit = printed_unit(middle, format);
    result.meant = print(std::max(0.0, middle), format);
    result.edits = distance(printed, result.meant);

    double gap = std::abs(parse_printed(result.meant)->value() - middle);
    std::size_t possible = 0;
    std::set<std::string> tried;
    const auto offer = [&](const std::string& text) {
        if (!is_possible(text, values, format, rays)) return;
        if (!tried.insert(text).second || !is_consistent(*printed_range(text, format))) return;
        ++possible;
        const int edits = distance(printed, text);
        const double away = std::abs(parse_printed(text)->value() - middle);
        const bool better = edits < result.edits || (edits == result.edits && away < gap);
        if (possible > 1 && !better) return;
        result.meant = text;
        result.edits = edits;
        gap = away;
    };
    const double width = (values.high - values.low) / unit;
    constexpr double few = 200;
    if (width <= few) {
        const auto steps = static_cast<int>(std::ceil(width / 2)) + 1;
        for (int k = -steps; k <= steps; ++k) offer(print(std::max(0.0, middle + k * unit), format));
        result.certain = possible == 1;
    } else {
        visit_misprints(std::string(printed), offer);
        if (possible == 0) visit_double_replacements(std::string(printed), offer);
        // No misprint explains it: the nearest number of hits, or the true value, may have been meant.
        if (possible == 0 && rays) {
            const auto all = static_cast<double>(*rays);
            offer(print(std::round(parse_printed(printed)->value() * all) / all, format));
        }
        if (possible == 0 && truth) offer(print(truth->middle(), format));
        for (int k = 0; possible == 0 && k < 20; ++k) {  // then whatever is left at the ends
            offer(print(std::max(0.0, values.low + k * unit), format));
            offer(print(std::max(0.0, values.high - k * unit), format));
        }
    }
    const double value = parse_printed(printed)->value();
    const double nearest = std::clamp(value, values.low, values.high);
    result.units = std::abs(value - nearest) / printed_unit(value, format);
    return result;
}

const Constraint& constraint_of(const ExperimentModel& model, std::size_t suspect) {
    return *std::ranges::find(model.system.constraints, suspect, &Constraint::suspect);
}

std::optional<std::uint64_t> rays_of(const ExperimentModel& model, const Constraint& constraint) {
    if (constraint.kind != ConstraintKind::linear || constraint.terms.size() != 1) return std::nullopt;
    if (constraint.terms.front().factor != 1) return std::nullopt;
    return model.system.variables[constraint.terms.front().variable].rays;
}

std::vector<JudgedDiagnosis> judge_diagnoses(const ExperimentModel& model) {
    std::vector<JudgedDiagnosis> judged;
    for (Diagnosis& diagnosis : diagnose(model.system)) judged.push_back(judge(model, std::move(diagnosis)));
    std::ranges::stable_sort(judged, {}, &JudgedDiagnosis::improbability);
    return judged;
}

}  // namespace ff::studies::audit
