#include "tests/unit/studies/scene_files/sample_room.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {
namespace {

std::vector<int> types_of_grid() {
    return {3, 9, 9, 9, 9, 9, 9, 12};
}

std::vector<int> ends_of(const std::vector<Cell>& cells) {
    std::vector<int> ends;
    int end = 0;
    for (const Cell& cell : cells) ends.push_back(end += static_cast<int>(cell.size()));
    return ends;
}

std::vector<int> joined(const std::vector<Cell>& cells) {
    std::vector<int> all;
    for (const Cell& cell : cells) all.insert(all.end(), cell.begin(), cell.end());
    return all;
}

void put_legacy_cells(Numbers& out, std::string_view keyword, const std::vector<Cell>& cells, LegacyCells form) {
    const std::vector<int> points = joined(cells);
    if (form == LegacyCells::counted) {
        out.bytes += fmt::format("\n{} {} {}\n", keyword, cells.size(), points.size() + cells.size());
        for (const Cell& cell : cells) {
            out.put(static_cast<std::int32_t>(cell.size()));
            out.put_all<std::int32_t>(cell);
        }
        return;
    }
    out.bytes += fmt::format("\n{} {} {}\nOFFSETS vtktypeint64\n", keyword, cells.size() + 1, points.size());
    out.put(std::int64_t{0});
    out.put_all<std::int64_t>(ends_of(cells));
    out.bytes += "\nCONNECTIVITY vtktypeint64\n";
    out.put_all<std::int64_t>(points);
}

}  // namespace

std::string legacy_file(Encoding encoding, bool is_grid, LegacyCells form) {
    Numbers out{encoding, {}};
    out.bytes =
        fmt::format("# vtk DataFile Version {}\na room\n{}\nDATASET {}\nPOINTS 8 double\n",
                    form == LegacyCells::offset ? "5.1" : "3.0", encoding == Encoding::text ? "ASCII" : "BINARY",
                    is_grid ? "UNSTRUCTURED_GRID" : "POLYDATA");
    out.put_points();
    if (is_grid) {
        put_legacy_cells(out, "CELLS", cells_of(true), form);
        out.bytes += "\nCELL_TYPES 8\n";
        out.put_all<std::int32_t>(types_of_grid());
    } else {
        put_legacy_cells(out, "POLYGONS", room_walls, form);
        put_legacy_cells(out, "LINES", {room_line}, form);
    }
    out.bytes += "\nPOINT_DATA 8\nSCALARS number int 1\nLOOKUP_TABLE default\n";
    out.put_all<std::int32_t>(room_volume);
    out.bytes += fmt::format("\nMETADATA\nINFORMATION 0\n\nCELL_DATA {}\nFIELD FieldData 2\nheat 1 {} float\n",
                             cells_of(is_grid).size(), cells_of(is_grid).size());
    out.put_all<float>(groups_of(is_grid));
    out.bytes += fmt::format("\npart 1 {} short\n", cells_of(is_grid).size());
    out.put_all<std::int16_t>(groups_of(is_grid));
    out.bytes += "\n";
    return out.bytes;
}

namespace {

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

/// Writes arrays where the form has them.
class XmlArrays {
  public:
    explicit XmlArrays(const XmlForm& form) : form_(form) {}

