#include "core/geometry/convex_polygon.hpp"
#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/meshes/formats.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

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

    /// The node's name; that of the mesh where the node has none but the library's.
    [[nodiscard]] std::string group_of(const aiNode& node, const aiMesh& mesh) const {
        std::string name = meshes::as_word(node.mName.C_Str());
        if (name.empty() || &node == scene_.mRootNode) name = meshes::as_word(mesh.mName.C_Str());
        return name.empty() ? std::string(meshes::unnamed_group) : name;
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

    /// Writes corners and the polygon; nothing where it has no area, since nothing leaves it or arrives there.
    std::string polygon(const std::vector<Vector3d>& corners) {
        double size = 0;
        for (const Vector3d& corner : corners) size = std::max(size, (corner - corners[0]).norm());
        if (!(twice_area(corners).norm() > 2 * least_share_of_area * size * size)) return {};
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
    throw UserError(
        fmt::format("{}: {} by its content (its name says that it is something else). Rename it to end in "
                    "{}.",
                    file, kind.name, kind.extension));
}

std::string gltf_as_obj(const std::string& file, std::string_view bytes) {
    meshes::expect_plain_gltf(file, bytes);
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file, aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw UserError(fmt::format("{}: cannot be read as a mesh ({}). Write it again, or as OBJ.", file,
                                    excerpt(importer.GetErrorString())));
    ObjWriter writer(*scene);
    if (writer.is_empty())
        throw UserError(
            fmt::format("{}: no polygon with an area (nothing would be computed). Write the mesh with its "
                        "polygons.",
                        file));
    return std::move(writer).text();
}

}  // namespace

void expect_no_mesh(const std::filesystem::path& file, std::string_view bytes) {
    if (!std::filesystem::is_regular_file(file)) return;
    if (const auto* const kind = meshes::mesh_kind(bytes)) refuse_name(file.string(), *kind);
}

std::string mesh_as_obj(const std::filesystem::path& file) {
    const std::string name = file.string();
    const std::string bytes = read_bytes(file);
    if (bytes.empty())
        throw IoError(fmt::format("{}: cannot be read (empty). Check the name and the permissions.", name));
    const auto* kind = meshes::mesh_kind(bytes);
    if (kind == nullptr && has_extension(name, ".msh"))
        throw UserError(
            fmt::format("{}: no mesh of gmsh from version 2 on (it would begin with $MeshFormat). Save it "
                        "as version 2 or 4.",
                        name));
    if (kind == nullptr && (has_extension(name, ".vtk") || has_extension(name, ".vtu") || has_extension(name, ".vtp")))
        throw UserError(
            fmt::format("{}: no file of VTK (it would begin with '# vtk DataFile', or as XML with VTKFile). "
                        "Write it again.",
                        name));
    // Files of these formats need not have a mark; the readers of the others say what is wrong with them.
    for (const std::string_view extension : {".stl", ".ply", ".off"}) {
        if (kind == nullptr && has_extension(name, extension)) kind = meshes::mesh_kind_named(extension);
    }
    if (kind != nullptr && kind->read != nullptr) return kind->read(name, bytes).as_obj();
    if (kind != nullptr && !has_extension(name, kind->extension)) refuse_name(name, *kind);
    return gltf_as_obj(name, bytes);
}

}  // namespace ff::studies
