#include "core/geometry/convex_polygon.hpp"
#include "core/support/error.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;

/// A name as a word of an OBJ file.
std::string as_word(const aiString& name) {
    std::string word = name.C_Str();
    for (char& c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isspace(byte) != 0 || std::iscntrl(byte) != 0 || c == '|') c = '_';
    }
    return word;
}

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

    /// The node's name; that of the mesh where the node has none but the reader's ("<STL_BINARY>").
    [[nodiscard]] std::string group_of(const aiNode& node, const aiMesh& mesh) const {
        std::string name = as_word(node.mName);
        if (name.empty() || name.front() == '<' || &node == scene_.mRootNode) name = as_word(mesh.mName);
        return name.empty() || name.front() == '<' ? "mesh" : name;
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
        text_ += fmt::format("usemtl {}\n", is_named ? as_word(material) : "");
        text_ += polygons;
    }

    /// Corners and the polygon; nothing where it has no area: nothing leaves it or arrives.
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

void expect_readable(const std::filesystem::path& file) {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (in.peek() != std::ifstream::traits_type::eof()) return;
    throw IoError(fmt::format("{}: cannot be read ({}). Check the name and the permissions.", file.string(),
                              errno == 0 ? "empty" : std::generic_category().message(errno)));
}

}  // namespace

std::string mesh_as_obj(const std::filesystem::path& file) {
    expect_readable(file);  // the library does not say what is wrong
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(file.string(), aiProcess_SortByPType | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw UserError(fmt::format("{}: cannot be read as a mesh ({}). Write it again, or as OBJ.", file.string(),
                                    importer.GetErrorString()));
    ObjWriter writer(*scene);
    if (writer.is_empty())
        throw UserError(
            fmt::format("{}: no polygon with an area (nothing would be computed). Write the mesh with its "
                        "polygons.",
                        file.string()));
    return std::move(writer).text();
}

}  // namespace ff::studies
