// STL, PLY and OFF, whose files have few marks by which a reader would notice that they were cut off; and the checks of
// glTF before a library reads it.
#include "core/support/error.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "tests/unit/studies/scene_files/mesh_samples.hpp"
#include "tests/unit/studies/scene_files/sample_room.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace ff::studies::meshes {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

template <class Read>
std::string fault_in(Read read) {
    try {
        static_cast<void>(read());
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

std::string plain_fault(const std::string& name, std::string_view bytes) {
    if (name.ends_with(".stl")) return fault_in([&] { return read_stl(name, bytes).as_obj(); });
    if (name.ends_with(".ply")) return fault_in([&] { return read_ply(name, bytes).as_obj(); });
    return fault_in([&] { return read_off(name, bytes).as_obj(); });
}

std::string with_change(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// A text with a solid that ends is whole, whether or not more solids followed, or the name after `endsolid`.
bool may_be_whole(std::string_view name, std::string_view kept, std::string_view cut_off) {
    if (cut_off.find_first_not_of(" \t\r\n") == std::string_view::npos) return true;
    const std::size_t end = kept.rfind("endsolid");
    return name.ends_with(".stl") && end != std::string_view::npos && end > kept.rfind("endfacet");
}

TEST(PlainMeshFiles, AreRefusedWhereverTheyAreCutOff) {
    int samples = 0;
    for (const MeshSample& sample : mesh_samples()) {
        if (!sample.name.ends_with(".stl") && !sample.name.ends_with(".ply") && !sample.name.ends_with(".off"))
            continue;
        ++samples;
        const std::string_view whole = sample.bytes;
        EXPECT_EQ(plain_fault(sample.name, whole), "");
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const std::string fault = plain_fault(sample.name, whole.substr(0, size));
            if (fault.empty())
                EXPECT_TRUE(may_be_whole(sample.name, whole.substr(0, size), whole.substr(size)))
                    << sample.name << ", " << size << " bytes: ..." << whole.substr(size - 20, 20);
            else
                EXPECT_THAT(fault, StartsWith(sample.name));
        }
    }
    EXPECT_EQ(samples, 14);
}

TEST(PlainMeshFiles, MayHaveMoreBlanksButNothingElseAtTheEnd) {
    for (const MeshSample& sample : mesh_samples()) {
        if (!sample.name.ends_with(".ply") && !sample.name.ends_with(".off")) continue;
        EXPECT_EQ(plain_fault(sample.name, sample.bytes + "\r\n \n"), "");
        EXPECT_THAT(plain_fault(sample.name, sample.bytes + "\n3 0 1 2\n"), HasSubstr("follows"));
    }
    EXPECT_THAT(plain_fault("a.stl", stl_file(Encoding::text) + "more"), HasSubstr("'more' stands where 'solid'"));
    EXPECT_THAT(plain_fault("a.stl", stl_file(Encoding::little_endian) + "\n"),
                HasSubstr("a.stl, byte 84: 12 triangles are announced, which take 600 bytes, and 601 follow"));
}

TEST(PlainMeshFiles, KeepDoublePrecision) {
    const std::string number = "3.9999999999999996";
    const std::string place = "v " + number + " 0 0\n";
    EXPECT_THAT(
        read_stl("a.stl", with_change(stl_file(Encoding::text), "vertex 4 ", "vertex " + number + " ")).as_obj(),
        HasSubstr(place));
    EXPECT_THAT(read_off("a.off", with_change(off_file("OFF\n", ""), "4 0 0", number + " 0 0")).as_obj(),
                HasSubstr(place));
    const std::string ply = ply_file(Encoding::text, PlyPolygons::after_points);
    EXPECT_THAT(read_ply("a.ply", with_change(ply, "9 4 0", "9 " + number + " 0")).as_obj(), HasSubstr(place));
}

TEST(StlFiles, MayHaveKeywordsInCapitals) {
    const std::string text =
        "SOLID My Wall\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\n"
        "ENDSOLID";
    EXPECT_TRUE(is_stl(text));
    const std::string wall = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng My_Wall\nf 1 2 3\n";
    EXPECT_EQ(read_stl("a.stl", text).as_obj(), wall);
    std::string in_a_line = text;
    std::ranges::replace(in_a_line, '\n', ' ');
    EXPECT_EQ(read_stl("a.stl", in_a_line).as_obj(), wall);
}

TEST(PlyFiles, HaveStripsThatRestart) {
    EXPECT_THAT(read_ply("a.ply",
                         "ply\nformat ascii 1.0\nelement vertex 4\nproperty int x\nproperty int y\nproperty int z\n"
                         "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                         "0 0 0 1 0 0 0 1 0 1 1 0\n9 0 1 2 3 -1 3 2 1 0\n")
                    .as_obj(),
                HasSubstr("f 1 2 3\nv 1 1 0\nf 2 4 3\nf 4 3 2\nf 3 1 2\n"));
}

TEST(OffFiles, NeedNoKeyword) {
    EXPECT_EQ(plain_fault("a.off", off_file("", "")), "");
    EXPECT_EQ(plain_fault("a.off", off_file("# a room\nCOFF\n", " 1 0 0 1")), "");
}

TEST(PlainMeshFiles, AreRefusedWithTheReason) {
    const std::string stl = stl_file(Encoding::text);
    const std::string ply = ply_file(Encoding::text, PlyPolygons::after_points);
    const std::string binary_ply = ply_file(Encoding::big_endian, PlyPolygons::after_points);
    const std::string off = off_file("OFF\n", "");
    struct PlainFault {
        std::string_view name;
        std::string bytes;
        std::string_view message;
    };
    const std::vector<PlainFault> faults{
        {"a.stl", with_change(stl, "vertex 4 ", "vertex x "), "a.stl:5: solid floor plate: 'x' is not a number"},
        {"a.stl", with_change(stl, "vertex 4 ", "vertex 4,0 "), "'4,0' is not a number"},
        {"a.stl", with_change(stl, "vertex 4 ", "vertex inf "),
         "a.stl:5: solid floor plate: a coordinate is inf, which"},
        {"a.stl", with_change(stl, "  endloop", "  vertex 1 2 3"), "'vertex' stands where 'endloop' is expected"},
        {"a.stl", with_change(stl, "endsolid", "endsold"), "'endsold' stands where 'facet' is expected"},
        {"a.stl", "solid nothing\nendsolid", "a.stl: no polygon"},
        {"a.stl", "anything", "a.stl:1: no STL file"},
        {"a.stl", std::string(80, '\0') + "xxxx",
         "a.stl, byte 84: 2021161080 triangles are announced, which take 101058054000"},
        {"a.ply", with_change(ply, "vertex 8", "vertex 4000000000000000000"),
         "4000000000000000000 x 5 numbers are anno"},
        {"a.ply", with_change(ply, "face 7", "face 4000000000000000000"), "element face: 4000000000000000000 x 3"},
        {"a.ply", with_change(ply, "face 7", "face 8"), "a.ply:19: element face: it ends here"},
        {"a.ply", with_change(ply, "face 7", "face 6"), "more follows than its header announces"},
        {"a.ply", with_change(binary_ply, "face 7", "face 70000000"), "element face: 70000000 numbers are announced"},
        {"a.ply", with_change(ply, "face 7", "face -7"), "a.ply:10: header: '-7' is no number of things"},
        {"a.ply", with_change(ply, "9 4 0", "9 nan 0"), "element vertex: a coordinate is nan, which is no place"},
        {"a.ply", with_change(ply, "4 0 1 2 3 ", "4 0 1 2 8 "), "a polygon has point 8, of 8 that count from 0"},
        {"a.ply", with_change(ply, "4 0 1 2 3 ", "-4 0 1 2 3 "), "element face: a list has -4 numbers"},
        {"a.ply", with_change(ply, "4 0 1 2 3 ", "4 0 1.5 2 3 "), "'1.5' is not a whole number"},
        {"a.ply", with_change(ply, "double z", "double w"), "element vertex: no property z is announced"},
        {"a.ply", with_change(ply, "vertex_index", "corners"), "element face: no list 'vertex_indices' is announced"},
        {"a.ply", with_change(ply, "double y", "real y"), "a.ply:7: header: numbers of type 'real' are not known"},
        {"a.ply", with_change(ply, "obj_info", "object"), "a.ply:17: header: 'object' is no line of a header"},
        {"a.ply", with_change(ply, "ascii", "utf8"), "a.ply:2: header: format 'utf8' is not known"},
        {"a.ply", with_change(ply, "format ascii 1.0", "comment"), "no line tells the format"},
        {"a.ply", "plyer\n", "a.ply:1: header: 'plyer' stands where 'ply' is expected"},
        {"a.ply", "ply\nformat ascii 1.0\nelement vertex 8\nprop", "a.ply:4: header: 'prop' is no line of a header"},
        {"a.off", with_change(off, "8 7 12", "4000000000000000000 7"),
         "it ends before 4000000000000000000 vertices and 7"},
        {"a.off", with_change(off, "8 7 12", "8 4000000000000000000"),
         "8 vertices and 4000000000000000000 polygons, ea"},
        {"a.off", with_change(off, "8 7 12", "8 6 12"), "a.off:26: a line follows the 8 vertices and 6 polygons"},
        {"a.off", with_change(off, "4 0 0", "4 0"), "a.off:6: it ends here"},
        {"a.off", with_change(off, "4 0 0", "4 0 1e999"), "a.off:6: '1e999' is not a number in double precision"},
        {"a.off", with_change(off, "4 0 1 2 3", "4 0 1 2 9"), "a.off:21: a polygon has point 9, of 8"},
        {"a.off", with_change(off, "4 0 1 2 3", "40 0 1 2 3"), "a.off:21: 40 numbers are announced"},
        {"a.off", with_change(off, "OFF", "4OFF"), "a.off:1: 4OFF has places of more than three coordinates"},
        {"a.off", with_change(off, "OFF", "OFF BINARY"), "a.off:1: the binary form of OFF is not read"},
    };
    for (const PlainFault& fault : faults)
        EXPECT_THAT(plain_fault(std::string(fault.name), fault.bytes), HasSubstr(fault.message));
}

TEST(StlFiles, HaveAFaceForEverySolid) {
    const auto obj_of = [](const std::vector<std::string_view>& names, std::string_view end) {
        std::string text;
        for (const std::string_view name : names)
            text += fmt::format(
                "solid {0}{1}facet normal 0 0 1{1}outer loop{1}vertex 0 0 0{1}vertex 1 0 0{1}vertex 0 1 "
                "{2}{1}endloop{1}endfacet{1}endsolid {0}{1}",
                name, end, text.size());
        return read_stl("a.stl", text).as_obj();
    };
    for (const std::string_view end : {"\n", " "}) {
        const std::string obj = obj_of({"", "wall", "wall", "", "wall.2"}, end);
        for (const std::string_view group : {"g mesh\n", "g wall\n", "g wall.2\n", "g mesh.2\n", "g wall.2.2\n"})
            EXPECT_THAT(obj, HasSubstr(group));
    }
    EXPECT_THAT(obj_of({"occluder", "occluder"}, "\n"), Not(HasSubstr("occluder.2")));
}

std::string gltf_fault(std::string_view json) {
    return fault_in([&] {
        expect_plain_gltf("a.gltf", json);
        return 0;
    });
}

TEST(GltfFiles, AreRefusedWhereTheLibraryWouldMisreadThem) {
    const std::string needed = "is needed and not read (it may change shapes or places)";
    for (const std::string_view name : {"XYZ_nonsense", "KHR_mesh_quantization", "KHR_materials"})
        EXPECT_THAT(gltf_fault(fmt::format(R"({{"extensionsRequired": ["{}"]}})", name)),
                    HasSubstr(fmt::format("a.gltf:1:25: the extension {} {}", name, needed)));
    EXPECT_THAT(gltf_fault(R"({"nodes": [{"extensions": {"EXT_mesh_gpu_instancing": {}}}]})"), HasSubstr(needed));
    EXPECT_THAT(gltf_fault(R"({"bufferViews": [{"extensions": {"EXT_meshopt_compression": {}}}]})"), HasSubstr(needed));
    EXPECT_THAT(gltf_fault(R"({"meshes": [{"primitives": [{"extensions": {"KHR_draco_mesh_compression": {}}}]}]})"),
                HasSubstr(needed));
    EXPECT_THAT(gltf_fault(R"({"meshes": [{"primitives": [{"attributes": {"POSITION": 1}}]}],
                               "accessors": [{"componentType": 5126}, {"componentType": 5122}]})"),
                HasSubstr("a.gltf:2:89: the extension KHR_mesh_quantization is needed"));
    for (const std::string_view owner : {"meshes", "nodes"})
        EXPECT_THAT(gltf_fault(fmt::format(R"({{"{}": [{{"weights": [0, 0.5]}}]}})", owner)),
                    HasSubstr("a morph target has weight 0.5 (only shapes at rest are read)"));
    EXPECT_THAT(gltf_fault(R"({"nodes": [{"mesh": 0, "skin": 0}]})"), HasSubstr("a.gltf:1:32: a node has a skin"));
    EXPECT_THAT(gltf_fault(R"({"asset": )"), HasSubstr("a.gltf:1:11: this is not JSON"));
    EXPECT_THAT(gltf_fault(std::string("glTF\2\0\0\0\x40\0\0\0\2\0\0\0JSON{}", 22)),
                HasSubstr("a.gltf, byte 12: 64 bytes are announced, and the file has 22 (it was cut off)"));
}

/// A file with these members, beside a mesh of two triangles.
std::string gltf_with(std::string_view nodes, std::string_view accessors, std::string_view indices = "1") {
    return fmt::format(
        R"({{"scenes": [{{"nodes": [0]}}], "nodes": [{}], "accessors": [{}], "bufferViews": [{{"buffer": 0}}], "buffers": [{{}}],
                           "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": {}}}]}}]}})",
        nodes, accessors, indices);
}

