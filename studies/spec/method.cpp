#include "studies/spec/spec.hpp"

#include "core/estimators/added.hpp"
#include "core/support/error.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/sampler.hpp"
#include "studies/outside/program.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/readers/printable.hpp"
#include "studies/readers/toml_reader.hpp"
#include "studies/spec/sample_sizes.hpp"

#include <fmt/format.h>

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

/// A key of a method that only some estimators have.
struct EstimatorKey {
    std::string_view name;
    bool (*is_of)(const EstimatorInfo& estimator);
};

constexpr std::array estimator_keys{
    EstimatorKey{"allocation", [](const EstimatorInfo& estimator) { return estimator.has_allocation(); }},
    EstimatorKey{"tracer", [](const EstimatorInfo& estimator) { return estimator.has_tracer; }},
    EstimatorKey{"map", [](const EstimatorInfo& estimator) { return estimator.has_map; }},
};

/// The estimator that a program is, where it has been admitted.
const EstimatorInfo& find_admitted(const TomlReader& reader, const std::string& command) {
    try {
        const auto folder = std::filesystem::path(reader.origin()).parent_path();
        if (const auto* added = find_added_estimator(full_command_name(command, folder))) return added->entry().info;
    } catch (const UserError& error) {
        reader.fail("estimator", fmt::format("is refused: {}", error.what()));
    }
    reader.fail("estimator",
                "is refused: the program has not been admitted (reading a study runs nothing). Admit it first, see "
                "studies/outside/outside_code.hpp.");
}

/// The estimator that a method names.
const EstimatorInfo& read_estimator(const TomlReader& reader) {
    const std::string name = reader.optional_text("estimator").value_or("");
    if (const auto* added = find_added_estimator(name)) return added->entry().info;
    if (names_command(name)) return find_admitted(reader, name);
    std::vector<std::string_view> names;
    for (const EstimatorEntry& estimator : estimators()) names.push_back(estimator.info.name);
    return estimators()[reader.index_of("estimator", names)].info;
}

void refuse_keys_of_others(const TomlReader& reader, const EstimatorInfo& estimator) {
    for (const EstimatorKey& key : estimator_keys) {
        if (!reader.has(key.name) || key.is_of(estimator)) continue;
        std::vector<std::string_view> names;
        for (const EstimatorEntry& other : estimators()) {
            if (key.is_of(other.info)) names.push_back(other.info.name);
        }
        const std::string_view last = names.back();
        names.pop_back();
        const std::string all =
            names.empty() ? fmt::format("{} has", last) : fmt::format("{} and {} have", fmt::join(names, ", "), last);
        reader.fail(key.name, fmt::format("(only {} it). Remove the key.", all));
    }
}

/// A name that the catalogue or an added sampler has; files of points are read, and programs have been admitted.
const samplers::SamplerInfo& find_sampler(const TomlReader& reader) {
    const std::string name = reader.text("sampler");
    const auto randomise = reader.optional_text("randomise");
    const auto folder = std::filesystem::path(reader.origin()).parent_path();
    if (names_point_file(name)) return load_point_file(name, randomise.value_or(""), folder).info;
    if (randomise) reader.fail("randomise", "(only points of a file have it: \"file:points.npy\"). Remove the key.");
    if (names_command(name)) {
        const auto* added = samplers::find_added(name);  // the full name, as it was stored
        if (added == nullptr) added = samplers::find_added(full_command_name(name, folder));
        if (added == nullptr)
            throw UserError(
                "the program has not been admitted (reading a study runs nothing). Admit it first, see "
                "studies/outside/outside_code.hpp.");
        return added->entry().info;
    }
    return samplers::find(name).info;
}

/// The sampler that a method names; null where its estimator takes none.
const samplers::SamplerInfo* read_sampler(const TomlReader& reader, const EstimatorInfo& estimator) {
    if (!estimator.takes_points()) {
        if (reader.has("sampler"))
            reader.fail("sampler", fmt::format("({} {}). Remove the key.", estimator.name,
                                               estimator.own_points ? "makes its own points"
                                                                    : "evaluates a formula at no points"));
        return nullptr;
    }
    static_cast<void>(reader.text("sampler"));  // missing or no text: said without "is refused"
    const samplers::SamplerInfo* info = nullptr;
    try {
        info = &find_sampler(reader);
    } catch (const UserError& error) {
        reader.fail("sampler", fmt::format("is refused: {}", error.what()));
    }
    if (estimator.observes == Observes::hits && !info->equal_weights) {
        reader.fail("sampler",
                    "cannot shoot rays (its points have unequal weights and hits are counted). Use estimator = "
                    "\"area_kernel\" or \"point_to_polygon\".");
    }
    return info;
}

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

/// The samples of the resolutions of a projection.
std::vector<std::uint64_t> read_resolutions(const TomlReader& reader, const EstimatorEntry& estimator) {
    constexpr std::uint64_t most_resolution = 1u << 15;
    if (reader.has("samples_per_patch"))
        reader.fail("resolution", "(stands beside samples_per_patch, which says the same). Keep one.");
    std::vector<std::uint64_t> samples;
    for (const std::uint64_t resolution : reader.counts("resolution")) {
        samples.push_back(resolution > most_resolution ? 0 : estimator.samples_of_resolution(resolution));
        if (samples.back() == 0)
            reader.fail("resolution",
                        fmt::format("({} has no resolution {}). Try 32 or 512.", estimator.info.name, resolution));
    }
    return samples;
}

/// Numbers of points for an estimator that makes its own points.
std::vector<std::uint64_t> read_own_samples(const TomlReader& reader, const EstimatorEntry& estimator) {
    if (reader.has("resolution")) return read_resolutions(reader, estimator);
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
    if (reader.has("resolution") && estimator.samples_of_resolution == nullptr)
        reader.fail("resolution",
                    fmt::format("({} has none). Remove the key; hemicube, cubic_tetrahedron and single_plane have one.",
                                method.estimator));
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
    std::vector<std::string_view> known{"name",       "sampler",    "randomise",        "estimator",
                                        "completion", "allocation", "tracer",           "map",
                                        "nodes",      "sizes",      "patches_per_face", "samples_per_patch",
                                        "resolution", "trials",     "claimed_error",    "claimed_level"};
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
    static constexpr std::array<std::string_view, 4> size_keys{"patches_per_face", "samples_per_patch", "resolution",
                                                               "trials"};
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

}  // namespace ff::studies
