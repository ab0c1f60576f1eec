// ffstudy-validate: how often the verdicts, intervals and limits of ffstudy err. docs/validation.md shows what it
// prints.

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "studies/gates/gate_experiment.hpp"
#include "studies/verdicts/bands_file.hpp"
#include "tests/validation/form_factors/coverage.hpp"
#include "tests/validation/form_factors/facet_coverage.hpp"
#include "tests/validation/gates/selftest.hpp"
#include "tests/validation/heat/coverage.hpp"
#include "tests/validation/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>

namespace ff::studies {
namespace {

constexpr std::string_view help =
    R"(usage: ffstudy-validate gates [--seeds N] [--repetitions N] [--seed S] [--threads T] [--out DIR]
       ffstudy-validate form_factors [--seeds N] [--tolerance T] [--scene A,B] [--seed S] [--threads T] [--out DIR]
       ffstudy-validate heat          with the same options
       ffstudy-validate facets [--seeds N] [--pairs N] [--scenes SIZE] [--seed S] [--threads T] [--out DIR]

Measures how often the verdicts of gates, the intervals of form factors and the limits of heat flows err, and prints a
summary in Markdown; exit code 1 where a claim does not hold.

  --seeds N        seeds that every control or scene is computed with (default: 200; of facets 100)
  --repetitions N  of every rate on made-up trials (default: 20000)
  --tolerance T    of the form factors (default: 0.004)
  --scene A,B      scenes of the catalogue (default: all of them, and random ones)
  --pairs N        of facets of each method, in each scene and at each tolerance (default: 1600)
  --scenes SIZE    of facets: large (default), or small with coarse references
  --seed S         the first seed (default: 1)
  --threads T      results do not depend on them (default: all cores)
  --out DIR        folder for gates.md, form_factors.md, heat.md or facets.md, the tables of all rates (default: none is written)
)";

/// The arguments after the first one: options, each with a value. Options that have been read are removed.
class Options {
  public:
    /// @throws UserError where the last one has no value
    explicit Options(std::span<char*> arguments) {
        if (arguments.size() % 2 != 0)
            throw UserError(fmt::format("{} (takes a value). See --help.", arguments.back()));
        for (std::size_t i = 0; i < arguments.size(); i += 2) values_[arguments[i]] = arguments[i + 1];
    }

    /// Its value; empty where it was not given.
    std::string text(const std::string& option) {
        const auto given = values_.extract(option);
        return given.empty() ? "" : given.mapped();
    }

    /// Leaves a number unchanged where none was given.
    /// @throws UserError for a text that is not a number from `least` to `most`
    template <class Number>
    void read(const std::string& option, Number& number, Number least, Number most) {
        const std::string value = text(option);
        if (value.empty()) return;
        const char* const end = value.data() + value.size();
        const auto [rest, error] = std::from_chars(value.data(), end, number);
        if (error != std::errc() || rest != end || !(number >= least && number <= most)) {
            throw UserError(fmt::format("{} {} (from {} to {}). Take another number.", option, value, least, most));
        }
    }

    /// @throws UserError for an option that nothing has read
    void expect_none_left() const {
        if (!values_.empty())
            throw UserError(fmt::format("{} (not an option of this). See --help.", values_.begin()->first));
    }

  private:
    std::map<std::string, std::string> values_;
};

/// Reads the options that all commands have, and expects that no other is left.
template <class WhatOptions>
void read_last(Options& given, WhatOptions& options) {
    options.threads = std::max(1u, std::thread::hardware_concurrency());
    given.read("--threads", options.threads, 1u, 4096u);
    given.read<std::uint64_t>("--seed", options.seed.value, 0, std::numeric_limits<std::int64_t>::max());
    given.read<std::uint64_t>("--seeds", options.seeds, 1, 1'000'000);
    given.expect_none_left();
}

gates::SelftestOptions gate_options(Options given) {
    gates::SelftestOptions options;
    given.read<std::uint64_t>("--repetitions", options.repetitions, 1, 1'000'000'000);
    read_last(given, options);
    return options;
}

form_factors::FormFactorCoverageOptions coverage_options(Options given) {
    form_factors::FormFactorCoverageOptions options;
    given.read("--tolerance", options.tolerance, 1e-15, 1.0);
    std::istringstream scenes(given.text("--scene"));
    for (std::string scene; std::getline(scenes, scene, ',');) options.scenes.push_back(scene);
    read_last(given, options);
    if (options.scenes.empty()) {
        options.adversarial = 20 * options.seeds;
        options.walls = 2 * options.seeds;
    }
    return options;
}

form_factors::FacetCoverageOptions facet_options(Options given) {
    form_factors::FacetCoverageOptions options;
    const std::string scenes = given.text("--scenes");
    if (!scenes.empty() && scenes != "small" && scenes != "large")
        throw UserError(fmt::format("--scenes {} (there are large and small ones). See --help.", scenes));
    if (scenes == "small") options = form_factors::small_facets();
    given.read<std::size_t>("--pairs", options.pairs, 1, 1'000'000);
    read_last(given, options);
    return options;
}

/// Prints the summary of what was measured, and writes the tables where they are wanted. Returns the exit code.
/// @param file  empty: the tables are not written
template <class Measured>
int conclude(const Measured& measured, const std::filesystem::path& file) {
    const Pages pages = markdown(measured);
    if (!file.empty()) {
        std::filesystem::create_directories(file.parent_path());
        reports::write_file(file, pages.tables);
    }
    fmt::print("{}", pages.summary);
    return measured.contradictions() > 0 ? 1 : 0;
}

int validate(const std::string& what, Options given) {
    std::filesystem::path file = given.text("--out");
    if (!file.empty()) file /= what + ".md";
    if (what == "gates") {
        const auto controls = gates::load_bands(FF_BUILT_IN_STUDIES "/gates/controls.toml", gates::read_experiment);
        return conclude(gates::run_selftest(controls, gate_options(given)), file);
    }
    if (what == "form_factors")
        return conclude(form_factors::measure_form_factor_coverage(coverage_options(given)), file);
    if (what == "heat") return conclude(heat::measure_flow_coverage(coverage_options(given)), file);
    if (what == "facets") return conclude(form_factors::measure_facet_coverage(facet_options(given)), file);
    throw UserError(fmt::format("{} (only gates, form_factors, heat and facets are validated). See --help.", what));
}

int fail(int code, std::string_view message) {
    fmt::print(stderr, "ffstudy-validate: {}\n", message);
    return code;
}

}  // namespace
}  // namespace ff::studies

int main(int argc, char** argv) {
    using namespace ff::studies;
    const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
    if (argc < 2) {
        fmt::print(stderr, "{}", help);
        return 2;
    }
    if (std::ranges::find(arguments, std::string_view("--help")) != arguments.end()) {
        fmt::print("{}", help);
        return 0;
    }
    try {
        return validate(arguments[1], Options(arguments.subspan(2)));
    } catch (const ff::UserError& error) {
        return fail(2, error.what());
    } catch (const std::exception& error) {
        return fail(3, error.what());
    }
}
