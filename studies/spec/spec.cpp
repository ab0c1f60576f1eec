#include "studies/spec/spec.hpp"

#include "core/estimators/added.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "samplers/sampler.hpp"
#include "stats/basics/interval.hpp"
#include "studies/published/published.hpp"
#include "studies/readers/printable.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/readers/toml_reader.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/spec/coverage_request.hpp"
#include "studies/spec/estimator_keys.hpp"
#include "studies/spec/named_files.hpp"
#include "studies/spec/sample_sizes.hpp"
#include "studies/spec/spec_sampler.hpp"
#include "studies/spec/spec_trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <span>
#include <utility>

namespace ff::studies {
namespace {

constexpr std::uint64_t max_samples = 1ULL << 32;  // a stream addresses points with 32 bits
constexpr std::uint32_t max_patches_per_face = 1u << 20;
constexpr double most_power = 1 - 1e-9;

std::vector<std::uint32_t> read_patches_per_face(const TomlReader& reader) {
    if (!reader.has("patches_per_face")) return {1};
    std::vector<std::uint32_t> patches;
    for (const std::uint64_t value : reader.counts("patches_per_face")) {
        if (value == 0 || value > max_patches_per_face) {
            reader.fail("patches_per_face",
                        fmt::format("(a face is divided into 1 to {} patches). Try 169.", max_patches_per_face));
        }
        const auto m = static_cast<std::uint64_t>(std::lround(std::sqrt(static_cast<double>(value))));
        if (m * m != value) {
            reader.fail("patches_per_face",
                        fmt::format("({} is not a square; faces are divided into m x m patches). Try {} or {}.", value,
                                    (m > 1 ? m * m : 1), (m + 1) * (m + 1)));
        }
        patches.push_back(static_cast<std::uint32_t>(value));
    }
    return patches;
}

/// Numbers of points for an estimator that makes its own points.
std::vector<std::uint64_t> read_own_samples(const TomlReader& reader, const EstimatorEntry& estimator) {
    auto samples = reader.counts("samples_per_patch");
    for (const std::uint64_t count : samples) {
        if (count > max_samples)
            reader.fail("samples_per_patch", fmt::format("(at most {} points). Take fewer.", max_samples));
        reader.expect_none("samples_per_patch", estimator.size_problem(count));
    }
    return samples;
}

/// Numbers, or a text with ranges of sizes that the sampler is made for.
std::vector<std::uint64_t> read_samples(const TomlReader& reader, const samplers::SamplerInfo& sampler,
                                        std::size_t dimension) {
    const toml::node* node = reader.find("samples_per_patch");
    if (node == nullptr || !node->is_string()) return reader.counts("samples_per_patch");
    try {
        return read_sample_sizes(reader.text("samples_per_patch"), sampler, dimension);
    } catch (const UserError& error) {
        reader.fail("samples_per_patch", error.what());
    }
}

/// @param patches  that share one sequence of points
void check_samples(const TomlReader& reader, const samplers::SamplerInfo& sampler, std::uint64_t samples,
                   std::uint64_t patches, std::size_t dimension) {
    if (samples > max_samples / patches) {
        reader.fail("samples_per_patch",
                    fmt::format("(a sequence has at most {} points). Take more trials instead.", max_samples));
    }
    const auto problem = samplers::check_size(sampler, samples * patches, dimension);
    if (problem.fatal) reader.fail("samples_per_patch", "makes " + problem.message);
}

/// The product of both lists, or the entries of `sizes`.
std::vector<Size> read_sizes(const TomlReader& reader, const samplers::SamplerInfo* sampler, const Method& method) {
    const auto trials = reader.optional_count("trials");
    if (trials) reader.expect_none("trials", problem_with_trials(*trials));
    const EstimatorEntry& estimator = find_estimator(method.estimator);
    const bool own_points = estimator.info.own_points;
    const bool from_sampler = sampler != nullptr && sampler->sizes != samplers::Sizes::nodes;
    if (reader.has("samples_per_patch") && !from_sampler && !own_points) {
        reader.fail("samples_per_patch",
                    "(this method takes no samples). Remove the key; Gauss-Legendre takes 'nodes'.");
    }
    std::vector<Size> sizes;
    const std::vector<std::uint64_t> none{0};
    const auto samples = own_points     ? read_own_samples(reader, estimator)
                         : from_sampler ? read_samples(reader, *sampler, estimator.info.dimension)
                                        : none;
    for (const std::uint32_t patches : read_patches_per_face(reader)) {
        if (estimator.info.whole_faces && patches > 1) {
            const bool program = find_added_estimator(estimator.info.name) != nullptr;
            reader.fail("patches_per_face", fmt::format("({} gets whole faces). Remove the key.",
                                                        program ? "a program" : method.estimator));
        }
        for (const std::uint64_t count : samples) {
            const std::uint64_t sharing = method.allocation == Allocation::face ? patches : 1;
            if (from_sampler) check_samples(reader, *sampler, count, sharing, estimator.info.dimension);
            sizes.push_back({patches, count > 0 ? std::optional(count) : std::nullopt, trials});
        }
    }
    return sizes;
}

std::optional<Nodes> read_nodes(const TomlReader& reader, const samplers::SamplerInfo* sampler,
                                const EstimatorInfo& estimator) {
    const bool wanted = sampler != nullptr && sampler->sizes == samplers::Sizes::nodes;
    if (!wanted) {
        if (reader.has("nodes"))
            reader.fail(
                "nodes",
                "(only quadrature rules have nodes; see 'ffstudy list samplers'). Remove the key, or choose one.");
        return std::nullopt;
    }
    const auto nodes = reader.counts("nodes");
    if (nodes.size() > 2) reader.fail("nodes", "(one number, or two: source and target patch). Give 5 or [5, 6].");
    for (const std::uint64_t n : nodes) {
        if (n == 0 || n > 64) reader.fail("nodes", "(1 to 64 nodes a side are possible). Try 5.");
    }
    const auto source = static_cast<std::uint32_t>(nodes.front());
    if (estimator.dimension == 2) {
        if (nodes.size() > 1) {
            reader.fail("nodes", fmt::format("({} has points of two coordinates). Give one number.", estimator.name));
        }
        return Nodes{source, 0};
    }
    return Nodes{source, static_cast<std::uint32_t>(nodes.back())};
}

void expect_unique_sizes(const TomlReader& reader, const Method& method) {
    std::set<std::pair<std::uint32_t, std::optional<std::uint64_t>>> seen;
    for (const Size& size : method.sizes) {
        if (!seen.emplace(size.patches_per_face, size.samples_per_patch).second)
            reader.fail("name", "has the same size twice (their trials would share random numbers). Keep one.");
    }
}

}  // namespace

const EstimatorInfo& estimator_info(const Method& method) {
    return find_estimator(method.estimator).info;
}

bool is_randomised(const Method& method) {
    return method.sampler.empty() ? estimator_info(method).randomised : samplers::find(method.sampler).info.randomised;
}

EstimatorOptions estimator_options(const Method& method) {
    return {.allocation = method.allocation, .tracer = method.tracer, .map = method.map};
}

Method read_method(const TomlReader& reader, std::span<const std::string_view> other_keys) {
    std::vector<std::string_view> known{"name",       "sampler",       "randomise",        "estimator",
                                        "completion", "allocation",    "tracer",           "map",
                                        "nodes",      "sizes",         "patches_per_face", "samples_per_patch",
                                        "trials",     "claimed_error", "claimed_level"};
    known.insert(known.end(), other_keys.begin(), other_keys.end());
    reader.expect_only(known);
    Method method;
    method.name = reader.text("name");
    reader.expect_none("name", problem_with_name(method.name));
    const EstimatorInfo& estimator = read_estimator(reader);
    method.estimator = estimator.name;
    refuse_keys_of_others(reader, estimator);
    const samplers::SamplerInfo* sampler = read_sampler(reader, estimator);
    method.sampler = sampler == nullptr ? std::string() : std::string(sampler->name);
    method.completion = reader.choice("completion", method.completion);
    method.allocation = reader.choice("allocation", method.allocation);
    const bool one_cell_a_point = sampler != nullptr && sampler->sizes == samplers::Sizes::fourth_power;
    if (method.allocation == Allocation::face && one_cell_a_point) {
        reader.fail("allocation",
                    "(each point of this sampler stays in one cell of the hypercube, so a part of its "
                    "points is biased). Use allocation = \"patch\".");
    }
    if (method.allocation == Allocation::face && sampler != nullptr && !sampler->equal_weights) {
        reader.fail("allocation", "(the nodes of a rule belong to one patch). Use allocation = \"patch\".");
    }
    method.tracer = reader.choice("tracer", method.tracer);
    method.map = reader.choice("map", method.map);
    method.nodes = read_nodes(reader, sampler, estimator);
    method.claimed_error = reader.optional_number("claimed_error");
    if (method.claimed_error && !(*method.claimed_error > 0))
        reader.fail("claimed_error", "(no method keeps an error of 0). Give what it claims, as 1e-4.");
    method.claimed_level = reader.optional_number("claimed_level");
    if (method.claimed_level && !(0 < *method.claimed_level && *method.claimed_level < 1))
        reader.fail("claimed_level",
                    "(the share of errors that should be at most as claimed: between 0 and 1; all, without the key). "
                    "Give 0.68 for standard errors.");

    if (!reader.has("sizes")) {
        method.sizes = read_sizes(reader, sampler, method);
        expect_unique_sizes(reader, method);
        return method;
    }
    static constexpr std::array<std::string_view, 3> size_keys{"patches_per_face", "samples_per_patch", "trials"};
    for (const std::string_view key : size_keys) {
        if (reader.has(key)) reader.fail(key, "(stands beside 'sizes', which says it for each size). Move it there.");
    }
    for (const TomlReader& table : reader.tables("sizes")) {
        table.expect_only(size_keys);
        for (const Size& size : read_sizes(table, sampler, method)) method.sizes.push_back(size);
    }
    if (method.sizes.empty()) reader.fail("sizes", "(an empty list leaves nothing to do). Give at least one size.");
    expect_unique_sizes(reader, method);
    return method;
}

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

}  // namespace ff::studies
