#include "tests/unit/studies/scene_files/mesh_samples.hpp"

#include "tests/unit/studies/scene_files/sample_room.hpp"

#include <string>
#include <vector>

namespace ff::studies::meshes {

std::vector<MeshSample> mesh_samples() {
    const std::vector<std::string> parts{"part_1", "part_2", "part_3"};
    std::vector<MeshSample> samples;
    for (const Encoding encoding : {Encoding::text, Encoding::big_endian}) {
        for (const bool is_grid : {false, true}) {
            for (const LegacyCells form : {LegacyCells::counted, LegacyCells::offset})
                samples.push_back({"room.vtk", legacy_file(encoding, is_grid, form), parts});
        }
    }
    for (const bool is_grid : {false, true}) {
        const std::string name = is_grid ? "room.vtu" : "room.vtp";
        samples.push_back({name, xml_file({.is_grid = is_grid}), parts});
        for (const bool is_compressed : {false, true}) {
            for (const Encoding encoding : {Encoding::little_endian, Encoding::big_endian}) {
                XmlForm form{"binary", "raw", encoding, encoding == Encoding::big_endian, is_compressed, is_grid};
                samples.push_back({name, xml_file(form), parts});
                form.format = "appended";
                samples.push_back({name, xml_file(form), parts});
                form.appended_as = "base64";
                samples.push_back({name, xml_file(form), parts});
            }
        }
    }
    const std::vector<std::string> surfaces{"floor_plate", "physical_2", "surface_3"};
    for (const Encoding encoding : {Encoding::text, Encoding::little_endian, Encoding::big_endian}) {
        samples.push_back({"room.msh", gmsh2_file(encoding), surfaces});
        samples.push_back({"room.msh", gmsh4_file(encoding, "4"), surfaces});
        samples.push_back({"room.msh", gmsh4_file(encoding, "4.1"), surfaces});
    }
    samples.push_back({"room.stl", stl_file(Encoding::text), {"floor_plate", "_2_two", "mesh"}});
    const std::vector<std::string> none{"mesh"};
    samples.push_back({"room.stl", stl_file(Encoding::little_endian), none});
    for (const Encoding encoding : {Encoding::text, Encoding::little_endian, Encoding::big_endian}) {
        for (const PlyPolygons polygons : {PlyPolygons::after_points, PlyPolygons::before_points, PlyPolygons::strips})
            samples.push_back({"room.ply", ply_file(encoding, polygons), none});
    }
    samples.push_back({"room.off", off_file("OFF\n", ""), none});
    samples.push_back({"room.off", off_file("OFF ", " # a point"), none});
    samples.push_back({"room.off", off_file("STCNOFF\n# no comment\n", " 0 0 1 255 0 0 255 0.5 0.5"), none});
    return samples;
}

}  // namespace ff::studies::meshes
