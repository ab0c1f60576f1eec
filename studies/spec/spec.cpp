#include "studies/spec/spec.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "stats/basics/interval.hpp"
#include "studies/published/published.hpp"
#include "studies/readers/printable.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/readers/toml_reader.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ff::studies {
namespace {

constexpr double most_power = 1 - 1e-9;
constexpr std::uint64_t max_trials = 1ULL << 32;  // a stream addresses trials with 32 bits

/// Numbers of trials, each at least 3 and at most half of the study's trials.
std::vector<std::uint64_t> read_coverage(const TomlReader& reader, std::uint64_t trials) {
    reader.expect_only({"replicates"});
    auto replicates = reader.counts("replicates");
    for (const std::uint64_t r : replicates) {
        if (r >= 3 && r <= trials / 2) continue;
        reader.fail("replicates", fmt::format("(3 to {} of the study's {} trials make a group). Try [5, 10, 20, 30] "
                                              "and 1000 trials.",
                                              trials / 2, trials));
    }
    return replicates;
}

}  // namespace

std::vector<SceneSource> read_scenes(const TomlReader& reader) {
    std::vector<SceneSource> sources;
    std::set<std::string> scenes;
    for (const std::string& written : reader.texts("scene")) {
        SceneSource& source = sources.emplace_back(scene_source(written));
        if (reader.has("mirrors")) {
            for (std::string& face : reader.texts("mirrors")) source.mirrors.push_back(std::move(face));
        }
        reader.expect_none("scene", problem_with_name(source.title()));
        std::string canonical = source.written();
        try {
            if (!source.is_file() || source.text) canonical = make_scene(source).canonical;
        } catch (const UserError& error) {
            reader.fail("scene", fmt::format("is refused: {}", error.what()));
        }
        if (!scenes.insert(canonical).second) reader.fail("scene", "names a scene twice. Keep one.");
    }
    return sources;
}

StudySpec parse_study(std::string_view text, std::string_view origin) {
    const toml::table root = parse_toml(text, origin);
    const TomlReader file(root, origin);
    file.expect_only({"study", "method", "until", "coverage", "radiosity", "published"});
    const auto study = file.optional_table("study");
    if (!study) file.fail("study", "missing. Begin the file with [study].");
    study->expect_only({"name", "title", "scene", "mirrors", "trials", "seed", "level", "power", "equivalence_margin",
                        "inapplicable", "plugins"});

    StudySpec spec;
    spec.name = study->text("name");
    study->expect_none("name", problem_with_name(spec.name));
    if (spec.name.find('/') != std::string::npos || spec.name.front() == '.') {
        study->fail("name", "(it names the folder of the results). Leave out '/' and a leading '.'.");
    }
    spec.title = study->optional_text("title").value_or(spec.name);
    study->expect_none("title", problem_with_title(spec.title));
    spec.scenes = read_scenes(*study);
    spec.trials = study->count("trials");
    study->expect_none("trials", problem_with_trials(spec.trials));
    spec.seed = Seed{study->count("seed")};
    spec.level = study->optional_number("level").value_or(spec.level);
    if (!stats::is_level(spec.level)) {
        study->fail(
            "level",
            "(intervals are right more often than not, but not always: above 0.5, at most 1 - 1e-9). Try 0.95.");
    }
    spec.power = study->optional_number("power").value_or(spec.power);
    if (spec.power < 0.5 || spec.power > most_power) {
        study->fail("power", "(at least 0.5, and no finite number of trials makes it 1). Try 0.9.");
    }
    spec.equivalence_margin = study->optional_number("equivalence_margin");
    if (spec.equivalence_margin && *spec.equivalence_margin <= 0) {
        study->fail("equivalence_margin", "(no number of trials shows a bias of exactly 0). Try 1e-4.");
    }
    spec.inapplicable = study->choice("inapplicable", spec.inapplicable);

    std::set<std::string> names;
    for (const TomlReader& table : file.tables("method")) {
        Method method = read_method(table);
        if (!names.insert(method.name).second)
            table.fail("name", "is used twice (results are found by it). Rename one.");
        spec.methods.push_back(std::move(method));
    }
    if (spec.methods.empty()) file.fail("method", "missing (nothing would be run). Add a [[method]].");

    if (const auto until = file.optional_table("until")) spec.until = read_stopping_rule(*until, spec.trials);
    if (const auto coverage = file.optional_table("coverage")) spec.coverage = read_coverage(*coverage, spec.trials);
    if (const auto radiosity = file.optional_table("radiosity")) spec.radiosity = read_radiosity(*radiosity);
    if (const auto published = file.optional_table("published")) {
        published->expect_only({"tables"});
        spec.published = Published{published->text("tables"), {}};
    }
    return spec;
}

