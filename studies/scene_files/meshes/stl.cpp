#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

// The formats: https://www.loc.gov/preservation/digital/formats/fdd/fdd000505.shtml (text), fdd000504.shtml (binary)

namespace ff::studies::meshes {
namespace {

constexpr std::size_t stl_header = 80;
constexpr std::int64_t stl_record = 50;  // bytes: a normal, three corners, two bytes of attributes
constexpr std::size_t stl_normal = 12;
constexpr NumberType stl_count{NumberType::Kind::natural, 4};
constexpr NumberType stl_float{NumberType::Kind::real, 4};

/// A polygon of the last three points: triangles of STL share none.
void add_triangle(SurfaceMesh& mesh, std::string_view group) {
    const auto end = static_cast<std::int64_t>(mesh.point_count());
    mesh.add_polygon(group, std::array{end - 3, end - 2, end - 1}, "triangle");
}

class StlTextReader {
  public:
    StlTextReader(std::string_view file, std::string_view bytes) : in_(file, bytes), mesh_(file) {}

    SurfaceMesh read() && {
        do {
            read_solid();
        } while (!in_.at_end());
        return std::move(mesh_);
    }

  private:
    MeshInput in_;
    SurfaceMesh mesh_;
    std::set<std::string> groups_;

    [[nodiscard]] bool follows(std::string_view keyword) const { return in_small_letters(in_.next_word()) == keyword; }

    void expect(std::string_view keyword) {
        if (!in_.at_end() && !follows(keyword))
            in_.fail("'{}' stands where '{}' is expected. Write it again.", excerpt(in_.next_word()), keyword);
        static_cast<void>(in_.word());
    }

    /// The rest of the line after `solid`, which ends where a file in a single line has its first facet.
    std::string name_of_solid() {
        const MeshInput beginning = in_;
        std::string line(in_.line());
        const std::size_t facet = (" " + in_small_letters(line)).find(" facet normal ");
        if (facet == std::string::npos) return line;
        in_ = beginning;
        std::string name;
        while (!follows("facet")) name += fmt::format("{}{}", name.empty() ? "" : " ", in_.word());
        return name;
    }

    /// A name that no solid before has; all occluders are one.
    std::string group_of(const std::string& name) {
        const std::string first = name.empty() ? std::string(unnamed_group) : name;
        std::string group = first;
        for (int number = 2; group != occluder_group && !groups_.insert(group).second; ++number)
            group = fmt::format("{}.{}", first, number);
        return group;
    }

    /// The rest of the line after `endsolid`, or what stands before the next solid in a file of a single line.
    void skip_name_of_end() {
        const MeshInput beginning = in_;
        if (in_small_letters(in_.line()).find(" facet normal ") == std::string::npos) return;
        in_ = beginning;
        while (!follows("solid")) static_cast<void>(in_.word());
    }

    /// The rest of the line after `solid` is its name. What stands after `endsolid` is not compared with it, since many
    /// programs write nothing there. Every solid is a group, also where several have the same name or none.
    void read_solid() {
        expect("solid");
        const std::string name = name_of_solid();
        if (!name.empty()) in_.set_section("solid " + name);
        const std::string group = group_of(name);
        while (!follows("endsolid")) read_facet(group);
        expect("endsolid");
        skip_name_of_end();
        in_.set_section("");
    }

    void read_facet(std::string_view group) {
        expect("facet");
        expect("normal");
        for (int i = 0; i < 3; ++i) static_cast<void>(in_.word());  // corners tell the normal
        expect("outer");
        expect("loop");
        for (int i = 0; i < 3; ++i) {
            expect("vertex");
            mesh_.add_point(in_.place(stl_float));
        }
        expect("endloop");
        expect("endfacet");
        add_triangle(mesh_, group);
    }
};

/// The number of triangles has to be that of the file: a file with more or fewer bytes was damaged, and nothing tells
/// which of both is right.
SurfaceMesh read_binary_stl(std::string_view file, std::string_view bytes) {
    MeshInput in(file, bytes);
    if (bytes.find('\0') == std::string_view::npos)
        in.fail("no STL file (its text would begin with 'solid'). Rename it, or write it again.");
    SurfaceMesh mesh(file);
    in.set_encoding(Encoding::little_endian);
    in.skip_bytes(std::min(stl_header, bytes.size()));
    const std::int64_t count = in.whole(stl_count);
    if (std::cmp_not_equal(in.left(), count * stl_record))
        in.fail(
            "{} triangles are announced, which take {} bytes, and {} follow (it was cut off, or the number is wrong; a "
            "text begins with 'solid' and has no zero bytes). Write it again.",
            count, count * stl_record, in.left());
    for (std::int64_t i = 0; i < count; ++i) {
        in.skip_bytes(stl_normal);
        for (int corner = 0; corner < 3; ++corner) mesh.add_point(in.place(stl_float));
        in.skip_bytes(2);
        add_triangle(mesh, unnamed_group);
    }
    return mesh;
}

/// A binary file has no mark, and may begin with `solid` too, but is as long as its number of triangles says.
bool is_binary_stl(std::string_view bytes) {
    if (bytes.size() < stl_header + stl_count.bytes) return false;
    auto input = MeshInput::part("", bytes.substr(stl_header), Encoding::little_endian);
    const std::int64_t count = input.whole(stl_count);
    return count > 0 && std::cmp_equal(input.left(), count * stl_record);
}

bool begins_with_solid(std::string_view bytes) {
    constexpr std::string_view solid = "solid";
    const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    return in_small_letters(bytes.substr(begin, solid.size())) == solid;
}

}  // namespace

bool is_stl(std::string_view bytes) {
    constexpr std::size_t where_facets_begin = 65536;
    if (is_binary_stl(bytes)) return true;
    const std::string beginning = in_small_letters(bytes.substr(0, where_facets_begin));
    return begins_with_solid(beginning) && beginning.find("facet") != std::string::npos;
}

SurfaceMesh read_stl(std::string_view file, std::string_view bytes) {
    const bool is_text = begins_with_solid(bytes) && bytes.find('\0') == std::string_view::npos;
    if (is_text) return StlTextReader(file, bytes).read();
    return read_binary_stl(file, bytes);
}

}  // namespace ff::studies::meshes
