#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ff::studies {

/// What is done with a polygon that cannot be used as it is.
enum class PolygonChange { no_area, twice, bent, concave, turned };

/// The lines of such polygons.
class PolygonChanges {
  public:
    void note(PolygonChange change, std::uint64_t line);
    /// A sentence for each kind of change, with the number of polygons and the first lines.
    [[nodiscard]] std::vector<std::string> in_words() const;

  private:
    static constexpr std::size_t kinds = 5;
    std::array<std::vector<std::uint64_t>, kinds> lines_;
};

}  // namespace ff::studies
