// Which groups become faces where a mesh of gmsh or VTK has several ways to group its cells, and which notes report
// that.
#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace ff::studies::meshes {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene scene_of(const std::string& name, const SurfaceMesh& mesh) {
    return make_scene(source_of_file(name, mesh.as_obj()));
}

Scene gmsh_scene(const std::string& text) {
    return scene_of("a.msh", read_gmsh("a.msh", text));
}

Scene vtk_scene(const std::string& text) {
    return scene_of("a.vtk", read_vtk_legacy("a.vtk", text));
}

Scene xml_scene(const std::string& text) {
    return scene_of("a.vtu", read_vtk_xml("a.vtu", text));
}

const std::string group_names = "$PhysicalNames\n3\n2 9 \"all\"\n2 5 \"floor\"\n2 7 \"roof\"\n$EndPhysicalNames\n";

/// A floor of two triangles and a roof of one. @param elements  lines of the section
std::string gmsh_2(const std::string& elements) {
    return fmt::format(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n{}$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n"
        "7 0 1 1\n$EndNodes\n$Elements\n{}\n{}$EndElements\n",
        group_names, std::count(elements.begin(), elements.end(), '\n'), elements);
}

/// @param floor, roof  number of their physical surfaces, and these
std::string gmsh_4(const std::string& floor, const std::string& roof) {
    return fmt::format(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{}$Entities\n0 0 2 0\n1 0 0 0 1 1 0 {} 0\n2 0 0 1 1 1 1 {} 0\n"
        "$EndEntities\n$Nodes\n1 7 1 7\n2 1 0 7\n1\n2\n3\n4\n5\n6\n7\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n"
        "$EndNodes\n$Elements\n2 3 1 3\n2 1 2 2\n1 1 2 3\n2 1 3 4\n2 2 2 1\n3 5 7 6\n$EndElements\n",
        group_names, floor, roof);
}

TEST(GmshFaces, AreTheSmallestOfSeveralPhysicalSurfacesInBothVersions) {
    const std::string note =
        "3 elements are in several physical surfaces, and belong to the one with the fewest elements, not to 'all'";
    const std::string listed = gmsh_4("2 9 5", "2 9 7");
    const std::string repeated = gmsh_2(
        "1 2 2 9 1 1 2 3\n2 2 2 9 1 1 3 4\n3 2 2 9 2 5 7 6\n1 2 2 5 1 1 2 3\n2 2 2 5 1 1 3 4\n3 2 2 7 2 5 7 6\n");
    for (const std::string& text : {listed, repeated}) {
        const Scene scene = gmsh_scene(text);
        EXPECT_THAT(scene.faces, ElementsAre("floor", "roof"));
        EXPECT_EQ(scene.surfaces.size(), 3);
        EXPECT_THAT(scene.remarks, ElementsAre(note));
    }
}

TEST(GmshFaces, HaveTheSmallerTagWherePhysicalSurfacesAreEquallyLarge) {
    EXPECT_THAT(gmsh_scene(gmsh_4("2 7 5", "0")).faces, ElementsAre("floor", "surface_2"));
}

TEST(GmshFaces, AreBothSidesOfAPlatePhysicalInEitherDirection) {
    const std::string repeated = gmsh_2("1 2 2 5 1 1 2 3\n2 2 2 5 1 1 3 4\n3 2 2 7 1 3 2 1\n4 2 2 7 1 4 3 1\n");
    for (const std::string& text : {gmsh_4("2 5 -7", "0"), repeated}) {
        const Scene scene = gmsh_scene(text);
        EXPECT_THAT(scene.faces, testing::IsSupersetOf({"floor", "roof"}));
        EXPECT_THAT(scene.remarks, IsEmpty());
        for (const Surface& surface : scene.surfaces) {
            const std::string& face = scene.faces[static_cast<std::size_t>(surface.face)];
            EXPECT_NEAR(surface.normal.z(), face == "floor" ? 1 : -1, 1e-12) << face;
        }
    }
}

TEST(GmshFaces, StayApartWhereTheirNamesBecomeOneWord) {
    std::string text = gmsh_2("1 2 2 5 1 1 2 3\n2 2 2 7 1 5 7 6\n");
    text.replace(text.find("floor"), 5, "a  b").replace(text.find("roof"), 4, "a__b");
    EXPECT_THAT(gmsh_scene(text).faces, ElementsAre("a__b", "a__b.2"));
}

TEST(GmshFaces, AreReadAfterComments) {
    const std::string text = "$Comments\nby a pen\n$EndComments\n" + gmsh_2("1 2 2 5 1 1 2 3\n");
    const MeshKind* const kind = mesh_kind(text);
    ASSERT_NE(kind, nullptr);
    EXPECT_EQ(kind->extension, ".msh");
    EXPECT_THAT(gmsh_scene(text).faces, ElementsAre("floor"));
}

TEST(GmshFaces, HaveDuplicateElementsOnlyOnce) {
    const Scene scene = gmsh_scene(gmsh_2("1 2 2 5 1 1 2 3\n2 2 2 5 1 1 2 3\n"));
    EXPECT_THAT(scene.remarks,
                ElementsAre(HasSubstr("is a copy of another, not the other side of a sheet, and is left out")));
}