void read_named_files(StudySpec& spec, const std::filesystem::path& folder) {
    for (SceneSource& scene : spec.scenes) {
        if (!scene.is_file() || scene.text) continue;
        scene.text = read_scene_file(folder / scene.name);
        static_cast<void>(make_scene(scene));  // refused before it is run
    }
    if (spec.published) {
        const auto tables = folder / spec.published->file;
        spec.published->text = read_tables_text(tables);
        static_cast<void>(parse_published_tables(spec.published->text, tables.string()));  // refused before it is run
    }
}

StudySpec load_study(const std::filesystem::path& file) {
    StudySpec spec = parse_study(read_text_file(file, FileKind::study), file.string());
    read_named_files(spec, file.parent_path());
    return spec;
}

std::string to_toml(const StudySpec& spec) {
    std::vector<std::string> scenes;
    for (const SceneSource& scene : spec.scenes) scenes.push_back(toml_text(scene.written()));
    std::string out =
        fmt::format("[study]\nname = {}\ntitle = {}\nscene = [{}]\ntrials = {}\nseed = {}\nlevel = {}\npower = {}\n",
                    toml_text(spec.name), toml_text(spec.title), fmt::join(scenes, ", "), spec.trials, spec.seed.value,
                    spec.level, spec.power);
    if (spec.equivalence_margin) out += fmt::format("equivalence_margin = {}\n", *spec.equivalence_margin);
    if (spec.inapplicable == Inapplicable::skip) out += "inapplicable = \"skip\"\n";
    for (const Method& method : spec.methods) {
        const EstimatorInfo& estimator = estimator_info(method);
        out += fmt::format("\n[[method]]\nname = {}\n", toml_text(method.name));
        if (!method.sampler.empty()) out += fmt::format("sampler = {}\n", toml_text(method.sampler));
        out += fmt::format("estimator = \"{}\"\ncompletion = \"{}\"\n", method.estimator, name(method.completion));
        if (estimator.has_allocation()) out += fmt::format("allocation = \"{}\"\n", name(method.allocation));
        if (estimator.has_tracer) out += fmt::format("tracer = \"{}\"\n", name(method.tracer));
        if (method.claimed_error) out += fmt::format("claimed_error = {}\n", *method.claimed_error);
        if (method.claimed_level) out += fmt::format("claimed_level = {}\n", *method.claimed_level);
        if (method.map != PointMap::uniform) out += fmt::format("map = \"{}\"\n", name(method.map));
        if (method.nodes) {
            const auto [source, target] = *method.nodes;
            out +=
                target == 0 ? fmt::format("nodes = {}\n", source) : fmt::format("nodes = [{}, {}]\n", source, target);
        }
        out += "sizes = [\n";
        for (const Size& size : method.sizes) {
            out += fmt::format("    {{ patches_per_face = {}", size.patches_per_face);
            if (size.samples_per_patch) out += fmt::format(", samples_per_patch = {}", *size.samples_per_patch);
            if (size.trials) out += fmt::format(", trials = {}", *size.trials);
            out += " },\n";
        }
        out += "]\n";
    }
    if (spec.until) out += to_toml(*spec.until);
    if (!spec.coverage.empty()) out += fmt::format("\n[coverage]\nreplicates = [{}]\n", fmt::join(spec.coverage, ", "));
    if (spec.radiosity) out += to_toml(*spec.radiosity);
    if (spec.published) out += fmt::format("\n[published]\ntables = {}\n", toml_text(spec.published->file));
    return out;
}

std::string problem_with_trials(std::uint64_t trials) {
    if (trials == 0) return "(nothing would be run). Try 64.";
    if (trials == 1) return "(a confidence interval needs at least 2). Try 64.";
    return trials <= max_trials ? "" : fmt::format("(at most {} trials). Take fewer.", max_trials);
}

void set_trials(StudySpec& spec, std::uint64_t trials) {
    if (const auto problem = problem_with_trials(trials); !problem.empty())
        throw UserError("--trials {} {}", trials, problem);
    for (Method& method : spec.methods) {
        for (Size& size : method.sizes) {
            if (!size.trials) continue;
            // ceil(own * trials / all), in two parts that fit 64 bits.
            const std::uint64_t whole = *size.trials / spec.trials * trials;
            const std::uint64_t part = (*size.trials % spec.trials * trials + spec.trials - 1) / spec.trials;
            size.trials = std::clamp<std::uint64_t>(whole + part, 2, max_trials);
        }
    }
    spec.trials = trials;
    const auto largest = std::ranges::max_element(spec.coverage);
    if (largest != spec.coverage.end() && trials / 2 < *largest) {
        throw UserError("--trials {} (coverage is measured with groups of {} trials, two at least). Take {} or more.",
                        trials, *largest, 2 * *largest);
    }
    if (!spec.until) return;
    if (trials < fewest_pilot_trials) {
        throw UserError("--trials {} (the pilot of an adaptive study has at least {}). Take more.", trials,
                        fewest_pilot_trials);
    }
    spec.until->pilot = std::min(spec.until->pilot, trials);
}

}  // namespace ff::studies
