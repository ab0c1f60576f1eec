#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"
#include "studies/scene_files/meshes/vtk_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

// The format: https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html

namespace ff::studies::meshes {
namespace {

constexpr NumberType byte_type{NumberType::Kind::natural, 1};

class LegacyReader {
  public:
    LegacyReader(std::string_view file, std::string_view bytes) : file_(file), in_(file, bytes), mesh_(file) {}

    SurfaceMesh read() && {
        in_.line();  // the version, which is not needed: differences are noticed where they occur
        in_.line();  // a title
        in_.set_section("header");
        const std::string encoding = in_capitals(in_.line());
        if (encoding != "ASCII" && encoding != "BINARY")
            in_.fail("the third line is '{}', not ASCII or BINARY. Correct it.", excerpt(encoding));
        if (encoding == "BINARY") in_.set_encoding(Encoding::big_endian);
        while (!in_.at_end()) {
            const std::string keyword = in_capitals(in_.word());
            in_.set_section(keyword);
            read_section(keyword);
        }
        return finish();
    }

  private:
    enum class Owner { none, cells, points };

    std::string_view file_;
    MeshInput in_;
    SurfaceMesh mesh_;
    std::array<VtkCells, vtk_sections.size()> of_sections_;
    VtkCells cells_;
    Owner owner_ = Owner::none;
    std::uint64_t owned_ = 0;  ///< number of cells or points that arrays belong to
    VtkArrays arrays_;         ///< arrays of cells

    void read_section(const std::string& keyword) {
        for (std::size_t i = 0; i < vtk_sections.size(); ++i) {
            if (vtk_sections[i].legacy == keyword) return read_connections(of_sections_[i]);
        }
        if (keyword == "DATASET") {
            const std::string kind = in_capitals(in_.word());
            if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
                in_.fail(
                    "'{}' is not read (POLYDATA and UNSTRUCTURED_GRID are). Extract the surface, as ParaView's filter "
                    "Extract Surface does.",
                    excerpt(kind));
        } else if (keyword == "POINTS") {
            read_points();
        } else if (keyword == "CELLS") {
            read_connections(cells_);
        } else if (keyword == "CELL_TYPES") {
            const std::uint64_t count = in_.count();
            in_.line();
            cells_.types = in_.wholes(int32_type, count, 1);
        } else if (keyword == "CELL_DATA" || keyword == "POINT_DATA") {
            owner_ = keyword == "CELL_DATA" ? Owner::cells : Owner::points;
            owned_ = in_.count();
        } else if (keyword == "METADATA") {
            skip_metadata();
        } else if (keyword == "FIELD") {
            read_fields();
        } else {
            read_attribute(keyword);
        }
    }

    NumberType type(std::string_view name) const {
        const auto known = number_type_named(in_capitals(name), &NumberTypeNames::vtk_legacy);
        if (!known) in_.fail("numbers of type '{}' are not read. Leave them out.", excerpt(name));
        return *known;
    }

    void read_points() {
        if (mesh_.point_count() > 0) in_.fail("the file has points twice. Leave one out.");
        const std::uint64_t count = in_.count();
        const NumberType real = type(in_.word());
        in_.line();
        const std::vector<double> values = in_.reals(real, count, 3);
        for (std::size_t i = 0; i < values.size(); i += 3) mesh_.add_point({values[i], values[i + 1], values[i + 2]});
    }

    /// Cells as number of points and points of each, or, from version 5.1 on, as where each begins and all points.
    void read_connections(VtkCells& cells) {
        const std::uint64_t count = in_.count();
        const std::uint64_t size = in_.count();
        in_.line();
        cells.points.clear();
        cells.ends.clear();
        if (in_capitals(in_.next_word()) == "OFFSETS") return read_offsets(cells, count, size);
        const std::vector<std::int64_t> values = in_.wholes(int32_type, size, 1);
        for (std::size_t at = 0; at < values.size();) {
            const std::int64_t points = values[at++];
            if (points < 0 || static_cast<std::size_t>(points) > values.size() - at)
                in_.fail("cell {} has {} points, and {} numbers follow. Correct it.", cells.ends.size(), points,
                         values.size() - at);
            const auto begin = values.begin() + static_cast<std::ptrdiff_t>(at);
            cells.points.insert(cells.points.end(), begin, begin + points);
            cells.ends.push_back(static_cast<std::int64_t>(cells.points.size()));
            at += static_cast<std::size_t>(points);
        }
        if (cells.ends.size() != count)
            in_.fail("{} cells are announced, and there are {}. Correct it.", count, cells.ends.size());
    }

    void read_offsets(VtkCells& cells, std::uint64_t count, std::uint64_t size) {
        cells.ends = read_named("OFFSETS", count);
        cells.points = read_named("CONNECTIVITY", size);
        if (!cells.ends.empty()) cells.ends.erase(cells.ends.begin());  // where the first cell begins: 0
    }

    std::vector<std::int64_t> read_named(std::string_view name, std::uint64_t count) {
        if (in_capitals(in_.next_word()) != name)
            in_.fail("'{}' stands where {} is expected. Correct it.", excerpt(in_.next_word()), name);
        static_cast<void>(in_.word());
        const NumberType whole = type(in_.word());
        in_.line();
        return in_.wholes(whole, count, 1);
    }

