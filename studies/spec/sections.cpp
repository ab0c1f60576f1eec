#include "studies/spec/sections.hpp"

#include "core/exact/known_factors.hpp"
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ff::studies {
namespace {

constexpr double most_reflectance = 1 - 1e-9;
// Errors of the exitance enter statistics by their squares and fourth powers, which have to be numbers and not 0. The
// exitance is up to 1e9 times the largest emission, more where a system is nearly singular, and as little as the least
// emission times the least reflectance.
constexpr double least_nonzero = 1e-30;
constexpr double most_emission = 1e30;

bool within(double value, double most) {
    return value == 0 || (value >= least_nonzero && value <= most);
}

/// The problem with a list of numbers; empty where it is valid.
std::string problem_with_reflectance(const std::vector<double>& reflectance) {
    for (const double value : reflectance) {
        if (value >= 1) return fmt::format("({} is 1 or more: light that nothing absorbs piles up). Try 0.99.", value);
        if (value > most_reflectance)
            return fmt::format("({} is so near to 1 that rounding decides the light). Take at most 1 - 1e-9.", value);
        if (!(value >= 0)) return fmt::format("({} is below 0). Give 0 or more.", value);
        if (!within(value, most_reflectance))
            return fmt::format("({} is so small that squares of the light would be 0). Give 0, or {} at least.", value,
                               least_nonzero);
    }
    return {};
}

std::string problem_with_emission(const std::vector<double>& emission) {
    for (const double value : emission) {
        if (!(value >= 0) || !std::isfinite(value))
            return fmt::format("({} is below 0, or no number: no surface emits that). Give 0 or more.", value);
    }
    if (!emission.empty() && std::ranges::all_of(emission, [](double value) { return value == 0; }))
        return "(nothing emits: all would be dark). Give one face 1.";
    for (const double value : emission) {
        if (!within(value, most_emission))
            return fmt::format(
                "({} is neither 0 nor from {} to {}: squares of the light would be no numbers, or 0). Use another "
                "unit, in which the emission is near 1: the light is proportional to it.",
                value, least_nonzero, most_emission);
    }
    return {};
}

/// A number, or a list of numbers and of lists with one number for each face.
std::vector<std::vector<double>> read_settings(const TomlReader& reader, std::string_view key) {
    static constexpr std::string_view form = "(numbers, or lists of one number a face). Write it like [0.5, 0.9].";
    const toml::node* node = reader.find(key);
    if (!node->is_array()) return {reader.numbers(key)};
    std::vector<std::vector<double>> settings;
    for (const toml::node& item : *node->as_array()) {
        std::vector<double>& setting = settings.emplace_back();
        const auto add = [&](const toml::node& number) {
            if (!number.is_number()) reader.fail(key, form);
            setting.push_back(*number.value<double>());
        };
        if (const toml::array* list = item.as_array()) {
            for (const toml::node& number : *list) add(number);
        } else {
            add(item);
        }
        if (setting.empty()) reader.fail(key, form);
    }
    if (settings.empty()) reader.fail(key, "(an empty list leaves nothing to do). Give at least one number.");
    return settings;
}

void expect_numbers_for(const std::vector<double>& numbers, std::string_view what, const Scene& scene) {
    if (numbers.size() <= 1 || numbers.size() == scene.faces.size()) return;
    throw UserError("[radiosity]: {} has {} numbers (scene '{}' has {} faces). Give one, or one for each.", what,
                    numbers.size(), scene.name, scene.faces.size());
}

}  // namespace

RadiosityRequest read_radiosity(const TomlReader& reader) {
    reader.expect_only({"reflectance", "emission", "tolerance", "solver_trials", "patch_trials"});
    RadiosityRequest request;
    if (reader.has("reflectance")) request.reflectance = read_settings(reader, "reflectance");
    for (const auto& setting : request.reflectance)
        reader.expect_none("reflectance", problem_with_reflectance(setting));
    if (reader.has("emission")) request.emission = reader.numbers("emission");
    reader.expect_none("emission", problem_with_emission(request.emission));
    request.tolerance = reader.optional_number("tolerance").value_or(request.tolerance);
    if (request.tolerance < 1e-13 || request.tolerance >= 1)
        reader.fail("tolerance", "(1e-13 to below 1: no residual is smaller than rounding). Try 1e-6.");
    request.solver_trials = reader.optional_count("solver_trials").value_or(request.solver_trials);
    request.patch_trials = reader.optional_count("patch_trials").value_or(request.patch_trials);
    return request;
}

void check_radiosity(const RadiosityRequest& request, const std::string& place) {
    for (const auto& setting : request.reflectance) {
        if (const auto problem = problem_with_reflectance(setting); !problem.empty())
            throw UserError("{}reflectance {}", place, problem);
    }
    if (const auto problem = problem_with_emission(request.emission); !problem.empty())
        throw UserError("{}emission {}", place, problem);
}

std::vector<double> parse_numbers(const std::string& text, const std::string& option) {
    std::vector<double> numbers;
    for (const std::string_view part : split_at(',', text)) {
        const auto number = parse_bare_number<double>(part);
        if (!number || !std::isfinite(*number))
            throw UserError("{} {}: not a list of numbers. Write it like 0.5,0.9.", option, text);
        numbers.push_back(*number);
    }
    return numbers;
}

std::string to_toml(const RadiosityRequest& request) {
    std::vector<std::string> settings;
    for (const auto& setting : request.reflectance) settings.push_back(fmt::format("[{}]", fmt::join(setting, ", ")));
    std::string out = fmt::format("\n[radiosity]\nreflectance = [{}]\n", fmt::join(settings, ", "));
    if (!request.emission.empty()) out += fmt::format("emission = [{}]\n", fmt::join(request.emission, ", "));
    out += fmt::format("tolerance = {}\nsolver_trials = {}\n", request.tolerance, request.solver_trials);
    return request.patch_trials == 0 ? out : out + fmt::format("patch_trials = {}\n", request.patch_trials);
}

void expect_fitting(const RadiosityRequest& request, const Scene& scene) {
    if (!scene.closed) {
        throw UserError(
            "[radiosity]: scene '{}' is open (where light leaves, rows need not sum to 1, and "
            "what is lost by errors cannot be told). Close it, or leave the section out.",
            scene.name);
    }
    if (!exact_room_factors(scene)) {
        throw UserError(
            "[radiosity]: scene '{}' has no exact form factors to compare with ({}). Leave the section out.",
            scene.name, why_no_exact_factors(scene));
    }
    for (const auto& setting : request.reflectance) expect_numbers_for(setting, "reflectance", scene);
    expect_numbers_for(request.emission, "emission", scene);
}

std::string in_words(const std::vector<double>& reflectance) {
    return fmt::format("{}", fmt::join(reflectance, ", "));
}

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
        return UserError("--until {} ({}). Write rmse=1e-5 or ci=1e-5.", text, why);
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
