#pragma once

#include "core/geometry/subdivision.hpp"
#include "core/points/points.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff {

/// Rays in single precision, one array per component; they start on surface `source` and lead to its radiating side.
/// They cannot hit a flat or convex source; a concave one they can hit only elsewhere.
struct RayBatch {
    std::vector<float> origin_x, origin_y, origin_z;
    std::vector<float> direction_x, direction_y, direction_z;  ///< not necessarily of unit length
    std::uint32_t source = 0;

    [[nodiscard]] std::size_t size() const { return origin_x.size(); }
};

inline constexpr std::uint32_t no_surface = 0xffffffffu;

/// The first surface that a ray meets, and where, in the surface's own coordinates in [0, 1].
struct Hit {
    std::uint32_t surface = no_surface;  ///< no_surface: the ray met nothing
    float s = 0;
    float t = 0;
    bool received = true;  ///< false on the back of the surface, and where it belongs to no face
};

/// Hits of one patch's rays by face; entry faces() is the number of lost rays.
using FaceHits = std::vector<std::uint64_t>;

/// Finds what rays hit. Surfaces are opaque from both sides, but receive on their radiating side only: a ray that
/// arrives from behind ends there and counts neither as a hit nor as lost (this cannot happen in a closed scene whose
/// normals point inward). The surface that a ray starts on is excluded by identity, never by a distance; on a curved
/// one, only the origin is. Safe to use from several threads at once. Patches are found from hit coordinates by
/// arithmetic, so the cost does not grow with them.
class Tracer {
  public:
    virtual ~Tracer() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;

    /// Shoots one cosine-distributed ray for each 4-D point (s, t on the patch; direction) of `block` from patch
    /// `patch` of the `grid` of patches of surface `source` and adds the hits by face to `hits` (faces + 1 entries, the
    /// last for lost rays). Rays that end where nothing receives are not counted.
    virtual void shoot(std::uint32_t source, Grid grid, std::uint32_t patch, const PointBlock& block,
                       std::span<std::uint64_t> hits) const = 0;

    /// Where each ray that `shoot` would shoot ends; `hits` has room for block.size.
    /// @param surface  the source, of the scene as it is placed (core/geometry/placement.hpp)
    virtual void find_ends(const Surface& surface, std::uint32_t source, Grid grid, std::uint32_t patch,
                           const PointBlock& block, std::span<Hit> hits) const;

    /// Traces rays one by one; `hits` has room for rays.size().
    virtual void trace(const RayBatch& rays, std::span<Hit> hits) const = 0;

  protected:
    Tracer() = default;
    Tracer(const Tracer&) = default;
    Tracer& operator=(const Tracer&) = default;
    Tracer(Tracer&&) = default;
    Tracer& operator=(Tracer&&) = default;
};

/// The rays that `Tracer::shoot` shoots for these points, in single precision and the same to the bit on every CPU.
/// Coordinates 0 and 1 place the origin at (s, t) on the patch: of a parallelogram along edge_u and edge_v, at the
/// middle of one of 2^23 cells. Coordinate 2 is the squared sine of the angle to the normal, coordinate 3 the azimuth
/// in turns: on a parallelogram from edge_u towards edge_v, elsewhere from the tangent of SurfacePoint. @throws
/// UserError where the surface does not fit single precision
void generate_rays(const Surface& surface, std::uint32_t source, Grid grid, std::uint32_t patch,
                   const PointBlock& block, RayBatch& rays);

/// Analytic vectorised tracer for the inside of an empty box; equal hits on every CPU. A ray that meets an edge hits
/// the opposite surface first, then the one across edge_v. @pre scene.empty_box
std::unique_ptr<Tracer> make_box_tracer(const Scene& scene);

/// Embree in robust mode, for any scene: flat polygons by its own code, round shapes by core/geometry/line_meets, in
/// double precision. Rays that pass within rounding of an edge may be seen differently by its code for different CPUs;
/// in a closed box none is lost. Round shapes and flat ones meet in edges that have no corners in common, and a ray's
/// origin is rounded: in a closed scene, a ray that meets nothing is traced once more from 2^-20 nearer to the middle
/// of its surface, among round shapes larger by 2^-20. A ray lost even then has met a hole. A ray that ends on a back
/// before it has risen above its source by more than rounding is traced once more from a little above: surfaces that
/// are coplanar with the source, or face away from it, do not catch rays that start on their edge. @see [wald2014]
std::unique_ptr<Tracer> make_embree_tracer(const Scene& scene);

/// Every surface by core/geometry/line_meets in double precision, origins of rays too (those of a RayBatch are moved
/// back to their surface): for scenes with sizes or gaps that single precision does not resolve. Rays that meet nothing
/// in a closed scene are traced once more as Embree's are, and the hits are the same on every CPU. Coplanar surfaces do
/// not hide each other: rays that start on one pass the others, and those that arrive end on the one that receives
/// them, or on the first of several in scene order.
std::unique_ptr<Tracer> make_double_tracer(const Scene& scene);

/// Whether single precision may fail to resolve what rays meet in a scene, so that they have to be traced in double
/// precision: where a face is narrower (its area by the diagonal of its box) than 2^-9 of the scene's largest
/// coordinate; where flat surfaces lie over each other within 2^-18 of it, at an angle below 2^-4; or where a curved
/// surface and another come as near as 2^-7 to each other, nearly parallel there. Surfaces that merely share an edge or
/// a rim at a wider angle do not count: rounding misjudges only a strip of 2^-24.
/// @pre the scene is placed (core/geometry/placement.hpp)
bool has_fine_detail(const Scene& scene);

/// Width of the crack along each edge of a surface, as a share of the surface's extent.
inline constexpr float crack_width = 1e-4f;

enum class TracerChoice {
    automatic,
    box,
    embree,
    /// Control: a tracer that is broken on purpose. Rays are traced as with `automatic`, but those that end within
    /// `crack_width` of an edge of the surface they hit slip through and are lost, as with meshes that are not
    /// watertight or hits that are tested with an epsilon. In a closed cube about one ray in 2000 is lost.
    leaky,
};

/// The box tracer where it applies, unless told otherwise.
/// @throws UserError where the box tracer is asked for in a scene that is not an empty box
std::unique_ptr<Tracer> make_tracer(const Scene& given, TracerChoice choice);

/// The Embree that this process has loaded, e.g. "Embree 4.3.3".
std::string tracer_version();

}  // namespace ff
