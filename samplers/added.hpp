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
    /// @param make  null where only the description is known, as to those who read results
    /// @param content  that a store keeps, so that reports need no files; empty where `make` needs more than bytes
    AddedSampler(Texts texts, SamplerInfo traits, std::vector<std::uint64_t> at_hand, Make make, Content content = {});
    AddedSampler(const AddedSampler&) = delete;
    AddedSampler& operator=(const AddedSampler&) = delete;
    ~AddedSampler() = default;

    [[nodiscard]] const CatalogueEntry& entry() const { return entry_; }
    [[nodiscard]] const Content& content() const { return content_; }
    /// @throws UserError where only the description is known
    [[nodiscard]] std::unique_ptr<PointSource> make(const PointSetSpec& spec) const;

    /// Makes points as `other` does from now on, where nothing has made them so far.
    void learn_from(AddedSampler& other);

  private:
    Texts texts_;
    std::vector<std::uint64_t> at_hand_;
    mutable std::mutex mutex_;
    Make make_;
    Content content_;
    CatalogueEntry entry_;
};

/// What becomes of a short name that another sampler has.
enum class ShortName {
    stays,  ///< the name is refused
    moves,  ///< the new sampler has it from now on
};

/// Adds a sampler for the rest of the process. A name stands for the same points for ever, so one that has been added
/// already stays as it is. Safe from any thread.
/// @param short_name  by which it is found as well; empty: none
/// @throws UserError where the name is one of the catalogue, or the short name is taken and stays
const CatalogueEntry& add(std::unique_ptr<AddedSampler> sampler, const std::string& short_name = {},
                          ShortName taken = ShortName::stays);

/// By name or short name. Null where there is none.
const AddedSampler* find_added(std::string_view name);

/// All that have a short name, by it.
std::vector<std::pair<std::string, const AddedSampler*>> added_with_short_names();

}  // namespace ff::samplers