/// Two triangles and a line. @param arrays  of the three cells
std::string two_triangles(const std::string& arrays) {
    return "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\n"
           "CELLS 3 11\n3 0 1 2\n3 0 2 3\n2 0 1\nCELL_TYPES 3\n5 5 3\nCELL_DATA 3\n" +
           arrays;
}

TEST(VtkFaces, AreDistinguishedByTheFirstArrayThatDiffersBetweenPolygons) {
    const Scene scene = vtk_scene(two_triangles(
        "SCALARS mat int 1\nLOOKUP_TABLE default\n1 1 4\nSCALARS part int 1\nlookup_table default\n3 4 0\n"));
    EXPECT_THAT(scene.faces, ElementsAre("part_3", "part_4"));
    EXPECT_THAT(scene.remarks,
                ElementsAre("array 'part' tells its faces apart, as the first with several values; 'mat' is not used"));
}

TEST(VtkFaces, AreOneFaceWithANoteWhereNoArrayDistinguishesThem) {
    const Scene fractions = vtk_scene(two_triangles("SCALARS part double 1\nlookup_table default\n0 1 2\n"));
    EXPECT_THAT(fractions.faces, ElementsAre("mesh"));
    EXPECT_THAT(fractions.remarks,
                ElementsAre("no array of whole numbers or texts tells its faces apart; 'part' is not used"));
    const Scene constant = vtk_scene(two_triangles("SCALARS mat int 1\nLOOKUP_TABLE default\n1 1 4\n"));
    EXPECT_THAT(constant.faces, ElementsAre("mat_1"));
    EXPECT_THAT(constant.remarks, IsEmpty());
}

TEST(VtkFaces, LeaveOutHiddenAndDuplicateCells) {
    const Scene scene =
        vtk_scene(two_triangles("SCALARS vtkGhostType unsigned_char 1\nLOOKUP_TABLE default\n32 0 0\n"
                                "SCALARS part int 1\nLOOKUP_TABLE default\n3 4 4\n"));
    EXPECT_THAT(scene.faces, ElementsAre("part_4"));
    EXPECT_THAT(scene.remarks, ElementsAre("1 cell is hidden or a duplicate by vtkGhostType, and is left out"));
}

/// A triangle with arrays of cells.
std::string piece(double height, const std::string& arrays) {
    return fmt::format(
        "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><CellData>{}</CellData><Points><DataArray type=\"Float64\" "
        "NumberOfComponents=\"3\">0 0 {} 1 0 {} 1 1 {}</DataArray></Points><Cells><DataArray type=\"Int32\" "
        "Name=\"connectivity\">0 1 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\">3</DataArray><DataArray "
        "type=\"UInt8\" Name=\"types\">5</DataArray></Cells></Piece>",
        arrays, height, height, height);
}

std::string grid_of(const std::string& pieces) {
    return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>" + pieces + "</UnstructuredGrid></VTKFile>";
}

std::string cell_array(const std::string& name, int value, const std::string& type = "Int32") {
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\">{}</DataArray>", type, name, value);
}

TEST(VtkFaces, AreDistinguishedByAnArrayThatAllPiecesHave) {
    const Scene scene =
        xml_scene(grid_of(piece(0, cell_array("own", 1) + cell_array("mat", 7) + cell_array("part", 0)) +
                          piece(1, cell_array("part", 1) + cell_array("mat", 7) + cell_array("other", 2))));
    EXPECT_THAT(scene.faces, ElementsAre("part_0", "part_1"));
    EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("array 'part' tells its faces apart")));
}

TEST(VtkFaces, AreNamedByTextsInXml) {
    const auto named = [](const std::string& bytes) {
        return "<Array type=\"String\" Name=\"wall\" format=\"ascii\">" + bytes + "</Array>";
    };
    const std::string floor = named("102 108 111 111 114 0");
    const Scene scene = xml_scene(grid_of(piece(0, floor) + piece(1, named("116 111 112 0"))));
    EXPECT_THAT(scene.faces, ElementsAre("floor", "top"));
    EXPECT_THAT(scene.remarks, ElementsAre("array 'wall' tells its faces apart"));
    EXPECT_THAT(xml_scene(grid_of(piece(0, named("97 32 98 0")) + piece(1, named("97 95 98 0")))).faces,
                ElementsAre("a_b", "a_b.2"));
    EXPECT_THAT(xml_scene(grid_of(piece(0, floor) + piece(1, floor))).faces, ElementsAre("floor"));
    for (const std::string bytes : {"102 108", "102 0 103 0", "102 x 0"})
        EXPECT_THROW(xml_scene(grid_of(piece(0, floor) + piece(1, named(bytes)))), UserError) << bytes;
}

TEST(VtkFaces, LeaveOutDuplicateCellsInXml) {
    const Scene scene = xml_scene(grid_of(piece(0, cell_array("vtkGhostType", 1, "UInt8") + cell_array("part", 1)) +
                                          piece(1, cell_array("vtkGhostType", 0, "UInt8") + cell_array("part", 2))));
    EXPECT_THAT(scene.faces, ElementsAre("part_2"));
    EXPECT_THAT(scene.remarks, ElementsAre(HasSubstr("1 cell is hidden or a duplicate")));
}

}  // namespace
}  // namespace ff::studies::meshes
