#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

// The format: http://www.geomview.org/docs/html/OFF.html

namespace ff::studies::meshes {
namespace {

constexpr std::string_view off_mark = "OFF";

/// OFF after any of ST, C, N, 4 and n.
bool is_off_keyword(std::string_view word) {
    constexpr std::size_t longest = 9;
    return word.size() <= longest && word.ends_with(off_mark) &&
           word.substr(0, word.size() - off_mark.size()).find_first_not_of("STCN4n") == std::string_view::npos;
}

/// Takes a line for every vertex and every polygon, with whatever follows its coordinates or corners: normals, colours
/// and places in pictures.
class OffReader {
  public:
    OffReader(std::string_view file, std::string_view bytes) : file_(file), rest_(bytes), mesh_(file) {}

    SurfaceMesh read() && {
        MeshInput header = read_keyword();
        const std::uint64_t vertices = header.count();
        const std::uint64_t polygons = header.count();  // the number of edges may follow, and tells nothing
        missing_ = fmt::format("{} vertices and {} polygons", vertices, polygons);
        for (std::uint64_t i = 0; i < vertices; ++i) mesh_.add_point(next_line().place(float64_type));
        for (std::uint64_t i = 0; i < polygons; ++i) read_polygon(i);
        if (has_line()) fail(fmt::format("a line follows the {} (their numbers are wrong). Correct them.", missing_));
        return std::move(mesh_);
    }

  private:
    std::string_view file_;
    std::string_view rest_;
    SurfaceMesh mesh_;
    std::string_view line_;
    std::uint64_t number_ = 0;  ///< number of the line
    std::string missing_ = "its numbers of vertices and polygons";

    [[noreturn]] void fail(std::string_view problem) const { throw UserError("{}:{}: {}", file_, number_, problem); }

    /// Goes to the next line that has more than a comment.
    bool has_line() {
        while (!rest_.empty()) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            const std::string_view line = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            ++number_;
            line_ = trimmed(line.substr(0, line.find('#')));
            if (!line_.empty()) return true;
        }
        return false;
    }

    [[nodiscard]] MeshInput next_line() {
        if (!has_line())
            fail(fmt::format(
                "it ends before {}, each on a line of its own (it was cut off, or a number is wrong). Write it again.",
                missing_));
        return MeshInput::part(fmt::format("{}:{}", file_, number_), line_, Encoding::text);
    }

    /// @return the line with the numbers of things, which may be that of the keyword or do without one
    MeshInput read_keyword() {
        MeshInput line = next_line();
        if (!is_off_keyword(line.next_word())) return line;
        const std::string_view keyword = line.word();
        if (keyword.find_first_of("4n") != std::string_view::npos)
            line.fail("{} has places of more than three coordinates. Write it as OFF.", keyword);
        if (line.next_word() == "BINARY") line.fail("the binary form of OFF is not read. Write it as text.");
        return line.at_end() ? next_line() : line;
    }

    /// Points and lines are polygons of one and two corners, and are left out.
    void read_polygon(std::uint64_t polygon) {
        MeshInput line = next_line();
        const auto corners = line.wholes(int32_type, line.count(), 1);
        for (const std::int64_t corner : corners) line.expect_index(corner, mesh_.point_count());
        if (corners.size() > 2) mesh_.add_polygon(unnamed_group, corners, fmt::format("polygon {}", polygon));
    }
};

}  // namespace

bool is_off(std::string_view bytes) {
    return is_off_keyword(bytes.substr(0, std::min(bytes.find_first_of(" \t\r\n"), bytes.size())));
}

SurfaceMesh read_off(std::string_view file, std::string_view bytes) {
    return OffReader(file, bytes).read();
}

}  // namespace ff::studies::meshes
