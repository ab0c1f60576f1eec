#include "studies/point_files/file_sampler.hpp"

#include "core/points/stream.hpp"
#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "studies/point_files/point_file.hpp"
#include "studies/readers/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <system_error>

namespace ff::studies {
namespace {

using samplers::AddedSampler;
using samplers::PointSet;
using samplers::Randomisation;

constexpr std::string_view file_prefix = "file:";
constexpr std::string_view ladder = "{n}";
/// Files of more bytes, all of a ladder together, are not copied into the store.
constexpr std::size_t most_kept = std::size_t{16} << 20;

struct Name {
    std::string path;
    std::string randomise;  ///< empty where it is not said
    std::string hash;       ///< 16 hexadecimal digits, or empty
};

/// Cuts off what follows the last #, if `fits`.
template <class Predicate>
std::string take_last(std::string& text, Predicate fits) {
    const std::size_t at = text.rfind('#');
    if (at == std::string::npos || !fits(std::string_view(text).substr(at + 1))) return {};
    std::string last = text.substr(at + 1);
    text.resize(at);
    return last;
}

Name parse_name(std::string_view sampler) {
    Name name{std::string(sampler.substr(file_prefix.size())), {}, {}};
    name.hash = take_last(name.path, is_hash);
    name.randomise =
        take_last(name.path, [](std::string_view text) { return samplers::find_randomisation(text).has_value(); });
    return name;
}

/// The files that a pattern with {n} stands for, by n.
std::map<std::uint64_t, std::filesystem::path> files_of_ladder(const std::filesystem::path& pattern) {
    const std::string name = pattern.filename().string();
    const std::size_t at = name.find(ladder);
    if (at == std::string::npos)
        throw UserError("{}: {} (only the file's own name may have it). Move it there.", pattern.string(), ladder);
    const std::string before = name.substr(0, at);
    const std::string after = name.substr(at + ladder.size());
    std::map<std::uint64_t, std::filesystem::path> files;
    std::error_code error;
    const auto folder = pattern.has_parent_path() ? pattern.parent_path() : std::filesystem::path(".");
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string file = entry->path().filename().string();
        if (file.size() <= before.size() + after.size() || !file.starts_with(before) || !file.ends_with(after))
            continue;
        const std::string digits = file.substr(before.size(), file.size() - before.size() - after.size());
        if (const auto n = parse_bare_number<std::uint64_t>(digits)) files[*n] = pattern.parent_path() / file;
    }
    if (files.empty())
        throw IoError("{}: no such files ({} stands for a number of points). Check the folder.", pattern.string(),
                      ladder);
    return files;
}

AddedSampler::Content read_content(const std::string& path, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / path;
    AddedSampler::Content content;
    if (path.find(ladder) == std::string::npos) {
        content.emplace_back(path, read_regular_file(file));
    } else {
        for (const auto& [n, step] : files_of_ladder(file))
            content.emplace_back(step.lexically_relative(folder.empty() ? "." : folder).string(),
                                 read_regular_file(step));
    }
    return content;
}

std::string_view what_it_keeps(Randomisation how) {
    switch (how) {
        case Randomisation::none:
            return "Not randomised: trial t takes set t of the file, so there are as many trials as sets, and a file "
                   "of "
                   "one set is deterministic. Whether the mean is unbiased is the file's affair.";
        case Randomisation::shift:
            return "Every trial shifts the set by a random vector, modulo 1. Each point becomes uniform, so estimates "
                   "are unbiased. It keeps lattices; of nets it keeps none of the boxes, but their discrepancy up to a "
                   "factor.";
        case Randomisation::digital_shift:
            return "Every trial combines the digits with those of a random vector (exclusive or). Each point becomes "
                   "uniform, so estimates are unbiased. It keeps nets in base 2, and no lattice.";
        case Randomisation::lms:
            return "Every trial multiplies the digits by a random triangular matrix and adds a random vector. Each "
                   "point becomes uniform, so estimates are unbiased. It keeps nets in base 2, and no lattice.";
        case Randomisation::owen:
            return "Every trial scrambles the digits by nested random permutations (by a hash). Each point becomes "
                   "uniform, so estimates are unbiased. It keeps nets in base 2, and of smooth integrands the variance "
                   "of a net falls faster than 1/N^2; it keeps no lattice.";
    }
    return "";
}

const samplers::CatalogueEntry& add_file(const Name& name, AddedSampler::Content content, const std::string& hash) {
    const auto how = samplers::find_randomisation(name.randomise).value_or(Randomisation::none);
    const std::string full = fmt::format("{}{}#{}#{}", file_prefix, name.path,
                                         samplers::randomisation_names.at(static_cast<std::size_t>(how)), hash);
    if (const AddedSampler* known = samplers::find_added(full); known != nullptr && known->makes_points())
        return known->entry();
    std::map<std::uint64_t, std::shared_ptr<const PointSet>> sets;
    std::vector<std::uint64_t> sizes;
    for (const auto& [file, bytes] : content) {
        auto set = std::make_shared<const PointSet>(parse_points(bytes, file));
        if (content.size() == 1 && is_ld_data(bytes)) sizes = nested_sizes(*set);
        const std::uint64_t points = set->points;
        if (!sets.emplace(points, std::move(set)).second)
            throw UserError("{}: {} points (another file of {}{} has as many). Remove one.", file, points, file_prefix,
                            name.path);
    }
    samplers::SamplerInfo traits;
    traits.most_trials = how == Randomisation::none ? std::uint64_t{1} << 32 : 0;
    traits.randomised = how != Randomisation::none;
    for (const auto& [points, set] : sets) {
        sizes.push_back(points);
        traits.most_dimension = std::min(traits.most_dimension, set->dimension);
        if (how == Randomisation::none) traits.most_trials = std::min(traits.most_trials, set->sets);
    }
    if (how == Randomisation::none) traits.randomised = traits.most_trials > 1;
    std::string details =
        fmt::format("{} coordinates a point{}. {}", traits.most_dimension,
                    traits.most_trials > 0 ? fmt::format(", {} sets", traits.most_trials) : "", what_it_keeps(how));
    std::size_t bytes_in_all = 0;
    for (const auto& [file, bytes] : content) bytes_in_all += bytes.size();
    if (bytes_in_all > most_kept) content.clear();
    auto make = [sets, how](const samplers::PointSetSpec& spec) {
        return samplers::points_of_set(sets.lower_bound(spec.points)->second, spec.points, how);
    };
    return samplers::add(std::make_unique<AddedSampler>(
        AddedSampler::Texts{full, fmt::format("points of the file {}", name.path), std::move(details)}, traits,
        std::move(sizes), std::move(make), std::move(content)));
}

}  // namespace

