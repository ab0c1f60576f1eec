#pragma once

#include "samplers/sampler.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::samplers {

/// A sampler from outside the catalogue: points from a file, a program, a plug-in, or a program that links to this
/// library. Once added, `find` finds it by name like any other.
class AddedSampler {
  public:
    struct Texts {
        std::string name;
        std::string summary;
        std::string details;
    };
    using Make = std::function<std::unique_ptr<PointSource>(const PointSetSpec&)>;
    /// Name and bytes of the file that the points are made from.
    using Content = std::vector<std::pair<std::string, std::string>>;

    /// @param traits  SamplerInfo without its texts and `at_hand`
    /// @param at_hand  available sizes, ascending; empty: as `traits.sizes` says
    /// @param make  null where only the description is known, as when stored results are read
    /// @param content  kept in the store, so that reports need no files; empty where `make` needs more than bytes
    AddedSampler(Texts texts, SamplerInfo traits, std::vector<std::uint64_t> at_hand, Make make, Content content = {});
    AddedSampler(const AddedSampler&) = delete;
    AddedSampler& operator=(const AddedSampler&) = delete;
    ~AddedSampler() = default;

    [[nodiscard]] const CatalogueEntry& entry() const { return entry_; }
    [[nodiscard]] const Content& content() const { return content_; }
    /// Whether more than the description is known.
    [[nodiscard]] bool makes_points() const;
    /// @throws UserError where only the description is known
    [[nodiscard]] std::unique_ptr<PointSource> make(const PointSetSpec& spec) const;

    /// From now on this makes points as `other` does, unless it has made some already.
    void learn_from(AddedSampler& other);

  private:
    Texts texts_;
    std::vector<std::uint64_t> at_hand_;
    mutable std::mutex mutex_;
    Make make_;
    Content content_;
    CatalogueEntry entry_;
};

/// The fate of a short name that another sampler already has.
enum class ShortName {
    stays,  ///< the new sampler is refused
    moves,  ///< the name passes to the new sampler
};

/// Adds a sampler for the rest of the process. A name always stands for the same points, so a sampler that is already
/// there stays as it is. Safe from any thread.
/// @param short_name  another name for it; empty: none
/// @throws UserError where the name is in the catalogue, or the short name is taken and stays
const CatalogueEntry& add(std::unique_ptr<AddedSampler> sampler, const std::string& short_name = {},
                          ShortName taken = ShortName::stays);

/// The sampler with this name or short name; null where there is none.
const AddedSampler* find_added(std::string_view name);

/// All samplers with a short name, by that name.
std::vector<std::pair<std::string, const AddedSampler*>> added_with_short_names();

}  // namespace ff::samplers
