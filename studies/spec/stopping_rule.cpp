#include "studies/spec/stopping_rule.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ff::studies {

StoppingRule read_stopping_rule(const TomlReader& reader, std::uint64_t trials) {
    reader.expect_only({"rmse", "ci", "pilot"});
    StoppingRule rule;
    if (reader.has("rmse") == reader.has("ci")) {
        reader.fail("rmse", "(expected one goal: rmse or ci). Write one of them, e.g. ci = 1e-5.");
    }
    rule.goal = reader.has("rmse") ? StoppingGoal::rmse : StoppingGoal::ci;
    rule.target = *reader.optional_number(name(rule.goal));
    if (rule.target <= 0) reader.fail(name(rule.goal), "(no number of trials reaches 0). Try 1e-4.");
    rule.pilot = reader.optional_count("pilot").value_or(rule.pilot);
    if (rule.pilot < fewest_pilot_trials || rule.pilot > trials) {
        reader.fail("pilot", fmt::format("({} to {} trials, the study's, are possible). Try {}.", fewest_pilot_trials,
                                         trials, std::min<std::uint64_t>(30, trials)));
    }
    return rule;
}

StoppingRule parse_stopping_rule(std::string_view text) {
    const std::size_t equals = text.find('=');
    const auto fail = [&](std::string_view why) {
        return UserError(fmt::format("--until {} ({}). Write rmse=1e-5 or ci=1e-5.", text, why));
    };
    if (equals == std::string_view::npos) throw fail("expected a goal and its value");
    const auto goal = value_named<StoppingGoal>(text.substr(0, equals));
    if (!goal) throw fail("the goals are rmse and ci");
    const double target = parse_bare_number<double>(text.substr(equals + 1)).value_or(0);
    if (!std::isfinite(target) || target <= 0) throw fail("not a number above 0");
    return {.goal = *goal, .target = target};
}

std::string to_toml(const StoppingRule& rule) {
    return fmt::format("\n[until]\n{} = {}\npilot = {}\n", name(rule.goal), rule.target, rule.pilot);
}

}  // namespace ff::studies
