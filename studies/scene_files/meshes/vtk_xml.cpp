#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"
#include "studies/scene_files/meshes/vtk_cells.hpp"
#include "studies/scene_files/meshes/vtk_data_array.hpp"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The format: https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html

namespace ff::studies::meshes {
namespace {

constexpr std::string_view root_tag = "<VTKFile";
constexpr std::string_view appended_tag = "<AppendedData";

std::optional<NumberType> xml_type(std::string_view name) {
    return number_type_named(name, &NumberTypeNames::vtk_xml);
}

class XmlReader {
  public:
    XmlReader(std::string_view file, std::string_view bytes) : file_(file), mesh_(file) { parse(bytes); }

    SurfaceMesh read() && {
        const pugi::xml_node root = document_.child("VTKFile");
        const std::string kind = root.attribute("type").value();
        if (kind != "UnstructuredGrid" && kind != "PolyData")
            fail(
                fmt::format("a file of type '{}' (UnstructuredGrid and PolyData are read). Extract the surface, as "
                            "ParaView's filter Extract Surface does, and save it as .vtp.",
                            excerpt(kind)));
        read_packing(root);
        for (const pugi::xml_node piece : root.child(kind.c_str()).children("Piece")) {
            if (kind == "PolyData")
                read_poly_data(piece);
            else
                read_grid(piece);
        }
        add_pieces(mesh_, file_, pieces_);
        return std::move(mesh_);
    }

  private:
    std::string file_;
    pugi::xml_document document_;
    std::string_view appended_;
    ByteForm form_ = ByteForm::raw;
    Packing packing_;
    SurfaceMesh mesh_;
    std::vector<VtkPiece> pieces_;

    [[noreturn]] void fail(std::string_view problem) const { throw UserError(fmt::format("{}: {}", file_, problem)); }

    /// Appended data need not be XML: the document ends before them.
    void parse(std::string_view bytes) {
        std::string text(bytes);
        const std::size_t tag = bytes.find(appended_tag);
        const std::size_t begin = std::min(bytes.find('>', tag), bytes.size());
        if (tag != std::string_view::npos && begin < bytes.size()) {
            const std::string_view rest = bytes.substr(begin + 1);
            appended_ = rest.substr(std::min(rest.find('_'), rest.size()));
            if (!appended_.empty()) appended_.remove_prefix(1);
            appended_ = appended_.substr(0, appended_.rfind("</AppendedData"));
            text = fmt::format("{}</AppendedData></VTKFile>", bytes.substr(0, begin + 1));
        }
        const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
        if (result) return;
        const auto end =
            text.begin() + std::min<std::ptrdiff_t>(result.offset, static_cast<std::ptrdiff_t>(text.size()));
        throw UserError(fmt::format("{}:{}: no sound XML ({}). Write it again.", file_,
                                    1 + std::count(text.begin(), end, '\n'), result.description()));
    }

    void read_packing(pugi::xml_node root) {
        const std::string order = root.attribute("byte_order").as_string("LittleEndian");
        const std::string header = root.attribute("header_type").as_string("UInt32");
        const std::string compressor = root.attribute("compressor").value();
        const std::string encoding = root.child("AppendedData").attribute("encoding").as_string("raw");
        if (order != "LittleEndian" && order != "BigEndian")
            fail(fmt::format("byte_order '{}' (LittleEndian and BigEndian are known). Correct it.", excerpt(order)));
        if (header != "UInt32" && header != "UInt64")
            fail(fmt::format("header_type '{}' (UInt32 and UInt64 are known). Correct it.", excerpt(header)));
        if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
            fail(fmt::format("compressor '{}' (vtkZLibDataCompressor is read). Write it with that, or uncompressed.",
                             excerpt(compressor)));
        if (encoding != "raw" && encoding != "base64")
            fail(fmt::format("encoding '{}' of AppendedData (raw and base64 are known). Correct it.",
                             excerpt(encoding)));
        packing_ = {order == "BigEndian" ? Encoding::big_endian : Encoding::little_endian, *xml_type(header),
                    !compressor.empty()};
        form_ = encoding == "raw" ? ByteForm::raw : ByteForm::base64;
    }

    [[nodiscard]] std::uint64_t count(pugi::xml_node piece, const char* attribute) const {
        const std::string_view text = trimmed(piece.attribute(attribute).as_string("0"));
        const auto value = parse_bare_number<std::uint64_t>(text);
        if (!value)
            fail(fmt::format("{} is '{}', which is no number of things. Correct it.", attribute, excerpt(text)));
        return *value;
    }

    [[nodiscard]] pugi::xml_node array_of(pugi::xml_node parent, const char* name) const {
        const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) fail(fmt::format("{} has no array '{}'. Write it again.", parent.name(), name));
        return array;
    }