std::string read_regular_file(const std::filesystem::path& file) {
    std::error_code status;
    if (std::filesystem::exists(file, status) && !std::filesystem::is_regular_file(file, status))
        throw IoError("{}: not a file (points are read from files). Check the name.", file.string());
    return read_bytes(file);
}

std::string hash_of(const samplers::AddedSampler::Content& content) {
    std::string all;
    for (const auto& [name, bytes] : content) {
        const StreamKey part = derive_key(Seed{bytes.size()}, bytes);
        all += fmt::format("{:08x}{:08x}", part.word0, part.word1);
    }
    if (content.size() == 1) return all;
    const StreamKey whole = derive_key(Seed{content.size()}, all);
    return fmt::format("{:08x}{:08x}", whole.word0, whole.word1);
}

bool is_hash(std::string_view text) {
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool names_point_file(std::string_view sampler) {
    return sampler.starts_with(file_prefix);
}

const samplers::CatalogueEntry& load_point_file(std::string_view sampler, std::string_view randomise,
                                                const std::filesystem::path& folder) {
    if (const AddedSampler* known = samplers::find_added(sampler)) return known->entry();
    Name name = parse_name(sampler);
    if (!randomise.empty()) {
        if (!name.randomise.empty())
            throw UserError("{} (says already how points are randomised). Remove 'randomise'.", sampler);
        if (!samplers::find_randomisation(randomise))
            throw UserError("randomise = \"{}\" (unknown). Choose one of {}.", randomise,
                            fmt::join(samplers::randomisation_names, ", "));
        name.randomise = randomise;
    }
    AddedSampler::Content content = read_content(name.path, folder);
    const std::string hash = hash_of(content);
    if (!name.hash.empty() && name.hash != hash)
        throw UserError(
            "{}: other points than before (their hash is {}, not {}). Bring the file back, or "
            "leave the hash out.",
            name.path, hash, name.hash);
    return add_file(name, std::move(content), hash);
}

const samplers::CatalogueEntry& restore_point_file(std::string_view sampler, AddedSampler::Content content) {
    const Name name = parse_name(sampler);
    const std::string hash = hash_of(content);
    if (name.hash != hash)
        throw UserError(
            "{}: the points that were kept are damaged (their hash is {}). Take a copy, or "
            "remove the store and run the study again.",
            sampler, hash);
    return add_file(name, std::move(content), hash);
}

}  // namespace ff::studies