    /// @param write  puts numbers into Numbers
    template <class Write>
    std::string array(std::string_view name, std::string_view type, Write write) {
        Numbers numbers{form_.format == "ascii" ? Encoding::text : form_.encoding, {}};
        write(numbers);
        const bool is_appended = form_.format == "appended";
        const std::string start = fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="{}")",
                                              type, name, name == "Points" ? 3 : 1, form_.format);
        if (form_.format == "ascii") return start + ">\n" + numbers.bytes + "</DataArray>\n";
        const std::string packed = pack(numbers.bytes, !is_appended || form_.appended_as == "base64");
        if (!is_appended) return start + ">\n  " + packed + "\n</DataArray>\n";
        const std::size_t offset = appended_.size();
        appended_ += packed;
        return start + fmt::format(R"( offset="{}"/>)", offset);
    }

    [[nodiscard]] const std::string& appended() const { return appended_; }

  private:
    const XmlForm& form_;
    std::string appended_;

    void put_header(Numbers& out, std::size_t number) const {
        if (form_.has_long_headers)
            out.put(std::uint64_t{number});
        else
            out.put(static_cast<std::uint32_t>(number));
    }

    /// In base64 the header of compressed blocks stands for itself, as VTK writes it.
    [[nodiscard]] std::string pack(const std::string& bytes, bool is_base64) const {
        Numbers header{form_.encoding, {}};
        if (!form_.is_compressed) {
            put_header(header, bytes.size());
            return is_base64 ? base64(header.bytes + bytes) : header.bytes + bytes;
        }
        constexpr std::size_t block = 64;
        std::vector<std::string> blocks;
        for (std::size_t at = 0; at < bytes.size(); at += block) {
            const std::string part = bytes.substr(at, block);
            uLongf length = compressBound(part.size());
            std::string packed(length, '\0');
            compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(part.data()),
                     part.size());
            blocks.push_back(packed.substr(0, length));
        }
        put_header(header, blocks.size());
        put_header(header, block);
        put_header(header, bytes.size() % block);
        std::string all;
        for (const std::string& packed : blocks) {
            put_header(header, packed.size());
            all += packed;
        }
        return is_base64 ? base64(header.bytes) + base64(all) : header.bytes + all;
    }
};

std::string xml_cells(XmlArrays& arrays, const std::vector<Cell>& cells) {
    return arrays.array("connectivity", "Int64", [&](Numbers& out) { out.put_all<std::int64_t>(joined(cells)); }) +
           arrays.array("offsets", "Int32", [&](Numbers& out) { out.put_all<std::int32_t>(ends_of(cells)); });
}

}  // namespace

std::string xml_file(const XmlForm& form) {
    XmlArrays arrays(form);
    const std::string_view kind = form.is_grid ? "UnstructuredGrid" : "PolyData";
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"{}\" header_type=\"{}\"{}>\n<{}>\n",
        kind, form.encoding == Encoding::big_endian ? "BigEndian" : "LittleEndian",
        form.has_long_headers ? "UInt64" : "UInt32", form.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "",
        kind);
    text += form.is_grid ? "<Piece NumberOfPoints=\"8\" NumberOfCells=\"8\">\n"
                         : "<Piece NumberOfPoints=\"8\" NumberOfLines=\"1\" NumberOfPolys=\"6\">\n";
    text += "<CellData>\n" +
            arrays.array("heat", "Float32", [&](Numbers& out) { out.put_all<float>(groups_of(form.is_grid)); }) +
            arrays.array("part", "Int32", [&](Numbers& out) { out.put_all<std::int32_t>(groups_of(form.is_grid)); }) +
            "</CellData>\n<Points>\n" + arrays.array("Points", "Float64", [](Numbers& out) { out.put_points(); }) +
            "</Points>\n";
    if (form.is_grid) {
        text += "<Cells>\n" + xml_cells(arrays, cells_of(true)) + arrays.array("types", "UInt8", [](Numbers& out) {
            for (const int type : types_of_grid()) {
                if (out.encoding == Encoding::text)
                    out.put(type);
                else
                    out.put(static_cast<std::uint8_t>(type));
            }
        }) + "</Cells>\n";
    } else {
        text += "<Lines>\n" + xml_cells(arrays, {room_line}) + "</Lines>\n<Polys>\n" + xml_cells(arrays, room_walls) +
                "</Polys>\n";
    }
    text += fmt::format("</Piece>\n</{}>\n", kind);
    if (!arrays.appended().empty())
        text +=
            fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n", form.appended_as, arrays.appended());
    return text + "</VTKFile>\n";
}

}  // namespace ff::studies::meshes