    /// Lines up to an empty one.
    void skip_metadata() {
        in_.line();
        while (in_.left() > 0 && !in_.line().empty()) {
        }
    }

    void read_fields() {
        static_cast<void>(in_.word());  // the name
        const std::uint64_t arrays = in_.count();
        for (std::uint64_t i = 0; i < arrays; ++i) {
            std::string name(in_.word());
            while (in_capitals(name) == "METADATA") {
                skip_metadata();
                name = in_.word();
            }
            in_.set_section("array " + name);
            const std::uint64_t components = in_.count();
            const std::uint64_t tuples = in_.count();
            const std::string number_type(in_.word());
            in_.line();
            read_array(name, number_type, tuples, components);
        }
    }

    void read_attribute(const std::string& keyword) {
        constexpr std::array<std::pair<std::string_view, std::uint64_t>, 8> widths{{{"VECTORS", 3},
                                                                                    {"NORMALS", 3},
                                                                                    {"TENSORS", 9},
                                                                                    {"TENSORS6", 6},
                                                                                    {"GLOBAL_IDS", 1},
                                                                                    {"PEDIGREE_IDS", 1},
                                                                                    {"EDGE_FLAGS", 1},
                                                                                    {"TEXTURE_COORDINATES", 0}}};
        if (keyword == "SCALARS") return read_scalars();
        if (keyword == "COLOR_SCALARS" || keyword == "LOOKUP_TABLE") return skip_colours(keyword == "LOOKUP_TABLE");
        const auto* const width =
            std::find_if(widths.begin(), widths.end(), [&](const auto& entry) { return entry.first == keyword; });
        if (width == widths.end()) in_.fail("no keyword of this format. Write the file again.");
        static_cast<void>(in_.word());  // the name
        const std::uint64_t components = width->second == 0 ? in_.count() : width->second;
        const NumberType number = type(in_.word());
        in_.line();
        in_.skip(number, owned_, components);
    }

    void read_scalars() {
        const std::string name(in_.word());
        in_.set_section("array " + name);
        const std::string number_type(in_.word());
        const MeshInput rest = in_;
        const bool has_components = !in_.line().empty();
        std::uint64_t components = 1;
        if (has_components) {
            in_ = rest;
            components = in_.count();
            in_.line();
        }
        if (in_capitals(in_.next_word()) == "LOOKUP_TABLE") in_.line();
        read_array(name, number_type, owned_, components);
    }

    void skip_colours(bool is_table) {
        static_cast<void>(in_.word());  // the name
        const std::uint64_t width = in_.count();
        in_.line();
        in_.skip(byte_type, is_table ? width : owned_, is_table ? 4 : width);
    }

    /// A text of an array: a line, or in binary its length and its bytes. The two highest bits of the length tell how
    /// many bytes it has itself.
    std::string text() {
        if (in_.encoding() == Encoding::text) return percent_decoded(in_.line());
        const auto byte = [&] { return static_cast<std::uint64_t>(in_.whole(byte_type)); };
        const std::uint64_t first = byte();
        constexpr std::array<int, 4> further_bytes{7, 3, 1, 0};
        std::uint64_t length = first & 0x3fU;
        for (int left = further_bytes.at(first >> 6U); left > 0; --left) length = length << 8U | byte();
        return std::string(in_.take_bytes(length));
    }

    void read_array(const std::string& word, std::string_view type_name, std::uint64_t tuples,
                    std::uint64_t components) {
        const std::string name = percent_decoded(word);
        const bool is_of_cells = owner_ == Owner::cells;
        if (in_capitals(type_name) == "STRING") {
            in_.expect_room(tuples, components, 1);
            std::vector<std::string> texts;
            for (std::uint64_t i = 0; i < tuples * components; ++i) {
                if (in_.left() == 0)
                    in_.fail("{} texts are announced, and {} follow (the file was cut off). Write it again.",
                             tuples * components, i);
                texts.push_back(text());
            }
            if (is_of_cells && components == 1) arrays_.usable.push_back({name, {}, std::move(texts)});
            return;
        }
        const NumberType number = type(type_name);
        const auto read = [&] { return in_.wholes(number, tuples, 1); };
        if (!is_of_cells || !arrays_.add(name, number, components, read)) in_.skip(number, tuples, components);
    }

    SurfaceMesh finish() {
        in_.set_section("");
        if (cells_.types.size() != cells_.ends.size())
            in_.fail("{} cells have {} types. Correct CELLS or CELL_TYPES.", cells_.ends.size(), cells_.types.size());
        for (std::size_t i = 0; i < vtk_sections.size(); ++i) cells_.append(of_sections_[i], vtk_sections[i].type);
        for (const VtkArray& array : arrays_.usable) {
            if (array.size() != cells_.ends.size())
                in_.fail("array {} has {} values for {} cells. Correct it.", excerpt(array.name), array.size(),
                         cells_.ends.size());
        }
        const std::size_t points = mesh_.point_count();
        add_pieces(mesh_, file_, {{0, points, std::move(cells_), std::move(arrays_)}});
        return std::move(mesh_);
    }
};

}  // namespace

SurfaceMesh read_vtk_legacy(std::string_view file, std::string_view bytes) {
    return LegacyReader(file, bytes).read();
}

}  // namespace ff::studies::meshes
