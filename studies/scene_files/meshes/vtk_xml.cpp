#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"
#include "studies/scene_files/meshes/vtk_cells.hpp"
#include "studies/scene_files/meshes/vtk_packing.hpp"

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
            refuse(file_,
                   "a file of type '{}' (UnstructuredGrid and PolyData are read). Extract the surface, as ParaView's "
                   "filter Extract Surface does, and save it as .vtp.",
                   excerpt(kind));
        read_packing(root);
        for (const pugi::xml_node piece : root.child(kind.c_str()).children("Piece"))
            read_piece(piece, kind == "UnstructuredGrid");
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
        throw UserError("{}:{}: no sound XML ({}). Write it again.", file_, 1 + std::count(text.begin(), end, '\n'),
                        result.description());
    }

    void read_packing(pugi::xml_node root) {
        const std::string order = root.attribute("byte_order").as_string("LittleEndian");
        const std::string header = root.attribute("header_type").as_string("UInt32");
        const std::string compressor = root.attribute("compressor").value();
        const std::string encoding = root.child("AppendedData").attribute("encoding").as_string("raw");
        if (order != "LittleEndian" && order != "BigEndian")
            refuse(file_, "byte_order '{}' (LittleEndian and BigEndian are known). Correct it.", excerpt(order));
        if (header != "UInt32" && header != "UInt64")
            refuse(file_, "header_type '{}' (UInt32 and UInt64 are known). Correct it.", excerpt(header));
        if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
            refuse(file_, "compressor '{}' (vtkZLibDataCompressor is read). Write it with that, or uncompressed.",
                   excerpt(compressor));
        if (encoding != "raw" && encoding != "base64")
            refuse(file_, "encoding '{}' of AppendedData (raw and base64 are known). Correct it.", excerpt(encoding));
        packing_ = {order == "BigEndian" ? Encoding::big_endian : Encoding::little_endian, *xml_type(header),
                    !compressor.empty()};
        form_ = encoding == "raw" ? ByteForm::raw : ByteForm::base64;
    }

    [[nodiscard]] std::uint64_t count(pugi::xml_node piece, const std::string& attribute) const {
        const std::string_view text = trimmed(piece.attribute(attribute.c_str()).as_string("0"));
        const auto value = parse_bare_number<std::uint64_t>(text);
        if (!value) refuse(file_, "{} is '{}', which is no number of things. Correct it.", attribute, excerpt(text));
        return *value;
    }

    [[nodiscard]] pugi::xml_node array_of(pugi::xml_node parent, const char* name) const {
        const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
        if (!array) refuse(file_, "array '{}' is missing. Write it again.", name);
        return array;
    }

    /// Calls read(input) with the values of an array, and checks that it leaves none.
    template <class Read>
    auto with_values(pugi::xml_node array, Read read) const {
        const std::string place = fmt::format("{}: array '{}'", file_, excerpt(array.attribute("Name").value()));
        const std::string_view format = array.attribute("format").as_string("ascii");
        std::string bytes;
        if (format == "appended") {
            const std::uint64_t offset = count(array, "offset");
            if (offset >= appended_.size())
                refuse(file_,
                       "array '{}' is at offset {}, of {} appended bytes (the file was cut off, or the offset is "
                       "wrong). Write it again.",
                       excerpt(array.attribute("Name").value()), offset, appended_.size());
            bytes = unpack(place, appended_.substr(offset), form_, packing_);
        } else if (format == "binary") {
            bytes = unpack(place, array.text().get(), ByteForm::base64, packing_);
        } else if (format == "ascii") {
            bytes = array.text().get();
        } else {
            refuse(place, "format '{}' (ascii, binary and appended are known). Correct it.", excerpt(format));
        }
        auto input = MeshInput::part(place, bytes, format == "ascii" ? Encoding::text : packing_.encoding);
        auto values = read(input);
        if (!(format == "ascii" ? input.at_end() : input.left() == 0))
            input.fail("it has more than the {} values that belong there. Correct it.", values.size());
        return values;
    }

    [[nodiscard]] NumberType type_of(pugi::xml_node array) const {
        const std::string_view name = array.attribute("type").value();
        const auto type = xml_type(name);
        if (!type)
            refuse(file_, "array '{}' is of type '{}', which is none of numbers. Correct it.",
                   excerpt(array.attribute("Name").value()), excerpt(name));
        return *type;
    }

    [[nodiscard]] std::vector<std::int64_t> wholes(pugi::xml_node array, std::uint64_t size) const {
        const NumberType type = type_of(array);
        return with_values(array, [&](MeshInput& input) { return input.wholes(type, size, 1); });
    }

    /// @return how many there are
    std::uint64_t read_points(pugi::xml_node piece) {
        const std::uint64_t points = count(piece, "NumberOfPoints");
        if (points == 0) return 0;
        const pugi::xml_node array = piece.child("Points").child("DataArray");
        if (!array) refuse(file_, "a piece without its array of points. Write it again.");
        if (array.attribute("NumberOfComponents").as_int(3) != 3)
            refuse(file_, "points of {} coordinates (three are read). Write it again.",
                   array.attribute("NumberOfComponents").as_int());
        const NumberType type = type_of(array);
        const auto values = with_values(array, [&](MeshInput& input) { return input.reals(type, points, 3); });
        for (std::size_t i = 0; i < values.size(); i += 3) mesh_.add_point({values[i], values[i + 1], values[i + 2]});
        return points;
    }

    /// Cells without types.
    [[nodiscard]] VtkCells read_cells(pugi::xml_node cells, std::uint64_t number) const {
        if (number == 0) return {};
        auto ends = wholes(array_of(cells, "offsets"), number);
        const std::int64_t size = ends.back();
        if (size < 0) refuse(file_, "array 'offsets' ends with {}. Correct it.", size);
        return {wholes(array_of(cells, "connectivity"), static_cast<std::uint64_t>(size)), std::move(ends), {}};
    }

    [[nodiscard]] VtkArrays read_arrays(pugi::xml_node piece, std::uint64_t cells) const {
        VtkArrays arrays;
        for (const pugi::xml_node array : piece.child("CellData").children()) {
            const std::string name = array.attribute("Name").value();
            const std::string_view type = array.attribute("type").value();
            const std::uint64_t components = array.attribute("NumberOfComponents").as_uint(1);
            if (type == "String" && components == 1)
                arrays.usable.push_back({name, {}, texts(array, cells)});
            else
                arrays.add(name, xml_type(type), components, [&] { return wholes(array, cells); });
        }
        return arrays;
    }

    /// Texts of an array, each of which ends with a byte of 0. Where a file has text instead of bytes, it has the
    /// numbers of these bytes.
    [[nodiscard]] std::vector<std::string> texts(pugi::xml_node array, std::uint64_t number) const {
        return with_values(array, [&](MeshInput& input) {
            input.expect_room(number, 1, 1);
            std::vector<std::string> all;
            while (all.size() < number) {
                std::string text;
                while (const std::int64_t byte = input.whole({NumberType::Kind::natural, 1})) {
                    if (byte > 255) input.fail("{} is no byte of a text. Correct it.", byte);
                    text += static_cast<char>(byte);
                }
                all.push_back(std::move(text));
            }
            return all;
        });
    }

    [[nodiscard]] VtkCells read_grid(pugi::xml_node piece) const {
        const std::uint64_t number = count(piece, "NumberOfCells");
        if (number == 0) return {};
        VtkCells cells = read_cells(piece.child("Cells"), number);
        cells.types = wholes(array_of(piece.child("Cells"), "types"), number);
        return cells;
    }

    [[nodiscard]] VtkCells read_poly_data(pugi::xml_node piece) const {
        VtkCells cells;
        for (const VtkSection& section : vtk_sections) {
            const std::string name(section.xml);
            cells.append(read_cells(piece.child(name.c_str()), count(piece, "NumberOf" + name)), section.type);
        }
        return cells;
    }

    void read_piece(pugi::xml_node node, bool is_grid) {
        VtkPiece piece;
        piece.first_point = mesh_.point_count();
        piece.points = read_points(node);
        piece.cells = is_grid ? read_grid(node) : read_poly_data(node);
        const std::uint64_t number = piece.cells.ends.size();
        if (number == 0) return;
        piece.arrays = read_arrays(node, number);
        pieces_.push_back(std::move(piece));
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
