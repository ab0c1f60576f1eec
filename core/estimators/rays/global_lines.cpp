#include "core/estimators/rays/global_lines.hpp"
#include "core/estimators/unmet.hpp"

#include "core/geometry/line_meets.hpp"
#include "core/geometry/surface_map.hpp"
#include "core/geometry/unit_circle.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace ff {
namespace {

using Eigen::Vector3d;

/// Where a line crosses a surface.
struct Crossing {
    double time = 0;
    bool arrives = false;  ///< it meets the front; otherwise it comes from the back
    int face = no_face;
};

FlatPiece piece(const Surface& surface) {
    const std::vector<Vector3d> rim = corners(surface.shape);
    const Vector3d u = rim[1] - rim[0];
    const Vector3d v = rim.back() - rim[0];
    const Vector3d across = u.cross(v);
    const double squared = across.squaredNorm();
    return {rim[0],          surface.normal, v.cross(across) / squared, across.cross(u) / squared,
            rim.size() == 3, surface.face};
}

void cross_flat(const std::vector<FlatPiece>& pieces, const Line& line, std::vector<Crossing>& crossings) {
    for (const FlatPiece& piece : pieces) {
        const double speed = piece.normal.dot(line.direction);
        if (speed == 0) continue;
        const Vector3d offset = line.origin - piece.corner;
        const double time = -piece.normal.dot(offset) / speed;
        const Vector3d place = offset + time * line.direction;
        const double u = piece.along_u.dot(place);
        const double v = piece.along_v.dot(place);
        if (time < 0 || u < 0 || v < 0 || (piece.is_triangle ? u + v : std::max(u, v)) > 1) continue;
        crossings.push_back({time, speed < 0, piece.face});
    }
}

void cross_round(const std::vector<const Surface*>& surfaces, const Line& line, double length,
                 std::vector<Crossing>& crossings) {
    const auto add = [&](const Surface& surface, double time) {
        const Vector3d normal = is_flat(surface.shape) ? surface.normal : normal_at(surface, line.at(time));
        crossings.push_back({time, line.direction.dot(normal) < 0, surface.face});
    };
    const Line back{line.at(length), -line.direction};
    for (const Surface* surface : surfaces) {
        const auto first = line_meets(line, *surface);
        if (!first) continue;
        add(*surface, first->time);
        if (is_flat(surface->shape)) continue;
        // A line meets a round surface at most twice: the second time is the first from the other end.
        const auto last = line_meets(back, *surface);
        if (last && length - last->time > first->time + 1e-9 * length) add(*surface, length - last->time);
    }
}

/// Sorts crossings by insertion, since they are few. Where surfaces lie on each other, those at which the line arrives
/// come first.
void put_in_order(double length, std::vector<Crossing>& crossings) {
    const double grain = 1e-12 * length;
    const auto comes_before = [&](const Crossing& a, const Crossing& b) {
        if (std::abs(a.time - b.time) > grain) return a.time < b.time;
        return a.arrives && !b.arrives;
    };
    for (std::size_t i = 1; i < crossings.size(); ++i) {
        for (std::size_t k = i; k > 0 && comes_before(crossings[k], crossings[k - 1]); --k)
            std::swap(crossings[k], crossings[k - 1]);
    }
}

/// A line that enters the box through one of its sides. Those that cross a convex body are uniform where they begin
/// uniformly on its surface, cosine distributed. @param s  says through which side too
/// @param margin  by which the line begins before the box
Line line_through(const Eigen::AlignedBox3d& box, const std::vector<BoxSide>& sides, double area, double margin,
                  double s, double t, double squared_sine, double azimuth) {
    double at = s * area;
    auto side = sides.begin();
    for (; side + 1 != sides.end() && at >= side->area; ++side) at -= side->area;
    const int across = (side->axis + 1) % 3;
    const int along = (side->axis + 2) % 3;
    const CirclePoint turned = unit_circle(azimuth);
    const double sine = std::sqrt(squared_sine);
    const double cosine = std::sqrt(1 - squared_sine);
    Line line;
    line.direction[side->axis] = side->high ? -cosine : cosine;
    line.direction[across] = sine * turned.cosine;
    line.direction[along] = sine * turned.sine;
    line.origin[side->axis] = side->high ? box.max()[side->axis] : box.min()[side->axis];
    line.origin[across] = box.min()[across] + at / side->area * (box.max()[across] - box.min()[across]);
    line.origin[along] = box.min()[along] + t * (box.max()[along] - box.min()[along]);
    line.origin -= margin * line.direction;
    return line;
}

}  // namespace

GlobalLines::GlobalLines(const Scene& scene, TracerChoice tracer) : SceneEstimator(scene, tracer) {
    for (const Surface& surface : scene.surfaces) {
        if (is_of_face(surface)) box_.extend(box_around(surface));
        if (!is_polygon(surface.shape))
            round_.push_back(&surface);
        else
            flat_.push_back(piece(surface));
    }
    const Eigen::Vector3d sizes = box_.sizes();
    for (int axis = 0; axis < 3; ++axis) {
        const double area = sizes[(axis + 1) % 3] * sizes[(axis + 2) % 3];
        if (!(area > 0)) continue;
        for (const bool high : {false, true}) sides_.push_back({axis, high, area});
        area_ += 2 * area;
    }
}

double GlobalLines::largest_unmet(const Scene& scene, int from, int to, double evaluations) {
    double crossings = 0;  // largest number of crossings of a line and the face
    for (const Surface& surface : scene.surfaces) {
        if (surface.face == from) crossings += is_flat(surface.shape) ? 1 : 2;
    }
    const double largest = crossings * GlobalLines(scene, TracerChoice::automatic).area_ / (2 * face_area(scene, from));
    return largest_unmet_hit(scene, from, to, evaluations, largest);
}

void GlobalLines::observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const {
    const auto faces = static_cast<Eigen::Index>(scene().faces.size());
    Eigen::MatrixXd exchanges = Eigen::MatrixXd::Zero(faces, faces);
    Eigen::VectorXd crossed = Eigen::VectorXd::Zero(faces);
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = info.dimension;
    const Stream stream{.key = task.key, .trial = task.trial};
    std::vector<Crossing> crossings;
    const double diagonal = box_.diagonal().norm();
    const double margin = 0x1p-10 * diagonal;
    const double length = diagonal + 2 * margin;
    for_each_block(*task.points, stream, 0, task.samples, *block, [&](PointIndex) {
        task.points->checkpoint();
        for (std::size_t i = 0; i < block->size; ++i) {
            const Line line = line_through(box_, sides_, area_, margin, block->coordinate[0][i],
                                           block->coordinate[1][i], block->coordinate[2][i], block->coordinate[3][i]);
            crossings.clear();
            cross_flat(flat_, line, crossings);
            cross_round(round_, line, length, crossings);
            put_in_order(length, crossings);
            for (std::size_t k = 0; k < crossings.size(); ++k) {
                const Crossing& here = crossings[k];
                if (here.face >= 0) crossed[here.face] += block->weight[i];
                if (k + 1 == crossings.size()) continue;
                const Crossing& next = crossings[k + 1];
                if (here.arrives || !next.arrives || here.face < 0 || next.face < 0) continue;
                exchanges(here.face, next.face) += block->weight[i];
                exchanges(next.face, here.face) += block->weight[i];
            }
        }
    });
    for (Eigen::Index face = 0; face < faces; ++face) {
        if (crossed[face] > 0) exchanges.row(face) /= crossed[face];
    }
    outcome.estimates = exchanges;
}

}  // namespace ff
