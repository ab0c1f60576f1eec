#include "samplers/added.hpp"

#include "core/support/error.hpp"
#include "samplers/entry.hpp"

#include <map>
#include <mutex>

#include <fmt/format.h>

namespace ff::samplers {
namespace {

/// Only ever grows, so references into it stay valid.
struct Registry {
    std::mutex mutex;
    std::map<std::string, std::unique_ptr<AddedSampler>, std::less<>> samplers;
};

Registry& registry() {
    static Registry all;
    return all;
}

std::unique_ptr<PointSource> make_added(const CatalogueEntry& self, const PointSetSpec& spec) {
    require_size(self.info, spec);
    return self.added->make(spec);
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

const CatalogueEntry& add(std::unique_ptr<AddedSampler> sampler) {
    const std::string name(sampler->entry().info.name);
    for (const auto samplers : {catalogue(), controls()}) {
        for (const CatalogueEntry& known : samplers) {
            if (known.info.name == name)
                throw UserError(fmt::format("sampler \"{}\" (there is one of this name already). Rename it.", name));
        }
    }
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    return all.samplers.try_emplace(name, std::move(sampler)).first->second->entry();
}

const AddedSampler* find_added(std::string_view name) {
    Registry& all = registry();
    const std::lock_guard lock(all.mutex);
    const auto found = all.samplers.find(name);
    return found == all.samplers.end() ? nullptr : found->second.get();
}

}  // namespace ff::samplers
