#pragma once

#include "studies/scene_files/builder.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A line of a View3D file: words between blanks or commas, without the comment.
class Vs3Line {
  public:
    /// @param builder  which refuses what is wrong with the line; outlives it, as the text does
    /// @param place    the number of the line in the file
    Vs3Line(const SceneBuilder& builder, std::uint64_t place, std::string_view text);

    [[nodiscard]] std::uint64_t place() const { return place_; }
    [[nodiscard]] bool empty() const { return words_.empty(); }
    [[nodiscard]] std::size_t size() const { return words_.size(); }
    [[nodiscard]] std::string_view operator[](std::size_t at) const { return words_[at]; }
    /// The word in quotes, or "missing".
    [[nodiscard]] std::string word(std::size_t at) const;
    /// The words from there on, with a blank between them.
    [[nodiscard]] std::string rest(std::size_t at) const;

    /// @throws UserError where no such number stands there
    [[nodiscard]] long whole(std::size_t at) const;
    [[nodiscard]] double emissivity(std::size_t at) const;

    /// Words after what is wanted are passed over; a number there may be the decimals of what was read.
    /// @throws UserError where a number stands there
    void expect_no_number(std::size_t at, std::string_view wanted) const;

  private:
    [[nodiscard]] bool is_decimal_comma(std::size_t at) const;

    const SceneBuilder& builder_;
    std::uint64_t place_;
    std::vector<std::string_view> words_;
};

}  // namespace ff::studies
