#include "core/geometry/convex_polygon.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/meshes/formats.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// The library's name for a node that it puts above several.
constexpr std::string_view name_of_added_root = "ROOT";

/// Writes nodes as groups, with all places in the coordinates of the whole.
class ObjWriter {
  public:
    explicit ObjWriter(const aiScene& scene) : scene_(scene) { add(*scene.mRootNode, Eigen::Affine3d::Identity()); }

    [[nodiscard]] std::string text() && { return std::move(text_); }
    [[nodiscard]] bool is_empty() const { return vertices_ == 0; }

  private:
    const aiScene& scene_;
    std::string text_;
    std::size_t vertices_ = 0;
    std::map<std::pair<const aiNode*, std::string>, std::string> groups_;  ///< by node and name
    std::map<std::string, const aiNode*> owners_;                          ///< of groups

    void add(const aiNode& node, const Eigen::Affine3d& parent) {
        Eigen::Matrix4d own;
        for (unsigned i = 0; i < 4; ++i) {
            for (unsigned j = 0; j < 4; ++j)
                own(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    static_cast<double>(node.mTransformation[i][j]);
        }
        const Eigen::Affine3d place = parent * Eigen::Affine3d(own);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) add(node, *scene_.mMeshes[node.mMeshes[i]], place);
        for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], place);
    }

    /// The node's name; that of the mesh where the node has none but the library's. Names need not be different, and
    /// those of further nodes get a number.
    [[nodiscard]] std::string group_of(const aiNode& node, const aiMesh& mesh) {
        std::string name = meshes::as_word(node.mName.C_Str());
        if (name.empty() || name == name_of_added_root) name = meshes::as_word(mesh.mName.C_Str());
        if (name.empty()) return std::string(meshes::unnamed_group);
        std::string& group = groups_[{&node, name}];
        if (group.empty()) group = name;
        for (int number = 2; group != occluder_group && owners_.try_emplace(group, &node).first->second != &node;
             ++number)
            group = fmt::format("{}.{}", name, number);
        return group;
    }

    void add(const aiNode& node, const aiMesh& mesh, const Eigen::Affine3d& place) {
        std::string polygons;
        const bool mirrored = place.linear().determinant() < 0;
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            std::vector<Vector3d> corners;
            for (unsigned k = 0; k < mesh.mFaces[i].mNumIndices; ++k) {
                const aiVector3D& at = mesh.mVertices[mesh.mFaces[i].mIndices[k]];
                corners.push_back(
                    place * Vector3d(static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)));
            }
            if (mirrored) std::reverse(corners.begin(), corners.end());
            polygons += polygon(corners);
        }
        if (polygons.empty()) return;
        text_ += fmt::format("g {}\n", group_of(node, mesh));
        const aiString material = scene_.mMaterials[mesh.mMaterialIndex]->GetName();
        const bool is_named = material.length > 0 && std::string_view(material.C_Str()) != AI_DEFAULT_MATERIAL_NAME;
        text_ += fmt::format("usemtl {}\n", is_named ? meshes::as_word(material.C_Str()) : "");
        text_ += polygons;
    }

    std::string polygon(const std::vector<Vector3d>& corners) {
        std::string text;
        std::string polygon = "f";
        for (const Vector3d& corner : corners) {
            text += fmt::format("v {} {} {}\n", corner.x(), corner.y(), corner.z());
            polygon += fmt::format(" {}", ++vertices_);
        }
        return text + polygon + '\n';
    }
};

[[noreturn]] void refuse_name(const std::string& file, const meshes::MeshKind& kind) {
    throw UserError("{}: {} by its content (its name says that it is something else). Rename it to end in {}.", file,
                    kind.name, kind.extension);
}

/// The library takes the names of files literally.
class FilesOfGltf : public Assimp::DefaultIOSystem {
  public:
    [[nodiscard]] bool Exists(const char* file) const override {
        return DefaultIOSystem::Exists(file) || DefaultIOSystem::Exists(meshes::percent_decoded(file).c_str());
    }

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        return DefaultIOSystem::Open(DefaultIOSystem::Exists(file) ? file : meshes::percent_decoded(file).c_str(),
                                     mode);
    }
};

std::string gltf_as_obj(const std::string& file, std::string_view bytes) {
    const std::size_t triangles = meshes::expect_plain_gltf(file, bytes);
    Assimp::Importer importer;
    importer.SetIOHandler(new FilesOfGltf);  // which the importer deletes
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file, aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw UserError("{}: cannot be read as a mesh ({}). Write it again, or as OBJ.", file,
                        excerpt(importer.GetErrorString()));
    // The library passes over triangles whose corners do not exist.
    std::size_t read = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) read += scene->mMeshes[i]->mNumFaces;
    if (read < triangles)
        throw UserError(
            "{}: {} of {} triangles have corners that do not exist (indices beyond the places of their mesh). Write it "
            "again.",
            file, triangles - read, triangles);
    ObjWriter writer(*scene);
    if (writer.is_empty())
        throw UserError("{}: no polygon with an area (nothing would be computed). Write the mesh with its polygons.",
                        file);
    return std::move(writer).text();
}

}  // namespace

void expect_no_mesh(const std::filesystem::path& file, std::string_view bytes) {
    if (!std::filesystem::is_regular_file(file)) return;
    if (const auto* const kind = meshes::mesh_kind(bytes)) refuse_name(file.string(), *kind);
}

std::string mesh_as_obj(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::string bytes = with_line_feeds(read_bytes(file));
    if (bytes.empty()) throw IoError("{}: cannot be read (empty). Check the name and the permissions.", name);
    const auto* const kind = meshes::mesh_kind(bytes);
    if (kind == nullptr && has_extension(name, ".msh"))
        throw UserError(
            "{}: no mesh of gmsh from version 2 on (it would begin with $MeshFormat). Save it as version 2 or 4.",
            name);
    if (kind == nullptr && (has_extension(name, ".vtk") || has_extension(name, ".vtu") || has_extension(name, ".vtp")))
        throw UserError(
            "{}: no file of VTK (it would begin with '# vtk DataFile', or as XML with VTKFile). Write it again.", name);
    // Files of these formats need not have a mark; the readers of the others say what is wrong with them.
    if (kind == nullptr && has_extension(name, ".stl")) return meshes::read_stl(name, bytes).as_obj();
    if (kind == nullptr && has_extension(name, ".ply")) return meshes::read_ply(name, bytes).as_obj();
    if (kind == nullptr && has_extension(name, ".off")) return meshes::read_off(name, bytes).as_obj();
    if (kind != nullptr && kind->read != nullptr) return kind->read(name, bytes).as_obj();
    if (kind != nullptr && !has_extension(name, kind->extension)) refuse_name(name, *kind);
    if (kind == nullptr && has_extension(name, ".glb"))
        throw UserError(
            "{}: no binary glTF file (it would begin with 'glTF'). Rename it to end in .gltf if it is JSON.", name);
    return gltf_as_obj(name, bytes);
}

}  // namespace ff::studies
