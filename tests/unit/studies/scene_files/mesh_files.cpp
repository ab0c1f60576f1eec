// Meshes in the formats that the project reads itself, sound and broken.
#include "core/geometry/surface_map.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "tests/support/studies.hpp"
#include "tests/unit/studies/scene_files/mesh_samples.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::meshes {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Reads a mesh by its content. @throws UserError where the project cannot read it
std::string as_obj(const std::string& name, std::string_view bytes) {
    const MeshKind* const kind = mesh_kind(bytes);
    if (kind == nullptr || kind->read == nullptr) throw UserError("no such mesh");
    return kind->read(name, bytes).as_obj();
}

Scene read_mesh(const std::string& name, std::string_view bytes) {
    return make_scene(source_of_file(name, as_obj(name, bytes)));
}

/// The fault of the file; "" where it has none.
std::string fault_of(const std::string& name, std::string_view bytes) {
    try {
        static_cast<void>(read_mesh(name, bytes));
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

std::string changed(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// The sample with that name that contains a text, or the first one with that name.
std::string sample(std::string_view name, std::string_view part = "") {
    for (const MeshSample& sample : mesh_samples()) {
        if (sample.name == name && sample.bytes.find(part) != std::string::npos) return sample.bytes;
    }
    ADD_FAILURE() << name << " " << part;
    return "";
}

TEST(MeshFiles, AreTheSameRoomInEveryForm) {
    const std::vector<MeshSample> samples = mesh_samples();
    for (const MeshSample& sample : samples) {
        SCOPED_TRACE(sample.name + ": " + sample.bytes.substr(0, 150));
        const Scene scene = read_mesh(sample.name, sample.bytes);
        EXPECT_EQ(scene.faces, sample.faces);
        EXPECT_THAT(scene.surfaces.size(), AnyOf(6, 12));  // walls, or two triangles of each
        std::vector<double> areas;
        for (int face = 0; face < static_cast<int>(scene.faces.size()); ++face) areas.push_back(face_area(scene, face));
        EXPECT_THAT(areas, AnyOf(ElementsAre(24, 16, 12), ElementsAre(52)));
        EXPECT_THAT(scene.remarks, testing::IsSubsetOf({"1 volume cell is left out (surfaces alone exchange radiation)",
                                                        "array 'part' tells its faces apart"}));
        const std::size_t sees_itself = scene.faces.size() == 1 ? 1 : 0;
        EXPECT_THAT(doubts_about(scene), testing::SizeIs(scene.remarks.size() + sees_itself));
    }
}

TEST(MeshFiles, KeepDoublePrecision) {
    const std::string text = changed(sample("room.vtk"), "4 0 0", "3.9999999999999996 0 0");
    EXPECT_THAT(as_obj("a.vtk", text), HasSubstr("v 3.9999999999999996 0 0\n"));
}

TEST(MeshFiles, AreOneFaceWithoutGroups) {
    const Scene scene = read_mesh("a.vtk",
                                  "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n"
                                  "0 0 0 1 0 0 0 1 0 1 1 0 2 0 0\nCELLS 3 16\n6 0 1 2 4 4 4 3 0 1 3\n4 0 1 2 3\n\n"
                                  "CELL_TYPES 3\n22 5 8\n");
    EXPECT_THAT(scene.faces, ElementsAre("mesh"));
}

TEST(VtkCells, AreTakenByTheirCorners) {
    const std::string start =
        "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
        "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0 0 3 0 1 3 0\n";
    const auto text_of = [&](const std::string& cells) {
        std::string text = as_obj("a.vtk", start + cells);
        return text.substr(text.find('f'));
    };
    EXPECT_THAT(text_of("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n"), HasSubstr("f 1 2 3 4\n"));  // a pixel
    EXPECT_THAT(text_of("CELLS 1 7\n6 0 1 3 4 5 6\nCELL_TYPES 1\n22\n"), HasSubstr("f 1 2 3\n"));
    EXPECT_THAT(text_of("CELLS 1 9\n8 0 1 3 2 4 5 6 7\nCELL_TYPES 1\n36\n"), HasSubstr("f 1 2 3 4\n"));
    EXPECT_NEAR(face_area(read_mesh("a.vtk", start + "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n6\n"), 0), 3, 1e-12);
    const Scene strip = read_mesh("a.vtk", start + "CELLS 1 9\n8 0 1 2 3 4 5 6 7\nCELL_TYPES 1\n6\n");
    EXPECT_THAT(strip.remarks, IsEmpty());  // all triangles face the same way
}

TEST(MeshFiles, AreRefusedWithoutSurfacesWithAdviceToExtractThem) {
    EXPECT_THAT(fault_of("a.vtk",
                         "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                         "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"),
                HasSubstr("a.vtk: volume cells alone, 1 of them (only surfaces exchange radiation). Extract the"));
}

TEST(GmshFiles, ReverseSurfacesWithANegativePhysicalTag) {
    const std::string text = sample("room.msh", "\n4.1 0");
    const std::string backwards = changed(text, "0 0 0 0 0 0 1 2 0 ", "0 0 0 0 0 0 1 -2 0 ");
    EXPECT_THAT(as_obj("a.msh", text), HasSubstr("g physical_2\nf 1 5 8 2\n"));
    EXPECT_THAT(as_obj("a.msh", backwards), HasSubstr("g physical_2\nf 2 8 5 1\n"));
}

struct Fault {
    std::string_view name;
    std::string_view part;  ///< part of the sample that is changed
    std::string_view from;
    std::string_view to;
    std::string_view message;
};

TEST(BrokenMeshFiles, AreRefusedWithTheReason) {
    const std::vector<Fault> faults{
        {"room.vtk", "ASCII", "POINTS 8", "POINTS 1000000000000000000", "room.vtk:6: POINTS: 1000000000000000000 x 3"},
        {"room.vtk", "ASCII", "POINTS 8", "POINTS -8", "room.vtk:5: POINTS: '-8' is no number of things"},
        {"room.vtk", "BINARY", "POINTS 8", "POINTS 6148914691236517206", "6148914691236517206 x 3 numbers"},
        {"room.vtk", "ASCII", "POINTS 8 double", "POINTS 8 string", "numbers of type 'string' are not read"},
        {"room.vtk", "ASCII", "0 1 2 3", "0 1 2 8", "room.vtk: cell 1 has point 8, of 8 that count from 0"},
        {"room.vtk", "ASCII", "0 1 2 3", "0 1 -2 3", "room.vtk: cell 1 has point -2, of 8"},
        {"room.vtk", "ASCII", "4 0 1 2 3", "40 0 1 2 3", "cell 0 has 40 points, and 29 numbers follow"},
        {"room.vtk", "ASCII", "4 0 0", "nan 0 0", "room.vtk: cell 1 has a point at (nan, 0, 0), which is no place"},
        {"room.vtk", "ASCII", "4 0 0", "x 0 0", "room.vtk:6: POINTS: 'x' is not a number"},
        {"room.vtk", "ASCII\nDATASET UNS", "3 9 9", "3 9 99", "cell 2 is of type 99, which is not known"},
        {"room.vtk", "ASCII\nDATASET UNS", "\nCELL_TYPES 8\n3 9", "\nCELL_TYPES 7\n9", "8 cells have 7 types"},
        {"room.vtk", "OFFSETS", "0 4 8", "0 4 -8", "cell 2 ends at point"},
        {"room.vtk", "ASCII", "POLYDATA", "STRUCTURED_GRID", "'STRUCTURED_GRID' is not read"},
        {"room.vtk", "ASCII", "POLYGONS", "POLYGNS", "room.vtk:7: POLYGNS: no keyword of this format"},
        {"room.vtk", "ASCII", "ASCII", "TEXT", "the third line is 'TEXT'"},
        {"room.vtu", "ascii", "NumberOfPoints=\"8\"", "NumberOfPoints=\"18446744073709551615\"",
         "room.vtu: array 'Points': 18446744073709551615 x 3 numbers are announced"},
        {"room.vtu", "ascii", "NumberOfCells=\"8\"", "NumberOfCells=\"-8\"", "NumberOfCells is '-8'"},
        {"room.vtu", "ascii", "NumberOfCells=\"8\"", "NumberOfCells=\"7\"", "it has more than the 7 values"},
        {"room.vtu", "ascii", "</Cells>", "</Cell>", "room.vtu:22: no sound XML"},
        {"room.vtu", "ascii", "Name=\"types\"", "Name=\"kinds\"", "array 'types' is missing"},
        {"room.vtu", "ascii", "type=\"Float64\"", "type=\"Float80\"", "array 'Points' is of type 'Float80'"},
        {"room.vtu", "ascii", "type=\"UnstructuredGrid\"", "type=\"ImageData\"", "a file of type 'ImageData'"},
        {"room.vtu", "ascii", "\n3 9 9", "\n3 9 99", "room.vtu: cell 2 is of type 99"},
        {"room.vtu", "raw", R"(="3" format="appended" offset=")", R"(="3" format="appended" offset="99999)",
         "is at offset 99999"},
        {"room.vtu", "vtkZLib", "vtkZLib", "vtkLZ4", "compressor 'vtkLZ4DataCompressor'"},
        {"room.vtu", "binary", "=\"3\" format=\"binary\">\n  ", "=\"3\" format=\"binary\">\n  ////",
         "array 'Points': 3238002687 bytes are announced"},
        {"room.msh", "\n2.2 0", "$Nodes\n8", "$Nodes\n9", "room.msh:13: $Nodes: $EndNodes comes before all that"},
        {"room.msh", "\n2.2 0", "$Nodes\n8", "$Nodes\n7", "$Nodes: '17' stands where $EndNodes is expected"},
        {"room.msh", "\n2.2 0", "2 3 2 1 1 10", "2 3 2 1 1 99", "element 2 has node 99, which is not in $Nodes"},
        {"room.msh", "\n2.2 0", "2 3 2 1 1 10", "2 140 2 1 1 10", "elements of type 140 are not known"},
        {"room.msh", "\n2.2 0", "2.2 0", "3.0 0", "version '3.0' (2, 4.0 and 4.1 are read)"},
        {"room.msh", "\n4.1 0", "$Nodes\n1 8", "$Nodes\n-1 8", "room.msh:14: $Nodes: '-1' is no number of things"},
        {"room.msh", "\n4.1 0", "1 8 10 11", "1 1000000000000000000 10 11",
         "1000000000000000000 numbers are announced"},
        {"room.msh", "\n4.1 0", "$EndElements", "$EndElement", "stands where $EndElements is expected"},
        {"room.msh", "\n4 0", "$Entities", "$PartitionedEntities", "a mesh in partitions is not read"},
    };
    for (const Fault& fault : faults)
        EXPECT_THAT(fault_of(std::string(fault.name), changed(sample(fault.name, fault.part), fault.from, fault.to)),
                    HasSubstr(fault.message));
}

/// Any bytes have to give a mesh or a UserError: anything else fails the test, or ends it.
void look_at(const std::string& name, std::string_view bytes) {
    try {
        static_cast<void>(as_obj(name, bytes));
    } catch (const UserError&) {
    }
}

TEST(BrokenMeshFiles, MayEndAnywhere) {
    for (const MeshSample& sample : mesh_samples()) {
        for (std::size_t size = 0; size < sample.bytes.size(); ++size)
            look_at(sample.name, std::string_view(sample.bytes).substr(0, size));
        EXPECT_THAT(fault_of(sample.name, std::string_view(sample.bytes).substr(0, 2 * sample.bytes.size() / 3)),
                    StartsWith(sample.name));
    }
}

TEST(BrokenMeshFiles, MayHaveAnyBytes) {
    std::mt19937_64 random(20261127);
    for (const MeshSample& sample : mesh_samples()) {
        for (int i = 0; i < 500; ++i) {
            std::string bytes = sample.bytes;
            for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips)
                bytes[random() % bytes.size()] = static_cast<char>(random());
            look_at(sample.name, bytes);
        }
    }
}

// As pyVista writes texts: in binary each has its length before it.
TEST(MeshFiles, HaveGroupsByTextInVtk) {
    const std::string head = "# vtk DataFile Version 5.1\nx\n";
    const auto texts_of = [&](const std::string& file) {
        const test::TemporaryFolder folder;
        const auto path = folder.path() / "a.vtk";
        std::ofstream(path, std::ios::binary) << file;
        return read_scene_file(path);
    };
    const std::string text = head +
                             "ASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 1 1 0\nPOLYGONS 2 8\n3 0 1 2\n"
                             "3 0 2 1\nCELL_DATA 2\nFIELD FieldData 2\nwall_names 1 2 string\nbig%20house\nsky\n"
                             "part 1 2 int\n1 2\n";
    EXPECT_THAT(texts_of(text), AllOf(HasSubstr("g big_house\n"), HasSubstr("g sky\n")));
    EXPECT_THROW(texts_of(text.substr(0, text.find("sky"))), UserError) << "cut off before a text";
    const auto binary = [](std::initializer_list<int> bytes) { return std::string(bytes.begin(), bytes.end()); };
    const std::string long_name(100, 'x');  // whose length takes two bytes
    const std::string start = head + "BINARY\nDATASET POLYDATA\nPOINTS 3 float\n" + std::string(12, '\0') +
                              binary({0x3f, 0x80, 0, 0}) + std::string(8, '\0') + binary({0x3f, 0x80, 0, 0}) +
                              binary({0x3f, 0x80, 0, 0}) + std::string(4, '\0') + "\nPOLYGONS 2 8\n" +
                              binary({0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2}) +
                              binary({0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 1}) +
                              "\nCELL_DATA 2\nFIELD FieldData 1\nwall_names 1 2 string\n" + binary({0xc0 | 3}) + "sky";
    EXPECT_THAT(texts_of(start + binary({0x80, 100}) + long_name + "\n"),
                AllOf(HasSubstr("g sky\n"), HasSubstr("g " + long_name + "\n")));
    EXPECT_THROW(texts_of(start + binary({0x80, 100}) + "cut off"), UserError);
    EXPECT_THROW(texts_of(start + std::string(1, '\0') + binary({0x7f, 0x7f, 0x7f, 0x7f, 0x7f, 0x7f, 0x7f})),
                 UserError);
}

TEST(MeshFiles, AreRecognisedByTheirContent) {
    const test::TemporaryFolder folder;
    const auto write = [&](const std::string& name, const std::string& bytes) {
        std::ofstream(folder.path() / name, std::ios::binary) << bytes;
        return folder.path() / name;
    };
    // A mesh is read even with the extension of another mesh format, but not as a file of another kind.
    EXPECT_THAT(read_scene_file(write("a.msh", sample("room.vtu"))), HasSubstr("g part_1"));
    const auto fault = [](const std::filesystem::path& file) -> std::string {
        try {
            return read_scene_file(file);
        } catch (const UserError& error) {
            return error.what();
        }
    };
    std::string triangle(84 + 50, '\0');
    triangle[80] = 1;
    EXPECT_THAT(fault(write("b.obj", triangle)),
                HasSubstr("an STL file by its content (its name says that it is something else). Rename it to "
                          "end in .stl."));
    EXPECT_THAT(fault(write("c.toml", sample("room.msh"))), HasSubstr("a mesh of gmsh by its content"));
    EXPECT_THAT(fault(write("d.msh", "(0 \"Fluent\")\n")), HasSubstr("no mesh of gmsh from version 2 on"));
}

}  // namespace
}  // namespace ff::studies::meshes
