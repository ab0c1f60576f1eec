#include "studies/explain/descriptions.hpp"

#include <array>

namespace ff::studies {
namespace {

constexpr std::array estimators{
    Description{
        "ray_shooting", "rays from every patch, cosine distributed; counts what they hit (the paper's SR)",
        "A 4-D point gives the origin on the source patch (2) and the direction (2). The estimate of F(i, j) is the "
        "share\n"
        "of the rays from face i that hit face j: integer counts, unbiased, and nothing is chosen about the target.\n"
        "Works with every sampler of equal weights. allocation = \"face\" runs one sequence over all patches of a "
        "face.\n"
        "Rays that leave a closed scene are lost rays; they are counted and reported.",
        "shirley1991"},
    Description{
        "area_kernel", "cos·cos/(pi r^2) at pairs of points on two patches (with gauss_legendre: the paper's PDM)",
        "A 4-D point gives a point on each patch of an ordered pair; samples_per_patch counts points per pair. "
        "Unbiased "
        "with\n"
        "random points, but where patches share an edge or a vertex the kernel is unbounded: the tail index is 3/2 or "
        "2, the\n"
        "variance infinite, and no interval is shown. With Gauss-Legendre nodes on both patches it is the parametric\n"
        "differential method (PDM); its error near common edges falls as 1/m only. map = \"graded\" lays points s^3 "
        "from a "
        "common\n"
        "edge (s^2 from a common vertex): tail index 5/2, finite variance. What may stand between two surfaces is "
        "looked at\n"
        "point by point.",
        "baranoski1992"},
    Description{
        "point_to_polygon", "exact factors from points of the source to each face (Lambert's formula)",
        "A 2-D point lies on the source patch; from there the form factor to every visible face is exact: a sum over "
        "the edges\n"
        "of the face, each the angle under which it is seen times a cosine. Points are shared by all targets, and "
        "subdivision\n"
        "divides the source only. Unbiased with random points, of values between 0 and 1; smooth between parallel "
        "faces, with a\n"
        "jump at the corners where three faces meet. Works with every sampler in two dimensions (so stratified takes "
        "k^2 points)\n"
        "and, deterministically, with Gauss-Legendre nodes. Unoccluded convex scenes only.",
        "baum1989"},
    Description{
        "closed_form", "exact formulas for parallel and perpendicular rectangles",
        "Takes no points and has no error but rounding (about 1e-15 of the squared extent). Axis-aligned rectangles "
        "with\n"
        "nothing in between. The reference that bias is measured from, and the baseline that others have to beat.",
        "howell"},
};

constexpr std::array scenes{
    Description{
        "cube", "the inside of the paper's cube, edges of 6",
        "Faces as in the paper: 1 opposite 6, 2 opposite 3, 4 opposite 5; 3 is frontal. The same scene as box:6x6x6.",
        "baranoski1999"},
    Description{"box:AxBxC", "the inside of any box, e.g. box:2x1x0.5",
                "Faces 1 and 6 are A x B at distance C, faces 2 and 3 are A x C at distance B, faces 4 and 5 are B x C "
                "at distance A.",
                "howell"},
    Description{"FILE", "a scene file beside the study file: .obj, .vs3 or .toml",
                "Wavefront OBJ (groups are faces), View3D, or TOML with every shape; what is in each: docs/scenes.md.\n"
                "Exact values are known of rectangles along the axes that nothing can stand between, and of closed "
                "convex rooms with\n"
                "flat walls or of revolution.",
                ""},
};

constexpr std::array completions{
    Description{"direct", "every row of the matrix of faces from its own samples (the default)",
                "completion = \"direct\". In a closed scene the rows of ray shooting sum to exactly 1.", ""},
    Description{"reciprocal", "F(j, i) with j > i from F(i, j), by reciprocity, as in the paper",
                "completion = \"reciprocal\": F(j, i) = A_i F(i, j) / A_j. Applied to the stored direct estimates, so "
                "that it changes\nno random number. Errors of the first face's row add up in those of the last.",
                "baranoski1999"},
};

constexpr std::array allocations{
    Description{"patch", "every patch has its own sequence of points (the default)",
                "allocation = \"patch\", for ray_shooting and point_to_polygon. The size that counts for a sampler is "
                "samples_per_patch.",
                ""},
    Description{
        "face", "one sequence of points for all patches of a face",
        "allocation = \"face\", for ray_shooting and point_to_polygon: patch p takes points p n to (p + 1) n - 1. "
        "The size that\ncounts for a sampler is patches_per_face times samples_per_patch. Refused for "
        "stratified, of whose points a part is biased.",
        ""},
};

constexpr std::array maps{
    Description{"uniform", "points are laid evenly on both patches (the default)",
                "map = \"uniform\", for area_kernel. Between patches that share an edge or a vertex the variance is "
                "infinite.",
                ""},
    Description{"graded", "points are laid densely where two patches touch, and weighed accordingly",
                "map = \"graded\", for area_kernel: distances s^3 from a common edge, s^2 from a common vertex. The "
                "variance becomes\nfinite (tail index 5/2 at an edge), the fourth moment stays infinite, and the "
                "estimate stays unbiased. No help to\ngauss_legendre.",
                ""},
};

constexpr std::array tracers{
    Description{"automatic", "the analytic tracer where it applies, Embree elsewhere (the default)",
                "tracer = \"automatic\", for ray_shooting.", ""},
    Description{
        "box", "an analytic, vectorised tracer for the inside of an empty box",
        "tracer = \"box\", for ray_shooting. Refused for other scenes. Both tracers shoot the same rays and agree "
        "but for rays that\npass within rounding of an edge.",
        ""},
    Description{"embree", "the general tracer",
                "tracer = \"embree\", for ray_shooting. Robust mode, no epsilon: a ray's own surface is left out by a "
                "mask.",
                "wald2014"},
};

constexpr std::array choices{
    Choices{"estimator", "estimators", estimators},
    Choices{"scene", "scenes", scenes},
    Choices{"completion", "completions", completions},
    Choices{"allocation", "allocations", allocations},
    Choices{"map", "maps", maps},
    Choices{"tracer", "tracers", tracers},
};

}  // namespace

std::span<const Choices> all_choices() {
    return choices;
}

}  // namespace ff::studies
