#include "samplers/outside/added.hpp"

#include "core/support/error.hpp"
#include "samplers/support/entry.hpp"

#include <map>

namespace ff::samplers {
namespace {

/// Only ever grows, so references into it stay valid.
struct Registry {
    std::mutex mutex;
    std::map<std::string, std::unique_ptr<AddedSampler>, std::less<>> samplers;
    std::map<std::string, const AddedSampler*, std::less<>> short_names;
};

Registry& registry() {
    static Registry all;
    return all;
}

std::unique_ptr<PointSource> make_added(const CatalogueEntry& self, const PointSetSpec& spec) {
    require_size(self.info, spec);
    return self.added->make(spec);
}

void expect_free(std::string_view name) {
    for (const auto samplers : {catalogue(), controls()}) {
        for (const CatalogueEntry& known : samplers) {
            if (known.info.name == name)
                throw UserError("sampler \"{}\" (there is one of this name already). Rename it.", name);
        }
    }
}

}  // namespace

AddedSampler::AddedSampler(Texts texts, SamplerInfo traits, std::vector<std::uint64_t> at_hand, Make make,
                           Content content)
    : texts_(std::move(texts)),
      at_hand_(std::move(at_hand)),
      make_(std::move(make)),
      content_(std::move(content)),
      entry_{traits, &make_added, this} {
    entry_.info.name = texts_.name;
    entry_.info.summary = texts_.summary;
    entry_.info.details = texts_.details;
    entry_.info.at_hand = at_hand_;
}

bool AddedSampler::makes_points() const {
    const std::lock_guard lock(mutex_);
    return static_cast<bool>(make_);
}

std::unique_ptr<PointSource> AddedSampler::make(const PointSetSpec& spec) const {
    Make make;
    {
        const std::lock_guard lock(mutex_);
        make = make_;
    }
    if (!make)
        throw UserError(
            "sampler \"{}\" (only its results are here, not what makes its points). Run the study's file, or load its "
            "plug-in, as when the study was run first.",
            texts_.name);
    return make(spec);
}

void AddedSampler::learn_from(AddedSampler& other) {
    const std::lock_guard lock(mutex_);
    if (!make_) make_ = std::move(other.make_);
}

const CatalogueEntry& add(std::unique_ptr<AddedSampler> sampler, const std::string& short_name, ShortName taken) {
    const std::string name(sampler->entry().info.name);
    expect_free(name);
    expect_free(short_name);
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    const auto other = all.short_names.find(short_name);
    if (taken == ShortName::stays && other != all.short_names.end() && other->second->entry().info.name != name)
        throw UserError("sampler \"{}\" (there are two of this name, {} and {}). Leave one out.", short_name,
                        other->second->entry().info.name, name);
    const auto [at, is_new] = all.samplers.try_emplace(name);
    if (is_new)
        at->second = std::move(sampler);
    else
        at->second->learn_from(*sampler);
    if (!short_name.empty()) all.short_names[short_name] = at->second.get();
    return at->second->entry();
}

const AddedSampler* find_added(std::string_view name) {
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    if (const auto found = all.samplers.find(name); found != all.samplers.end()) return found->second.get();
    const auto found = all.short_names.find(name);
    return found == all.short_names.end() ? nullptr : found->second;
}

std::vector<std::pair<std::string, const AddedSampler*>> added_with_short_names() {
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    return {all.short_names.begin(), all.short_names.end()};
}

}  // namespace ff::samplers
