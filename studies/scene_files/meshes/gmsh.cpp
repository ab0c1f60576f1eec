#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/gmsh_surfaces.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

// The formats: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format

namespace ff::studies::meshes {
namespace {

enum class Version { two, four_0, four_1 };

/// A type of elements of gmsh.
struct GmshElement {
    std::uint8_t dimension = 0;
    std::uint8_t corners = 0;  ///< number of corners, which are its first nodes
    std::uint16_t nodes = 0;
};

/// Types that gmsh commonly writes, by number.
constexpr std::array<std::pair<std::uint8_t, GmshElement>, 66> gmsh_types{{
    {1, {1, 2, 2}},   {2, {2, 3, 3}},   {3, {2, 4, 4}},   {4, {3, 4, 4}},    {5, {3, 8, 8}},    {6, {3, 6, 6}},
    {7, {3, 5, 5}},   {8, {1, 2, 3}},   {9, {2, 3, 6}},   {10, {2, 4, 9}},   {11, {3, 4, 10}},  {12, {3, 8, 27}},
    {13, {3, 6, 18}}, {14, {3, 5, 14}}, {15, {0, 1, 1}},  {16, {2, 4, 8}},   {17, {3, 8, 20}},  {18, {3, 6, 15}},
    {19, {3, 5, 13}}, {20, {2, 3, 9}},  {21, {2, 3, 10}}, {22, {2, 3, 12}},  {23, {2, 3, 15}},  {24, {2, 3, 15}},
    {25, {2, 3, 21}}, {26, {1, 2, 4}},  {27, {1, 2, 5}},  {28, {1, 2, 6}},   {29, {3, 4, 20}},  {30, {3, 4, 35}},
    {31, {3, 4, 56}}, {36, {2, 4, 16}}, {37, {2, 4, 25}}, {38, {2, 4, 36}},  {39, {2, 4, 12}},  {40, {2, 4, 16}},
    {41, {2, 4, 20}}, {42, {2, 3, 28}}, {43, {2, 3, 36}}, {44, {2, 3, 45}},  {45, {2, 3, 55}},  {46, {2, 3, 66}},
    {47, {2, 4, 49}}, {48, {2, 4, 64}}, {49, {2, 4, 81}}, {50, {2, 4, 100}}, {51, {2, 4, 121}}, {52, {2, 3, 18}},
    {53, {2, 3, 21}}, {54, {2, 3, 24}}, {55, {2, 3, 27}}, {56, {2, 3, 30}},  {57, {2, 4, 24}},  {58, {2, 4, 28}},
    {59, {2, 4, 32}}, {60, {2, 4, 36}}, {61, {2, 4, 40}}, {62, {1, 2, 7}},   {63, {1, 2, 8}},   {64, {1, 2, 9}},
    {65, {1, 2, 10}}, {66, {1, 2, 11}}, {90, {3, 6, 40}}, {91, {3, 6, 75}},  {92, {3, 8, 64}},  {93, {3, 8, 125}},
}};

class GmshReader {
  public:
    GmshReader(std::string_view file, std::string_view bytes) : in_(file, bytes), mesh_(file) {}

    SurfaceMesh read() && {
        while (!in_.at_end()) {
            const std::string name(in_.line());
            in_.set_section(name);
            if (!name.starts_with('$')) in_.fail("a section was expected, which begins with $. Write it again.");
            read_section(name);
            in_.set_section("");
        }
        surfaces_.write_to(mesh_);
        return std::move(mesh_);
    }

  private:
    MeshInput in_;
    SurfaceMesh mesh_;
    Version version_ = Version::two;
    NumberType size_type_{NumberType::Kind::natural, 8};
    GmshSurfaces surfaces_;
    std::unordered_map<std::int64_t, std::int64_t> points_;  ///< points by the tag of the node
    std::unordered_map<std::int64_t, std::vector<std::int64_t>> physical_of_surface_;  ///< keys: tags

    void read_section(const std::string& name) {
        if (name == "$MeshFormat") {
            read_format();
        } else if (name == "$PhysicalNames") {
            read_names();
        } else if (name == "$Entities") {
            read_entities();
        } else if (name == "$Nodes") {
            read_nodes();
        } else if (name == "$Elements") {
            read_elements();
        } else if (name == "$PartitionedEntities") {
            in_.fail("a mesh in partitions is not read. Save it without (Mesh.PartitionCount = 0).");
        } else if (name == "$ParametricNodes") {
            in_.fail("nodes with parameters are read of version 4 alone. Save it without (Mesh.SaveParametric = 0).");
        } else {
            return in_.skip_past(end_of(name));
        }
        const std::string end = end_of(name);
        if (in_.next_word() != end)
            in_.fail(
                "'{}' stands where {} is expected (the file was cut off, or a number of things is wrong). Write it "
                "again.",
                excerpt(in_.next_word()), end);
        static_cast<void>(in_.word());
    }