    /// Calls read(input) with the numbers of an array, and checks that it leaves none.
    template <class Read>
    auto with_numbers(pugi::xml_node array, Read read) const {
        const std::string place = fmt::format("{}: array '{}'", file_, excerpt(array.attribute("Name").value()));
        const std::string_view format = array.attribute("format").as_string("ascii");
        std::string bytes;
        if (format == "appended") {
            const std::uint64_t offset = count(array, "offset");
            if (offset >= appended_.size())
                fail(
                    fmt::format("array '{}' is at offset {}, of {} appended bytes (the file was cut off, or the "
                                "offset is wrong). Write it again.",
                                excerpt(array.attribute("Name").value()), offset, appended_.size()));
            bytes = unpack(place, appended_.substr(offset), form_, packing_);
        } else if (format == "binary") {
            bytes = unpack(place, array.text().get(), ByteForm::base64, packing_);
        } else if (format == "ascii") {
            bytes = array.text().get();
        } else {
            throw UserError(fmt::format("{}: format '{}' (ascii, binary and appended are known). Correct it.", place,
                                        excerpt(format)));
        }
        auto input = MeshInput::part(place, bytes, format == "ascii" ? Encoding::text : packing_.encoding);
        auto numbers = read(input);
        if (!(format == "ascii" ? input.at_end() : input.left() == 0))
            input.fail(fmt::format("it has more than the {} numbers that belong there. Correct it.", numbers.size()));
        return numbers;
    }

    [[nodiscard]] NumberType type_of(pugi::xml_node array) const {
        const std::string_view name = array.attribute("type").value();
        const auto type = xml_type(name);
        if (!type)
            fail(fmt::format("array '{}' is of type '{}', which is none of numbers. Correct it.",
                             excerpt(array.attribute("Name").value()), excerpt(name)));
        return *type;
    }

    [[nodiscard]] std::vector<std::int64_t> wholes(pugi::xml_node array, std::uint64_t size) const {
        const NumberType type = type_of(array);
        return with_numbers(array, [&](MeshInput& input) { return input.wholes(type, size, 1); });
    }

    /// @return the number of points before them, and theirs
    std::pair<std::size_t, std::size_t> read_points(pugi::xml_node piece) {
        const std::size_t before = mesh_.point_count();
        const std::uint64_t points = count(piece, "NumberOfPoints");
        if (points == 0) return {before, 0};
        const pugi::xml_node array = piece.child("Points").child("DataArray");
        if (!array) fail("a piece without its array of points. Write it again.");
        if (array.attribute("NumberOfComponents").as_int(3) != 3)
            fail(fmt::format("points of {} coordinates (three are read). Write it again.",
                             array.attribute("NumberOfComponents").as_int()));
        const NumberType type = type_of(array);
        const auto values = with_numbers(array, [&](MeshInput& input) { return input.reals(type, points, 3); });
        for (std::size_t i = 0; i < values.size(); i += 3) mesh_.add_point({values[i], values[i + 1], values[i + 2]});
        return {before, points};
    }

    /// Cells without types.
    [[nodiscard]] VtkCells read_cells(pugi::xml_node cells, std::uint64_t number) const {
        if (number == 0) return {};
        auto ends = wholes(array_of(cells, "offsets"), number);
        const std::int64_t size = ends.back();
        if (size < 0) fail(fmt::format("array 'offsets' ends with {}. Correct it.", size));
        return {wholes(array_of(cells, "connectivity"), static_cast<std::uint64_t>(size)), std::move(ends), {}};
    }

    [[nodiscard]] VtkArrays read_arrays(pugi::xml_node piece, std::uint64_t cells) const {
        VtkArrays arrays;
        // Texts stand in an Array instead of a DataArray, and are not read.
        for (const pugi::xml_node array : piece.child("CellData").children()) {
            const std::string name = array.attribute("Name").value();
            const std::uint64_t components = array.attribute("NumberOfComponents").as_uint(1);
            arrays.add(name, xml_type(array.attribute("type").value()), components,
                       [&] { return wholes(array, cells); });
        }
        return arrays;
    }

    void read_grid(pugi::xml_node piece) {
        const auto [first_point, points] = read_points(piece);
        const std::uint64_t number = count(piece, "NumberOfCells");
        if (number == 0) return;
        VtkCells cells = read_cells(piece.child("Cells"), number);
        cells.types = wholes(array_of(piece.child("Cells"), "types"), number);
        pieces_.push_back({first_point, points, std::move(cells), read_arrays(piece, number)});
    }

    void read_poly_data(pugi::xml_node piece) {
        struct Section {
            const char* name;
            const char* number;
            std::int64_t type;
        };
        // Cells count in this order, whatever the order of sections.
        constexpr std::array<Section, 4> sections{{{"Verts", "NumberOfVerts", vtk_poly_vertex},
                                                   {"Lines", "NumberOfLines", vtk_poly_line},
                                                   {"Polys", "NumberOfPolys", vtk_polygon},
                                                   {"Strips", "NumberOfStrips", vtk_triangle_strip}}};
        const auto [first_point, points] = read_points(piece);
        VtkCells cells;
        for (const Section& section : sections)
            cells.append(read_cells(piece.child(section.name), count(piece, section.number)), section.type);
        if (cells.ends.empty()) return;
        const std::uint64_t number = cells.ends.size();
        pieces_.push_back({first_point, points, std::move(cells), read_arrays(piece, number)});
    }
};

}  // namespace

bool is_vtk_xml(std::string_view bytes) {
    constexpr std::size_t longest_prologue = 1024;  // a declaration and comments
    return bytes.substr(0, longest_prologue).find(root_tag) != std::string_view::npos;
}

SurfaceMesh read_vtk_xml(std::string_view file, std::string_view bytes) {
    return XmlReader(file, bytes).read();
}

}  // namespace ff::studies::meshes
