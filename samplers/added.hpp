#pragma once

#include "samplers/sampler.hpp"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::samplers {

/// A sampler from outside the catalogue: points of a file, of a program, of a plug-in, or of a program that links with
/// this library. Where it has been added, `find` finds it by its name like any other.
class AddedSampler {
  public:
    struct Texts {
        std::string name;
        std::string summary;
        std::string details;
    };
    using Make = std::function<std::unique_ptr<PointSource>(const PointSetSpec&)>;
    /// File name and bytes of what the points are made from.
    using Content = std::vector<std::pair<std::string, std::string>>;

    /// @param traits  all of SamplerInfo but its texts and `at_hand`
    /// @param at_hand  sizes, ascending; empty: as `traits.sizes` says
    /// @param content  that a store keeps, so that reports need no files; may be empty
    AddedSampler(Texts texts, SamplerInfo traits, std::vector<std::uint64_t> at_hand, Make make, Content content = {});
    AddedSampler(const AddedSampler&) = delete;
    AddedSampler& operator=(const AddedSampler&) = delete;

    [[nodiscard]] const CatalogueEntry& entry() const { return entry_; }
    [[nodiscard]] const Content& content() const { return content_; }
    [[nodiscard]] std::unique_ptr<PointSource> make(const PointSetSpec& spec) const { return make_(spec); }

  private:
    Texts texts_;
    std::vector<std::uint64_t> at_hand_;
    Make make_;
    Content content_;
    CatalogueEntry entry_;
};

/// Adds a sampler for the rest of the process. A name stands for the same points for ever, so one that has been added
/// already stays as it is. Safe from any thread.
/// @throws UserError for the name of a sampler of the catalogue
const CatalogueEntry& add(std::unique_ptr<AddedSampler> sampler);

/// Null where there is none of this name.
const AddedSampler* find_added(std::string_view name);

}  // namespace ff::samplers