    static std::string end_of(const std::string& section) { return "$End" + section.substr(1); }

    void read_format() {
        const std::string version(in_.word());
        const bool is_two = version == "2" || version.starts_with("2.");
        if (!is_two && version != "4" && version != "4.0" && version != "4.1")
            in_.fail("version '{}' (2, 4.0 and 4.1 are read). Save it as one of these.", excerpt(version));
        if (!is_two) version_ = version == "4.1" ? Version::four_1 : Version::four_0;
        const std::uint64_t binary = in_.count();
        const std::uint64_t bytes = in_.count();
        if (bytes != 8 && (is_two || bytes != 4)) in_.fail("numbers of {} bytes (8 are read). Write it again.", bytes);
        size_type_.bytes = bytes;
        in_.line();
        if (binary == 0) return;
        in_.set_encoding(Encoding::little_endian);
        const std::int64_t one = in_.whole(int32_type);
        constexpr std::int64_t turned_one = 1 << 24;
        if (one == turned_one) in_.set_encoding(Encoding::big_endian);
        if (one != 1 && one != turned_one) in_.fail("the order of bytes is told by 1, and here by {}.", one);
    }

    void read_names() {
        const std::uint64_t count = in_.count();
        in_.line();
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::string_view line = in_.line();
            const auto words = split_words(line);
            const std::size_t begin = line.find('"');
            const std::size_t end = line.rfind('"');
            const auto tag = words.size() < 3 ? std::nullopt : parse_number<std::int64_t>(words[1]);
            if (!tag || begin == end)
                in_.fail("'{}' is no dimension, tag and name in quotes. Write 2 1 \"wall\".", excerpt(line));
            if (words[0] == "2") surfaces_.set_name(*tag, std::string(line.substr(begin + 1, end - begin - 1)));
        }
    }

    [[nodiscard]] std::uint64_t size() {
        if (in_.encoding() == Encoding::text) return in_.count();
        return static_cast<std::uint64_t>(in_.whole(size_type_));
    }
    [[nodiscard]] std::int64_t integer() { return in_.whole(int32_type); }

    void read_entities() {
        if (version_ == Version::two) in_.fail("version 2 has no such section. Write it again.");
        std::array<std::uint64_t, 4> counts{};
        for (std::uint64_t& count : counts) count = size();
        for (std::size_t dimension = 0; dimension < counts.size(); ++dimension) {
            for (std::uint64_t i = 0; i < counts[dimension]; ++i) read_entity(dimension);
        }
    }

    void read_entity(std::size_t dimension) {
        const std::int64_t tag = integer();
        const std::uint64_t places = dimension == 0 && version_ == Version::four_1 ? 3 : 6;
        in_.skip(float64_type, places, 1);
        const std::uint64_t physicals = size();
        auto tags = in_.wholes(int32_type, physicals, 1);
        if (dimension == 2) physical_of_surface_.emplace(tag, std::move(tags));
        if (dimension == 0) return;
        const std::uint64_t bounding = size();
        in_.skip(int32_type, bounding, 1);
    }

    void add_node(std::int64_t tag, const std::array<double, 3>& place) {
        points_.emplace(tag, static_cast<std::int64_t>(mesh_.point_count()));
        mesh_.add_point({place[0], place[1], place[2]});
    }

    std::array<double, 3> place() {
        std::array<double, 3> coordinates{};
        for (double& coordinate : coordinates) coordinate = in_.real(float64_type);
        return coordinates;
    }

    void read_nodes() {
        if (version_ == Version::two) {
            const std::uint64_t count = in_.count();
            in_.line();
            for (std::uint64_t i = 0; i < count; ++i) {
                const std::int64_t tag = integer();
                add_node(tag, place());
            }
            return;
        }
        const std::uint64_t blocks = size();
        const std::uint64_t nodes = size() + mesh_.point_count();
        for (int i = 0; i < (version_ == Version::four_1 ? 2 : 0); ++i) static_cast<void>(size());  // tags
        for (std::uint64_t i = 0; i < blocks; ++i) read_node_block();
        if (mesh_.point_count() != nodes)
            in_.fail("{} nodes are announced, and {} follow. Write it again.", nodes, mesh_.point_count());
    }