TEST(GltfFiles, AreRefusedWhereItemsDoNotExistOrCornersAreMissing) {
    const std::string sound = R"({"type": "VEC3", "count": 4}, {"type": "SCALAR", "count": 6})";
    const auto with = [&](std::string_view old, std::string_view changed) { return with_change(sound, old, changed); };
    EXPECT_EQ(expect_plain_gltf("a.gltf", gltf_with(R"({"mesh": 0})", sound)), 2);
    EXPECT_EQ(expect_plain_gltf("a.gltf", gltf_with(R"({}, {"mesh": 0})", sound)), 0) << "the scene has no mesh";
    const std::vector<std::pair<std::string, std::string>> faults{
        {gltf_with(R"({"mesh": 1})", sound), "mesh: number 1 of meshes does not exist (there are 1"},
        {gltf_with(R"({"children": [3]})", sound), "children: number 3 of nodes does not exist"},
        {gltf_with(R"({"matrix": [1, 0, 0]})", sound), "matrix has 3 numbers, and needs 16"},
        {gltf_with("", sound), "a.gltf:1:24: nodes: number 0 of nodes does not exist (there are 0"},
        {gltf_with("{}", sound, "2"), "indices: number 2 of accessors does not exist"},
        {gltf_with("{}", sound, "-1"), "indices is no whole number from 0 on"},
        {gltf_with("{}", with("VEC3", "VEC2")), "places are of type 'VEC2'"},
        {gltf_with("{}", with("6}", "5}")), "its triangles have 5 corners, which is no multiple of 3"},
        {gltf_with("{}", with("6}", R"(6, "byteOffset": -4})")), "byteOffset is no whole number from 0 on"},
        {gltf_with("{}", with("6}", R"(6, "bufferView": 1})")), "bufferView: number 1 of bufferViews does not exist"},
    };
    for (const auto& [json, message] : faults) EXPECT_THAT(gltf_fault(json), HasSubstr(message));
}

TEST(GltfFiles, MayHaveExtensionsThatLeaveShapesAlone) {
    EXPECT_EQ(gltf_fault(R"({"extensionsRequired": ["KHR_materials_unlit", "KHR_texture_transform"],
                             "extensionsUsed": ["KHR_mesh_quantization", "MINE_unknown"],
                             "extras": {"extensions": {"EXT_mesh_gpu_instancing": {}}},
                             "nodes": [{"weights": [0], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
                             "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}, {}]}],
                             "accessors": [{"componentType": 5126}, {"componentType": 5120}]})"),
              "");
    EXPECT_EQ(gltf_fault(std::string("glTF\2\0\0\0\x16\0\0\0\2\0\0\0JSON{}", 22)), "");
    EXPECT_EQ(gltf_fault("[]"), "");  // the library says what is wrong
}

}  // namespace
}  // namespace ff::studies::meshes
