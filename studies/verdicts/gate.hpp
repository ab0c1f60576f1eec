#pragma once

#include "core/points/stream.hpp"
#include "core/support/error.hpp"
#include "studies/readers/names.hpp"
#include "studies/verdicts/verdict.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace ff::studies::gates {

using studies::name;  // names of enumerators in files

/// Limits of bands, references and estimates: their fourth powers do not overflow.
inline constexpr double largest_magnitude = 1e75;
inline constexpr double smallest_magnitude = 1e-75;

/// Smallest supported risks: of a file, and of one comparison after sharing.
inline constexpr double smallest_alpha = 1e-12;
inline constexpr double smallest_shared_alpha = 1e-14;

/// The property that a gate checks. Each comment states the effect that its band refers to.
enum class GateKind {
    bias,         ///< mean estimate minus reference
    std,          ///< standard deviation of a trial over the reference
    rmse,         ///< root mean squared error of a trial over the reference
    closure,      ///< mean row sum minus 1 (minus the exact sum in an open scene)
    reciprocity,  ///< mean of F_ij - A_j F_ji / A_i
    lost_rays,    ///< share of rays that hit nothing
    coverage,     ///< share of confidence intervals that contain the exact value
    slope,        ///< rate of the RMSE along a ladder of sizes
    efficiency,   ///< 1 / (variance * evaluations) over the baseline's

    // Kinds for what another program reports.
    equal,         ///< mean minus the mean in a second file
    std_error,     ///< spread of means between runs over the standard errors that they state
    distribution,  ///< distance between distributions: Kolmogorov's of values, Cohen's w of counts
};

/// How the bins of an array share one alpha.
enum class Combination {
    holm,         ///< each bin at its share: names the bins
    simes,        ///< all together, for bins that are independent or vary in the same direction
    cauchy,       ///< all together, for bins that are correlated in any way
    chi_squared,  ///< all together, by a known covariance, or independent
};

/// The assumption about the values of a gate that may be judged after every value.
enum class Anytime {
    no,       ///< the gate may not be judged after every value
    normal,   ///< independent and normal, e.g. means of many samples
    bounded,  ///< between two bounds, each with the same mean whatever came before
};

/// How looks at a commit share alpha. Nothing is assumed about the dependence of their data.
enum class Spending {
    halving,         ///< look k gets 1 / 2^k of it; any number of looks
    pocock,          ///< `looks` looks, with about the same share each [lan1983]
    obrien_fleming,  ///< `looks` looks, with little for the first and most for the last [lan1983]
};

/// The reference of the effect.
enum class Against {
    exact,     ///< computed from the scene
    number,    ///< `reference` in the bands file
    baseline,  ///< the same gate in a file that --save-baseline wrote
    file,      ///< the same quantity in a second file of another program
};

/// Intervals whose coverage can be gated.
enum class IntervalMethod { student_t, normal, percentile_bootstrap, wilson, clopper_pearson, wald };

/// Counts hits within one trial, instead of taking the mean of several.
bool is_binomial(IntervalMethod method);

/// A continuous distribution with given parameters.
struct KnownLaw {
    enum class Family { uniform, normal, exponential } family = Family::uniform;
    double first = 0;   ///< low end, mean, mean
    double second = 1;  ///< high end, standard deviation, unused
};

/// P(X <= x).
double cumulative(const KnownLaw& law, double x);

/// Reads "normal(0, 1)", "uniform(0, 1)" or "exponential(1)"; sets `problem`, in the form "(why). Suggestion.", where
/// it is not one of these, or where parameters are missing: if they were fitted to the tested values, critical values
/// would change.
std::optional<KnownLaw> parse_law(std::string_view text, std::string& problem);

/// Scenes and a method, which gates on the program's own trials run (gates/gate_experiment.hpp). Judging others'
/// reports does not need it.
struct GateExperiment;

/// One [[gate]] of a bands file.
struct Gate {
    std::string name;
    GateKind kind = GateKind::bias;
    std::string place;  ///< "file:line:column" of the gate's band, for messages that only the plan can give
    Band band;

    std::shared_ptr<const GateExperiment> experiment;  ///< null for estimates that another program made
    std::vector<std::string> pairs;                    ///< "all", a class, or pairs "1-6"
    std::string pairs_place;

    std::optional<std::uint64_t> trials;  ///< number of trials, instead of a planned one
    Against against = Against::exact;
    std::optional<double> reference;     ///< the number of Against::number
    std::optional<double> reference_se;  ///< standard error of `reference`
    std::optional<KnownLaw> law;         ///< `reference` of a distribution
    std::string quantity;                ///< quantity in a file of estimates; empty for our own trials

