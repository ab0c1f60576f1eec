#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/outside/outside_points.hpp"
#include "samplers/point_sets/set_of_rows.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/point_files/file_sampler.hpp"
#include "studies/readers/printable.hpp"

#include <ffstudy/plugin.h>
#include <fmt/format.h>

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace ff::studies {
namespace {

using samplers::AddedSampler;
using samplers::SetRequest;

[[noreturn]] void refuse(const std::string& place, const std::string& problem) {
    throw UserError("{}: {}", place, problem);
}

std::string text_or_nothing(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

/// Calls a function of the plug-in. An exception of a C++ function becomes a message, too.
template <class Call>
auto call(const std::string& place, Call function) {
    try {
        return function();
    } catch (const std::exception& error) {
        refuse(place, fmt::format("throws \"{}\" (functions of a plug-in return a number instead). Fix the plug-in.",
                                  excerpt(error.what())));
    } catch (...) {
        refuse(place, "throws (functions of a plug-in return a number instead). Fix the plug-in.");
    }
}

/// The functions of one sampler, and its name in messages.
struct Functions {
    std::string origin;
    const ffstudy_sampler* sampler;

    [[nodiscard]] std::string place(const SetRequest& request) const {
        return fmt::format("{} ({})", origin, in_words(request));
    }

    void expect_none(int result, const SetRequest& request) const {
        if (result == 0) return;
        const char* const text =
            sampler->error_text == nullptr ? nullptr : call(origin, [&] { return sampler->error_text(result); });
        refuse(place(request), fmt::format("returns {}{} (0 is success). Ask the author of the plug-in.", result,
                                           text == nullptr ? "" : fmt::format(", \"{}\"", excerpt(text))));
    }

    void make_set(const SetRequest& request, samplers::PointSet& set) const {
        const auto d = static_cast<std::uint32_t>(request.dimension);
        expect_whole(origin, request);
        // Memory that each set asks for anew costs twenty times what its points do. Fields that are not filled in are
        // noticed.
        thread_local std::vector<double> rows;
        rows.assign(request.points * d, std::numeric_limits<double>::quiet_NaN());
        expect_none(call(place(request),
                         [&] { return sampler->fill(rows.data(), request.points, d, request.seed, request.trial); }),
                    request);
        samplers::set_of_rows(rows, request.points, d, place(request), set);
    }

    void fill_block(const SetRequest& request, PointIndex first, PointBlock& block) const {
        std::array<std::uint32_t*, max_dimension> rows{};
        for (std::size_t d = 0; d < max_dimension; ++d) rows[d] = block.coordinate[d].data();
        const int result = call(origin, [&] {
            return sampler->fill_block(rows.data(), first, static_cast<std::uint32_t>(block.size), request.points,
                                       static_cast<std::uint32_t>(request.dimension), request.seed, request.trial);
        });
        expect_none(result, request);
    }
};

void expect_sound_sampler(const ffstudy_sampler& sampler, const std::string& place) {
    const std::string name = text_or_nothing(sampler.name);
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
    if (name.empty() || !std::all_of(name.begin(), name.end(), fits))
        refuse(place,
               fmt::format("a sampler named \"{}\" (lower-case letters, digits and _). Rename it.", excerpt(name)));
    const auto wrong = [&](std::string_view what, std::string_view why) {
        refuse(place, fmt::format("sampler \"{}\": {} ({}). Fix the plug-in.", name, what, why));
    };
    if (sampler.fill == nullptr && sampler.fill_block == nullptr)
        wrong("neither fill nor fill_block", "one of them makes the points");
    if (sampler.most_dimension < 1 || sampler.most_dimension > max_dimension)
        wrong(fmt::format("most_dimension = {}", sampler.most_dimension), "1 to 4 coordinates");
    if (sampler.base == 1) wrong("base = 1", "a base is 2 or more, and 0 says any number of points");
    if (sampler.deterministic > 1) wrong(fmt::format("deterministic = {}", sampler.deterministic), "0 or 1");
}

const samplers::CatalogueEntry& add_sampler(const ffstudy_sampler& sampler, const std::string& file,
                                            const std::string& hash) {
    expect_sound_sampler(sampler, file);
    samplers::SamplerInfo traits;
    traits.sizes = sampler.base == 0 ? samplers::Sizes::any : samplers::Sizes::powers;
    if (sampler.base != 0) traits.base = sampler.base;
    traits.randomised = sampler.deterministic == 0;
    traits.most_dimension = sampler.most_dimension;
    const std::string name = sampler.name;
    const Functions functions{fmt::format("{} of {}", name, file), &sampler};
    samplers::FillPart fill;
    if (sampler.fill_block != nullptr)
        fill = [functions](const SetRequest& request, PointIndex first, PointBlock& block) {
            functions.fill_block(request, first, block);
        };
    else
        fill = samplers::parts_of(
            [functions](const SetRequest& request, samplers::PointSet& set) { functions.make_set(request, set); });
    std::string summary = visible_text(text_or_nothing(sampler.summary));
    std::string details = visible_text(text_or_nothing(sampler.details));
    if (summary.empty()) summary = fmt::format("of the plug-in {}", file);
    details +=
        fmt::format("{}From the plug-in {}. ffstudy check-sampler asks of it what the program's own samplers keep.",
                    details.empty() ? "" : "\n", file);
    const bool randomised = traits.randomised;
    return samplers::add(
        std::make_unique<AddedSampler>(
            AddedSampler::Texts{fmt::format("{}#{}", name, hash), std::move(summary), std::move(details)}, traits,
            std::vector<std::uint64_t>{},
            [fill, randomised](const samplers::PointSetSpec& spec) {
                return samplers::outside_points(spec.points, randomised, fill);
            }),
        name);
}

/// Opens a library once: the second time the loader returns what it has, whatever the file contains by then.
void* open_library(const std::filesystem::path& file, const std::string& shown, const std::string& hash) {
    static std::mutex mutex;
    static std::map<std::filesystem::path, std::pair<void*, std::string>> opened;
    const std::lock_guard lock(mutex);
    auto& [handle, loaded_hash] = opened[file];
    if (handle != nullptr && loaded_hash != hash)
        refuse(shown, "changed since it was loaded (a library is loaded once). Start again.");
    if (handle == nullptr) handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
        refuse(shown, fmt::format("cannot be loaded ({}). Build a shared library for this system: cc -shared -fPIC.",
                                  text_or_nothing(::dlerror())));  // NOLINT(concurrency-mt-unsafe): of this thread
    loaded_hash = hash;
    return handle;
}

}  // namespace

std::vector<const samplers::CatalogueEntry*> load_plugin(const std::filesystem::path& path,
                                                         const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / path;
    const std::string shown = file.string();
    const std::string hash = hash_of({{shown, read_regular_file(file)}});
    void* const library = open_library(std::filesystem::absolute(file), shown, hash);
    using Entry = const ffstudy_plugin*();
    auto* const entry = reinterpret_cast<Entry*>(::dlsym(library, "ffstudy_samplers"));  // NOLINT: as POSIX wants it
    if (entry == nullptr)
        refuse(shown, "no function ffstudy_samplers (a plug-in has it). Include <ffstudy/plugin.h> and define it.");
    const ffstudy_plugin* const plugin = call(shown, entry);
    if (plugin == nullptr) refuse(shown, "ffstudy_samplers returns a null pointer (expected its table). Fix it.");
    if (plugin->version != FFSTUDY_PLUGIN_VERSION)
        refuse(shown,
               fmt::format("made for version {} of the interface (this program has {}). Build it again with this "
                           "program's ffstudy/plugin.h.",
                           plugin->version, FFSTUDY_PLUGIN_VERSION));
    if (plugin->count == 0 || plugin->samplers == nullptr)
        refuse(shown, "no samplers (nothing would be added). List them in the table.");
    std::vector<const samplers::CatalogueEntry*> added;
    for (const ffstudy_sampler& sampler : std::span(plugin->samplers, plugin->count))
        added.push_back(&add_sampler(sampler, shown, hash));
    return added;
}

}  // namespace ff::studies
