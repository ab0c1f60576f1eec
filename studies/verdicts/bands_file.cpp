#include "studies/verdicts/bands_file.hpp"

#include "studies/readers/printable.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

namespace ff::studies::gates {
namespace {

/// @throws UserError for a number whose powers leave the range of doubles: beyond 1e75, or nearer to 0 than 1e-75
void expect_magnitude(const TomlReader& reader, std::string_view key, double number) {
    const double size = std::abs(number);
    if (size == 0 || (smallest_magnitude <= size && size <= largest_magnitude)) return;
    reader.fail(key, "(beyond 1e75, or nearer to 0 than 1e-75: its powers cannot be computed). Choose another unit.");
}

/// Two ends in order.
Band read_ends(const TomlReader& reader, const std::vector<double>& ends) {
    if (ends.size() != 2) reader.fail("band", "(one width, or two ends). Write 0.1 or [0.9, 1.1].");
    if (ends[0] == ends[1])
        reader.fail("band",
                    "(a band of zero width: no number of trials shows exactly this value). Move the ends apart.");
    if (ends[0] > ends[1]) reader.fail("band", "(the lower end comes first). Exchange them.");
    return {ends[0], ends[1]};
}

double read_width(const TomlReader& reader, const std::vector<double>& numbers, std::string_view suggestion) {
    if (numbers.size() != 1) reader.fail("band", fmt::format("(expected one number, not a list). Try {}.", suggestion));
    if (numbers[0] == 0)
        reader.fail("band",
                    fmt::format("(a band of zero width: no number of trials shows an effect of exactly nothing). "
                                "Try {}.",
                                suggestion));
    if (numbers[0] < 0) reader.fail("band", fmt::format("(a width is positive). Try {}.", suggestion));
    return numbers[0];
}

/// Refuses a band that is too narrow. @param width  from a ratio of 1, or from the level of a share, to an end of the
/// band
void expect_room(const TomlReader& reader, double width) {
    constexpr double least = 1e-12;
    if (width < least) reader.fail("band", "(narrower than 1e-12: a ratio is not computed to more digits). Try 0.1.");
}

Band read_ratio(const TomlReader& reader, const std::vector<double>& numbers, bool upwards_only) {
    if (numbers.size() == 1) {
        const double width = read_width(reader, numbers, "0.1");
        expect_room(reader, width);
        return {1 / (1 + width), upwards_only ? std::numeric_limits<double>::infinity() : 1 + width};
    }
    const Band band = read_ends(reader, numbers);
    if (band.low < 0 || band.low >= 1 || band.high <= 1)
        reader.fail("band", "(a ratio of 1, no change, has to lie inside). Try [0.9, 1.1].");
    expect_room(reader, std::min(1 - band.low, band.high - 1));
    return band;
}

/// The band of a gate whose other keys have been read: `band` is a width, interpreted by the kind, or [low, high].
/// @throws UserError for a band of no width, or one that no number of trials can decide
Band read_band(const TomlReader& reader, const Gate& gate) {
    if (!reader.has("band")) reader.fail("band", "missing (what is tolerated?). Add the key with a number.");
    const auto numbers = reader.numbers("band");
    for (const double number : numbers) expect_magnitude(reader, "band", number);
    switch (gate.kind) {
        case GateKind::bias:
        case GateKind::closure:
        case GateKind::reciprocity:
        case GateKind::equal: {
            const double width = read_width(reader, numbers, "1e-4");
            return {-width, width};
        }
        case GateKind::std:
        case GateKind::rmse:
        case GateKind::std_error:
            return read_ratio(reader, numbers, false);
        case GateKind::efficiency:
            return read_ratio(reader, numbers, true);
        case GateKind::distribution: {
            const double width = read_width(reader, numbers, "0.05");
            if (width >= 1)
                reader.fail("band",
                            "(expected below 1, from which on any distribution of values would pass). Try 0.05.");
            return {0, width};
        }
        case GateKind::lost_rays:
            if (numbers.size() != 1 || numbers[0] < 0 || numbers[0] >= 1)
                reader.fail("band", "(the largest share of lost rays that is tolerated). Try 0.");
            return {0, numbers[0]};
        case GateKind::coverage: {
            if (numbers.size() == 2) {
                const Band band = read_ends(reader, numbers);
                if (!band.holds(gate.interval_level))
                    reader.fail("band", "(the level of the interval has to lie inside). Try 0.02, around the level.");
                return band;
            }
            const double width = read_width(reader, numbers, "0.02");
            expect_room(reader, width);
            return {gate.interval_level - width, std::min(1.0, gate.interval_level + width)};
        }
        case GateKind::slope:
            break;
    }
    const auto expected = reader.optional_number("expected");
    if (numbers.size() == 2) {
        if (expected) reader.fail("expected", "(the band has two ends of its own). Remove the key.");
        return read_ends(reader, numbers);
    }
    const double width = read_width(reader, numbers, "0.05");
    if (!expected) reader.fail("expected", "missing (the slope that the band lies around). Try -0.5.");
    const Band band{*expected - width, *expected + width};
    if (!(band.low < *expected && *expected < band.high))
        reader.fail("expected", "(so large a number beside the band that rounding closes it). Try -0.5.");
    return band;
}

/// Refuses a key that only other kinds accept.
void expect_own_keys(const TomlReader& reader, GateKind kind) {
    using enum GateKind;
    static const std::vector<std::pair<std::string_view, std::vector<GateKind>>> own_keys{
        {"pairs", {bias, std, rmse, reciprocity, coverage, slope, efficiency}},
        {"expected", {slope}},
        {"interval", {coverage}},
        {"level", {coverage}},
        {"replicates", {coverage}},
        {"detects", {lost_rays}},
        {"reference", {bias, std, rmse, efficiency, distribution}},
        {"reference_se", {bias}},
        {"kurtosis", {std, efficiency}}};
    for (const auto& [key, kinds] : own_keys) {
        if (!reader.has(key) || std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
        std::vector<std::string_view> names;
        for (const GateKind other : kinds) names.push_back(name(other));
        reader.fail(key, fmt::format("(a gate of kind \"{}\" has none; it is for {}). Remove the key.", name(kind),
                                     fmt::join(names, ", ")));
    }
}

void read_reference(const TomlReader& reader, Gate& gate) {
    const bool spread = gate.kind == GateKind::std || gate.kind == GateKind::rmse;
    gate.against = gate.kind == GateKind::efficiency ? Against::baseline : Against::exact;
    const auto* node = reader.find("reference");
    if (node != nullptr && gate.kind == GateKind::distribution) {
        std::string problem;
        gate.law = parse_law(reader.text("reference"), problem);
        if (!gate.law) reader.fail("reference", problem);
        gate.against = Against::number;
    } else if (node != nullptr && node->is_string()) {
        if (reader.text("reference") != "baseline")
            reader.fail("reference", R"((a number, or "baseline" for --baseline FILE). Write "baseline".)");
        gate.against = Against::baseline;
    } else if (node != nullptr) {
        if (gate.kind == GateKind::efficiency)
            reader.fail("reference", "(efficiency is compared with a baseline). Remove the key.");
        gate.against = Against::number;
        gate.reference = reader.optional_number("reference");
        if (spread && *gate.reference <= 0) reader.fail("reference", "(a ratio to it is taken). Give a positive one.");
        expect_magnitude(reader, "reference", *gate.reference);
    }
    gate.reference_se = reader.optional_number("reference_se");
    if (gate.reference_se && gate.against != Against::number)
        reader.fail("reference_se",
                    "(it belongs to a reference that is a number). Remove the key, or add 'reference'.");
    if (gate.reference_se && *gate.reference_se < 0)
        reader.fail("reference_se", "(a standard error is not negative). Give 0 or more.");
    if (gate.reference_se) expect_magnitude(reader, "reference_se", *gate.reference_se);
}

/// Whether a gate may be looked at after every trial, and what is assumed for that.
void read_anytime(const TomlReader& reader, Gate& gate) {
    gate.anytime = reader.choice("anytime", gate.anytime);
    if (gate.anytime == Anytime::no) {
        for (const std::string_view key : {"bounds", "tightest_at"}) {
            if (reader.has(key)) reader.fail(key, "(it belongs to 'anytime'). Remove the key, or add that.");
        }
        return;
    }
    if (gate.kind != GateKind::bias || !reader.has("reference") || reader.has("reference_se"))
        reader.fail("anytime", "(it is for a bias beside an exact reference, a number). Remove the key.");
    const bool bounded = gate.anytime == Anytime::bounded;
    if (reader.has("bounds") != bounded)
        reader.fail("bounds", bounded ? "missing (between which numbers do all values lie?). Add [low, high]."
                                      : "(normal values have none). Remove the key, or take anytime = \"bounded\".");
    if (bounded) {
        const auto ends = reader.numbers("bounds");
        if (ends.size() != 2 || !(ends[0] < ends[1]))
            reader.fail("bounds", "(two numbers, the lower first). Write [0, 1].");
        for (const double end : ends) expect_magnitude(reader, "bounds", end);
        gate.bounds = {ends[0], ends[1]};
    }
    if (bounded && reader.has("tightest_at"))
        reader.fail("tightest_at", "(values between bounds need none). Remove the key.");
    gate.tightest_at = static_cast<double>(reader.optional_count("tightest_at").value_or(100));
    if (gate.tightest_at < 2) reader.fail("tightest_at", "(a number of trials, at least 2). Try 100.");
}

/// How the bins that a gate judges together vary: independently, or according to a file from the folder of the bands
/// file.
void read_covariance(const TomlReader& reader, Gate& gate) {
    const bool known = gate.combine == Combination::chi_squared;
    if (known && gate.kind != GateKind::bias && gate.kind != GateKind::equal)
        reader.fail("combine", R"((covariances are of means: kind "bias" or "equal"). Take "cauchy".)");
    if (reader.has("covariance") != known)
        reader.fail("covariance", known ? "missing (how do the bins vary together?). Add a file with the columns "
                                          "bin,other_bin,covariance, or \"independent\"."
                                        : "(it belongs to combine = \"chi_squared\"). Remove the key, or add that.");
    if (!known) return;
    const std::string covariance(reader.text("covariance"));
    if (covariance == "independent" && reader.optional_number("reference_se").value_or(0) > 0)
        reader.fail("reference_se",
                    "(all bins share the error of the reference, so they are not independent). Give a covariance that "
                    "includes it, or take combine = \"holm\".");
    if (covariance != "independent")
        gate.covariance = std::filesystem::path(reader.origin()).parent_path() / covariance;
}

/// The keys that a gate on another program's quantity may have.
void read_reported(const TomlReader& reader, Gate& gate) {
    reader.expect_only({"name", "kind", "quantity", "reference", "reference_se", "band", "combine", "relative",
                        "anytime", "bounds", "tightest_at", "covariance", "kurtosis"});
    static constexpr std::array kinds{GateKind::bias,      GateKind::std,        GateKind::equal,
                                      GateKind::std_error, GateKind::efficiency, GateKind::distribution};
    if (std::find(kinds.begin(), kinds.end(), gate.kind) == kinds.end())
        reader.fail("kind",
                    "(what another program reports can be gated on bias, std, equal, std_error, efficiency "
                    "and distribution). Choose one of them.");
    if (gate.kind == GateKind::std && !reader.has("reference"))
        reader.fail("reference", "missing (nothing is known about another program's quantity). Add the number.");
    read_anytime(reader, gate);
    gate.combine = reader.choice("combine", gate.combine);
    read_covariance(reader, gate);
    if (const auto* node = reader.find("relative")) {
        if (!node->is_boolean()) reader.fail("relative", "(true or false). Write true.");
        gate.relative = node->value_or(false);
    }
    gate.kurtosis = reader.optional_number("kurtosis");
    if (gate.kurtosis && *gate.kurtosis < 1)
        reader.fail("kurtosis", "(no distribution has one below 1; normal samples have 3). Write 3.");
    if (gate.kurtosis) expect_magnitude(reader, "kurtosis", *gate.kurtosis);
    if (reader.has("combine") && gate.kind == GateKind::distribution)
        reader.fail("combine", "(all bins of a distribution are one comparison). Remove the key.");
    if (gate.relative && gate.kind != GateKind::bias && gate.kind != GateKind::equal)
        reader.fail("relative", "(the band of this kind is of a ratio already). Remove the key.");
}

Gate read_gate(const TomlReader& reader, const ReadExperiment& read_experiment) {
    Gate gate;
    gate.kind = reader.choice<GateKind>("kind");
    gate.quantity = reader.optional_text("quantity").value_or("");
    if (gate.from_estimates()) {
        read_reported(reader, gate);
    } else if (read_experiment) {
        read_experiment(reader, gate);
    } else {
        reader.fail("quantity",
                    "missing (this program judges what others report; it runs nothing). Add the key, or install the "
                    "whole of ffstudy.");
    }
    gate.name = reader.text("name");
    reader.expect_none("name", problem_with_name(gate.name));
    reader.expect_none("quantity", problem_with_name(gate.quantity));
    expect_own_keys(reader, gate.kind);
    read_reference(reader, gate);
    if (gate.from_estimates() && gate.against == Against::baseline && reader.has("reference"))
        reader.fail("reference", "(a baseline holds our own trials only). Give a number, or a file with --against.");
    if (gate.from_estimates() && gate.against != Against::number) gate.against = Against::file;
    const bool of_others =
        gate.kind == GateKind::equal || gate.kind == GateKind::std_error || gate.kind == GateKind::distribution;
    if (!gate.from_estimates() && of_others)
        reader.fail("quantity", fmt::format("missing (a gate of kind \"{}\" is on what another program reports). Add "
                                            "the key.",
                                            name(gate.kind)));
    gate.band = read_band(reader, gate);
    gate.place = reader.place("band");
    return gate;
}

void read_options(const TomlReader& reader, Spec& spec) {
    reader.expect_only({"alpha", "power", "seed", "looks", "spending", "max_trials", "plugins"});
    spec.alpha = reader.optional_number("alpha").value_or(spec.alpha);
    if (spec.alpha < smallest_alpha || spec.alpha >= 0.5)
        reader.fail("alpha",
                    "(the chance of a false alarm anywhere in the file: at least 1e-12, below 0.5). Try 1e-4.");
    spec.power = reader.optional_number("power").value_or(spec.power);
    if (spec.power < 0.5 || spec.power > 1 - 1e-9)
        reader.fail("power", "(at least 0.5, and no finite number of trials makes it 1). Try 0.9.");
    spec.seed = Seed{reader.optional_count("seed").value_or(spec.seed.value)};
    spec.looks = reader.optional_count("looks").value_or(spec.looks);
    if (spec.looks < 1 || spec.looks > 10) reader.fail("looks", "(an undecided gate is judged 1 to 10 times). Try 3.");
    spec.spending = reader.choice("spending", spec.spending);
    spec.max_trials = reader.optional_count("max_trials").value_or(spec.max_trials);
    if (spec.max_trials < 2 || spec.max_trials > 100'000'000)
        reader.fail("max_trials", "(of one look: 2 to 100000000). Try 100000.");
}

}  // namespace

Spec parse_bands(std::string_view text, std::string_view origin, const ReadExperiment& read_experiment) {
    const toml::table root = parse_toml(text, origin, "docs/gates.md");
    const TomlReader file(root, origin);
    file.expect_only({"gates", "gate"});
    Spec spec;
    spec.name = std::filesystem::path(origin).stem().string();
    if (const auto options = file.optional_table("gates")) read_options(*options, spec);
    std::set<std::string> names;
    for (const TomlReader& table : file.tables("gate")) {
        Gate gate = read_gate(table, read_experiment);
        if (!names.insert(gate.name).second)
            table.fail("name", "is used twice (verdicts are found by it). Rename one.");
        spec.gates.push_back(std::move(gate));
    }
    if (spec.gates.empty()) file.fail("gate", "missing (nothing would be checked). Add a [[gate]].");
    return spec;
}

Spec load_bands(const std::filesystem::path& file, const ReadExperiment& read_experiment) {
    return parse_bands(read_text_file(file, FileKind::bands), file.string(), read_experiment);
}

}  // namespace ff::studies::gates