    IntervalMethod interval = IntervalMethod::student_t;  ///< coverage
    double interval_level = 0.95;                         ///< coverage
    std::uint64_t replicates = 10;                        ///< coverage: trials behind one interval
    Combination combine = Combination::holm;              ///< how the bins of a quantity are combined
    std::filesystem::path covariance;  ///< file for Combination::chi_squared; empty: bins are independent
    bool relative = false;             ///< the band is a share of each bin's reference
    std::optional<double> kurtosis;    ///< largest kurtosis of the samples behind a standard error
    Anytime anytime = Anytime::no;
    Band bounds;               ///< range of possible values, where one is assumed
    double tightest_at = 100;  ///< number of values at which an anytime gate on normal values is most sensitive
    double detects = 1e-6;     ///< lost_rays with a band of zero: share of lost rays that has to be noticed

    [[nodiscard]] bool from_estimates() const { return !quantity.empty(); }
};

/// The contents of a bands file.
struct Spec {
    std::string name;     ///< name of the file, without folder and extension
    double alpha = 1e-4;  ///< family-wise risk of a failure anywhere in the file where all effects are in their bands
    double pass_alpha = 0.05;  ///< risk of a pass, for each gate whose effect is at an end of its band or beyond
    double power = 0.9;        ///< probability that a gate passes where there is no effect
    Seed seed{1};
    std::uint64_t looks = 3;  ///< how often an undecided gate is judged, each time with as many additional trials
    Spending spending = Spending::halving;  ///< how looks at a commit (--again) share alpha
    std::uint64_t max_trials = 100'000;     ///< most trials of a cell in one look
    std::vector<Gate> gates;
};

/// Levels of one comparison at one look: the file's alpha is shared equally among gates, looks and comparisons
/// (Bonferroni: gates on the same cell share trials), a gate's pass_alpha among its looks only, since all comparisons
/// have to pass (intersection-union).
/// @param comparisons  of this gate; at least 1
/// @throws UserError where alpha is shared among so many that each would be below smallest_shared_alpha
Levels levels_of(const Spec& spec, std::size_t comparisons);

/// The same where nothing can be added to the data, as to a file, so that there is one look only.
Levels levels_at_one_look(Spec spec, std::size_t comparisons);

/// @throws UserError at the gate's place in its file
[[noreturn]] void refuse_gate(const Gate& gate, const std::string& problem);

/// @throws UserError at its place: nothing that is added can decide it @param unit  what would be added, "trials" or
/// "runs"
[[noreturn]] void refuse_undecidable(const Gate& gate, std::string_view unit);

/// Calls `task`, and names the gate where a statistic is out of Boost.Math's range.
/// @throws UserError at the gate's place; anything else that `task` throws
template <class Task>
auto at_gate(const Gate& gate, const Task& task) {
    const auto named = [&gate](const std::exception& error) {
        return UserError(
            "{}: gate '{}' cannot be judged (a statistic is beyond what can be computed: {}). Look for "
            "values that are far from all others, or choose another band.",
            gate.place, gate.name, error.what());
    };
    try {
        return task();
    } catch (const UserError&) {
        throw;
    } catch (const IoError&) {
        throw;
    } catch (const std::system_error&) {
        throw;
    } catch (const std::domain_error& error) {
        throw named(error);
    } catch (const std::runtime_error& error) {
        throw named(error);
    }
}

}  // namespace ff::studies::gates

namespace ff::studies {

template <>
inline constexpr auto names_of<gates::GateKind> = [] {
    using enum gates::GateKind;
    return name_table(Named{bias, "bias"}, Named{std, "std"}, Named{rmse, "rmse"}, Named{closure, "closure"},
                      Named{reciprocity, "reciprocity"}, Named{lost_rays, "lost_rays"}, Named{coverage, "coverage"},
                      Named{slope, "slope"}, Named{efficiency, "efficiency"}, Named{equal, "equal"},
                      Named{std_error, "std_error"}, Named{distribution, "distribution"});
}();

template <>
inline constexpr auto names_of<gates::Combination> = name_table(Named{gates::Combination::holm, "holm"},
                                                                Named{gates::Combination::simes, "simes"},
                                                                Named{gates::Combination::cauchy, "cauchy"},
                                                                Named{gates::Combination::chi_squared, "chi_squared"});

template <>
inline constexpr auto names_of<gates::Anytime> = name_table(Named{gates::Anytime::normal, "normal"},
                                                            Named{gates::Anytime::bounded, "bounded"});

template <>
inline constexpr auto names_of<gates::Spending> = name_table(Named{gates::Spending::halving, "halving"},
                                                             Named{gates::Spending::pocock, "pocock"},
                                                             Named{gates::Spending::obrien_fleming, "obrien_fleming"});

template <>
inline constexpr auto names_of<gates::IntervalMethod> = [] {
    using enum gates::IntervalMethod;
    return name_table(Named{student_t, "student_t"}, Named{normal, "normal"},
                      Named{percentile_bootstrap, "percentile_bootstrap"}, Named{wilson, "wilson"},
                      Named{clopper_pearson, "clopper_pearson"}, Named{wald, "wald"});
}();

}  // namespace ff::studies
