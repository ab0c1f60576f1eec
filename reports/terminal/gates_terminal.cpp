#include "reports/terminal/gates_terminal.hpp"

#include "reports/text/numbers.hpp"
#include "studies/verdicts/reported/reported_bins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ff::reports {
namespace {

using studies::gates::Verdict;

Mark mark_of(Verdict verdict) {
    return verdict == Verdict::pass ? Mark::good : verdict == Verdict::fail ? Mark::bad : Mark::open;
}

std::string faces_in_words(const studies::gates::Comparison& c) {
    if (c.from_face.empty()) return {};
    return c.to_face == "sum" ? fmt::format(" Σ{}", c.from_face) : fmt::format(" {}-{}", c.from_face, c.to_face);
}

/// How the bins of an array differ, for people; empty for few.
std::string score_picture(const studies::gates::GateResult& result) {
    constexpr std::size_t fewest = 20;  // bins that have a shape
    if (result.scores.empty() || result.compared < fewest) return {};
    static constexpr std::array<std::string_view, 8> bars{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    const double most = static_cast<double>(*std::max_element(result.scores.begin(), result.scores.end()));
    constexpr double end = studies::gates::largest_score - studies::gates::score_step;
    std::string picture;
    for (const std::uint64_t count : result.scores) {
        // Logarithmic: a bin that lies far off is one among a million.
        const double height = std::log1p(static_cast<double>(count)) / std::log1p(most);
        picture += count == 0 ? " " : bars.at(static_cast<std::size_t>(std::ceil(height * 8)) - 1);
    }
    return fmt::format(
        "{:<12}  differences in standard errors, counts as logarithms: -{:g} or less |{}| {:g} or more\n", "", end,
        picture, end);
}

}  // namespace

std::string band_in_words(const studies::gates::Band& band) {
    if (band.low == 0 && band.high == 0) return "none tolerated";
    if (band.high == -band.low) return fmt::format("band ±{}", brief(band.high));
    if (!std::isfinite(band.high)) return fmt::format("band {} or more", brief(band.low));
    return fmt::format("band {} to {}", brief(band.low), brief(band.high));
}

std::size_t name_width(const studies::gates::Spec& spec) {
    std::size_t width = 4;
    for (const studies::gates::Gate& gate : spec.gates) width = std::max(width, gate.name.size());
    return width;
}

std::string gates_heading(const studies::gates::Spec& spec) {
    return fmt::format("{}: {}, false alarm at most {} in all, power {}, seed {}\n\n", spec.name,
                       counted(spec.gates.size(), "gate"), brief(spec.alpha), brief(spec.power), spec.seed.value);
}

std::string gate_in_words(const studies::gates::GateResult& result) {
    const studies::gates::Comparison& c = decisive(result.comparisons);
    std::string text = fmt::format("{}{}", c.quantity, faces_in_words(c));
    if (c.measurement) {
        const studies::gates::Measurement& e = *c.measurement;
        const bool exact_value = e.passing.low == e.passing.high;
        text += fmt::format(" {}", brief(e.value));
        if (!exact_value) text += fmt::format(" ({} to {})", brief(e.passing.low), brief(e.passing.high));
        text += fmt::format(", {}", band_in_words(c.band));
        if (!exact_value && std::isfinite(e.minimum_detectable))
            text += fmt::format("; {} would fail", brief(e.minimum_detectable));
    }
    text += fmt::format("; {}", counted(c.trials, c.unit));
    if (result.looks > 1) text += fmt::format(" in {} looks", result.looks);
    const std::size_t compared = std::max(result.compared, result.comparisons.size());
    if (compared > 1) text += fmt::format(", worst of {}", compared);
    if (!result.note.empty()) text += fmt::format(". {}", result.note);
    return text;
}

std::string gate_line(const studies::gates::GateResult& result, Colour colour) {
    const std::string verdict = fmt::format("{:<12}", name(result.verdict));
    return fmt::format("{}  {:<28}  {}\n{}", painted(verdict, mark_of(result.verdict), colour), result.gate,
                       gate_in_words(result), score_picture(result));
}

std::string gates_summary(const studies::gates::CheckResults& check) {
    const std::size_t missing = check.spec.gates.size() - check.results.size();
    return fmt::format("\n{} passed, {} failed, {} inconclusive{}.\n", check.count(Verdict::pass),
                       check.count(Verdict::fail), check.count(Verdict::inconclusive),
                       missing > 0 ? fmt::format(", {} not run", missing) : "");
}

std::string estimates_plan(const studies::gates::Spec& spec, std::span<const studies::gates::EstimatesPlan> files) {
    std::string out = gates_heading(spec);
    const std::size_t width = name_width(spec);
    out += fmt::format("{:<{}}  {:<11}  {:>11}  {:>10}  {:>10}  {}\n", "gate", width, "kind", "comparisons", "trials",
                       "core time", "at most");
    for (const studies::gates::EstimatesPlan& file : files) {
        const std::string needed = fmt::format("{}{}", file.needed, file.in_runs ? " runs" : "");
        out += fmt::format("{:<{}}  {:<11}  {:>11}  {:>10}  {:>10}  {} in the file\n", file.gate, width,
                           name(file.kind), file.comparisons, needed, "", file.at_hand);
    }
    return out;
}

std::string seed_sweep_table(const studies::gates::Spec& spec, std::span<const studies::gates::SeedSweep> sweeps) {
    const std::size_t width = name_width(spec);
    std::string out =
        fmt::format("{:<{}}  {:>6}  {:>6}  {:<24}  {:<9}  {:>12}  {:<24}  {}\n", "gate", width, "seeds", "fails",
                    "rate (95 % interval)", "alpha", "inconclusive", "rate (95 % interval)", "allowed");
    const auto rate = [](const studies::gates::SweepRate& r) {
        return fmt::format("{} ({} to {}){}", brief(r.rate), brief(r.interval.low, 2), brief(r.interval.high, 2),
                           r.exceeded ? " !" : "");
    };
    for (const studies::gates::SeedSweep& sweep : sweeps) {
        const auto failed = failure_rate(sweep, spec);
        const auto undecided = inconclusive_rate(sweep, spec);
        out += fmt::format("{:<{}}  {:>6}  {:>6}  {:<24}  {:<9}  {:>12}  {:<24}  {}\n", sweep.gate, width, sweep.seeds,
                           sweep.fails, rate(failed), brief(failed.allowed, 2), sweep.inconclusive, rate(undecided),
                           brief(undecided.allowed, 2));
    }
    return out;
}

}  // namespace ff::reports