    void read_node_block() {
        std::int64_t dimension = integer();
        const std::int64_t second = integer();
        if (version_ == Version::four_0) dimension = second;  // the tag of the entity comes first there
        const std::int64_t parametric = integer();
        if (dimension < 0 || dimension > 3) in_.fail("an entity of dimension {}. Correct it.", dimension);
        const std::uint64_t parameters = parametric != 0 ? static_cast<std::uint64_t>(dimension) : 0;
        const std::uint64_t count = size();
        std::vector<std::int64_t> tags;
        if (version_ == Version::four_1) tags = in_.wholes(size_type_, count, 1);
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::int64_t tag = version_ == Version::four_1 ? tags[i] : integer();
            add_node(tag, place());
            in_.skip(float64_type, parameters, 1);
        }
    }

    void read_elements() {
        if (version_ == Version::two)
            return in_.encoding() == Encoding::text ? read_lines_of_elements() : read_runs_of_elements();
        const std::uint64_t blocks = size();
        std::uint64_t left = size();
        for (int i = 0; i < (version_ == Version::four_1 ? 2 : 0); ++i) static_cast<void>(size());  // tags
        for (std::uint64_t i = 0; i < blocks; ++i) {
            std::int64_t tag = integer();
            const std::int64_t second = integer();
            if (version_ == Version::four_1) tag = second;  // after the dimension, which the type tells
            const GmshElement element = element_of(integer());
            const NumberType tag_type = version_ == Version::four_1 ? size_type_ : int32_type;
            const std::uint64_t count = size();
            if (count > left) in_.fail("{} elements, where {} are left of those announced. Correct it.", count, left);
            left -= count;
            const auto found = physical_of_surface_.find(tag);
            const auto physical = found == physical_of_surface_.end() ? std::vector<std::int64_t>() : found->second;
            for (std::uint64_t k = 0; k < count; ++k) {
                const std::int64_t number = in_.whole(tag_type);
                add(element, number, physical, tag, in_.wholes(tag_type, element.nodes, 1));
            }
        }
        if (left > 0) in_.fail("{} elements more are announced than there are. Write it again.", left);
    }

    /// Version 2 in text: number, type, number of tags, tags, nodes.
    void read_lines_of_elements() {
        const std::uint64_t count = in_.count();
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::int64_t number = integer();
            const GmshElement element = element_of(integer());
            read_element(number, element, in_.count());
        }
    }

    /// Version 2 in binary: runs of a type with a number of tags.
    void read_runs_of_elements() {
        const std::uint64_t count = in_.count();
        in_.line();
        for (std::uint64_t left = count; left > 0;) {
            const GmshElement element = element_of(integer());
            const std::int64_t run = integer();
            const std::int64_t tags = integer();
            if (run < 1 || static_cast<std::uint64_t>(run) > left || tags < 0)
                in_.fail("a run of {} elements with {} tags each, where {} elements are left. Correct it.", run, tags,
                         left);
            for (std::int64_t i = 0; i < run; ++i) {
                const std::int64_t number = integer();
                read_element(number, element, static_cast<std::uint64_t>(tags));
            }
            left -= static_cast<std::uint64_t>(run);
        }
    }

    /// Its tags are its physical surface, or 0, its surface, and others.
    void read_element(std::int64_t number, GmshElement element, std::uint64_t tag_count) {
        const auto tags = in_.wholes(int32_type, tag_count, 1);
        const auto physical = tags.empty() ? tags : std::vector{tags[0]};
        add(element, number, physical, tags.size() < 2 ? 0 : tags[1], in_.wholes(int32_type, element.nodes, 1));
    }

    [[nodiscard]] GmshElement element_of(std::int64_t type) const {
        const auto* const found =
            std::find_if(gmsh_types.begin(), gmsh_types.end(), [&](const auto& entry) { return entry.first == type; });
        if (found == gmsh_types.end()) in_.fail("elements of type {} are not known. Write triangles.", type);
        return found->second;
    }

    void add(GmshElement element, std::int64_t number, const std::vector<std::int64_t>& physical, std::int64_t surface,
             std::vector<std::int64_t> nodes) {
        if (element.dimension == 3) mesh_.leave_out_volume_cell();
        if (element.dimension != 2) return;
        nodes.resize(element.corners);
        for (std::int64_t& node : nodes) {
            const auto point = points_.find(node);
            if (point == points_.end())
                in_.fail("element {} has node {}, which is not in $Nodes. Correct it.", number, node);
            node = point->second;
        }
        surfaces_.add(number, physical, surface, nodes);
    }
};

}  // namespace

SurfaceMesh read_gmsh(std::string_view file, std::string_view bytes) {
    return GmshReader(file, bytes).read();
}

}  // namespace ff::studies::meshes
