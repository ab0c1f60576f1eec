#include "core/visibility/cluster_tree.hpp"

#include "core/geometry/surface_map.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ff {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// The coordinates of a place in the plane of a parallelogram, along its edges.
std::array<double, 2> coordinates(const Parallelogram& frame, const Vector3d& place) {
    const Vector3d across = frame.edge_u.cross(frame.edge_v);
    const Vector3d offset = place - frame.corner;
    const double area = across.squaredNorm();
    return {offset.cross(frame.edge_v).dot(across) / area, frame.edge_u.cross(offset).dot(across) / area};
}

}  // namespace

class ClusterTree::Builder {
  public:
    Builder(ClusterTree& tree, const std::vector<Surface>& surfaces, const JoinedSurfaces& walls)
        : tree_(tree),
          surfaces_(surfaces),
          walls_(walls.scene.surfaces),
          members_(walls_.size()),
          boxes_(boxes_around(surfaces)),
          wall_boxes_(boxes_around(walls_)) {
        for (std::uint32_t s = 0; s < surfaces.size(); ++s) members_[walls.of[s]].push_back(s);
        tree_.leaf_of_.resize(surfaces.size());
        std::vector<std::uint32_t> order(walls_.size());
        std::iota(order.begin(), order.end(), 0U);
        if (!order.empty()) add_walls(order);
    }

  private:
    ClusterTree& tree_;
    const std::vector<Surface>& surfaces_;
    const std::vector<Surface>& walls_;
    std::vector<std::vector<std::uint32_t>> members_;  ///< surfaces of each wall
    std::vector<AlignedBox3d> boxes_;
    std::vector<AlignedBox3d> wall_boxes_;

    std::uint32_t begin_cluster() {
        const auto index = static_cast<std::uint32_t>(tree_.clusters_.size());
        tree_.clusters_.emplace_back().first = static_cast<std::uint32_t>(tree_.order_.size());
        return index;
    }

    /// Completes a cluster after everything below it has been added.
    void end_cluster(std::uint32_t index) {
        Cluster& cluster = tree_.clusters_[index];
        cluster.count = static_cast<std::uint32_t>(tree_.order_.size()) - cluster.first;
        cluster.grain = std::numeric_limits<double>::max();
        for (std::uint32_t k = cluster.first; k < cluster.first + cluster.count; ++k) {
            const AlignedBox3d& box = boxes_[tree_.order_[k]];
            cluster.box.extend(box);
            cluster.grain = std::min(cluster.grain, box.sizes().maxCoeff());
        }
        if (cluster.is_wall) cluster.box.extend(wall_boxes_[cluster.wall]);
        cluster.size = cluster.box.diagonal().norm();
        if (cluster.corner_count != 0) return;
        cluster.corner_count = 8;
        for (int k = 0; k < 8; ++k)
            cluster.corners[static_cast<std::size_t>(k)] = cluster.box.corner(static_cast<AlignedBox3d::CornerType>(k));
    }

    template <class Add>
    void add_halves(std::uint32_t index, std::span<std::uint32_t> order, std::size_t half, const Add& add) {
        add(order.first(half));
        const std::uint32_t upper = add(order.subspan(half));
        tree_.clusters_[index].upper = upper;
    }

    std::uint32_t add_walls(std::span<std::uint32_t> walls) {
        if (walls.size() == 1) return add_pieces(members_[walls[0]], walls[0], true);
        const std::uint32_t index = begin_cluster();
        AlignedBox3d middles;
        for (const std::uint32_t wall : walls) middles.extend(wall_boxes_[wall].center());
        Eigen::Index axis = 0;
        middles.sizes().maxCoeff(&axis);
        std::sort(walls.begin(), walls.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(wall_boxes_[a].center()[axis], a) < std::pair(wall_boxes_[b].center()[axis], b);
        });
        add_halves(index, walls, walls.size() / 2, [&](auto half) { return add_walls(half); });
        end_cluster(index);
        return index;
    }

    /// Adds a cluster of pieces of one wall.
    std::uint32_t add_pieces(std::span<std::uint32_t> pieces, std::uint32_t wall, bool is_wall) {
        const std::uint32_t index = begin_cluster();
        tree_.clusters_[index].wall = wall;
        tree_.clusters_[index].is_wall = is_wall;
        const Surface& whole = walls_[wall];
        if (is_flat(whole.shape)) lay_flat(tree_.clusters_[index], pieces, whole);
        if (pieces.size() == 1) {
            tree_.order_.push_back(pieces[0]);
            tree_.leaf_of_[pieces[0]] = index;
        } else {
            add_halves(index, pieces, halved(pieces, frame_of(whole)),
                       [&](auto half) { return add_pieces(half, wall, false); });
        }
        end_cluster(index);
        return index;
    }

    /// The parallelogram of a wall that consists of several surfaces.
    [[nodiscard]] static Parallelogram frame_of(const Surface& wall) {
        const auto* parallelogram = std::get_if<Parallelogram>(&wall.shape);
        if (parallelogram != nullptr) return *parallelogram;
        return {Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY()};
    }

    void lay_flat(Cluster& cluster, std::span<const std::uint32_t> pieces, const Surface& wall) const {
        const Surface& first = surfaces_[pieces[0]];
        cluster.normal = pieces.size() == 1 ? first.normal : wall.normal;
        std::vector<Vector3d> around = corners(pieces.size() == 1 ? first.shape : wall.shape);
        if (around.empty()) around.push_back(middle(first));  // a disc, whose hull is its box
        cluster.plane = cluster.normal.dot(around.front());
        if (around.size() < 3) return;
        if (pieces.size() > 1 && pieces.size() < members_[cluster.wall].size()) {
            const Parallelogram frame = frame_of(wall);
            Eigen::AlignedBox2d box;
            for (const std::uint32_t piece : pieces) {
                for (const Vector3d& corner : corners(surfaces_[piece].shape)) {
                    const auto [s, t] = coordinates(frame, corner);
                    box.extend(Eigen::Vector2d(s, t));
                }
            }
            const auto [low, high] = std::pair(box.min(), box.max());
            const auto at = [&](double s, double t) -> Vector3d {
                return frame.corner + s * frame.edge_u + t * frame.edge_v;
            };
            around = {at(low.x(), low.y()), at(high.x(), low.y()), at(high.x(), high.y()), at(low.x(), high.y())};
        }
        cluster.corner_count = static_cast<std::uint8_t>(around.size());
        std::copy(around.begin(), around.end(), cluster.corners.begin());
    }

    /// Sorts pieces of a wall by place. @return how many belong to the lower half: whole rows where there are some
    [[nodiscard]] std::size_t halved(std::span<std::uint32_t> pieces, const Parallelogram& frame) const {
        constexpr double same_row = 1e-9;
        const auto place = [&](std::uint32_t piece) { return coordinates(frame, boxes_[piece].center()); };
        Eigen::AlignedBox2d middles;
        for (const std::uint32_t piece : pieces) {
            const auto [s, t] = place(piece);
            middles.extend(Eigen::Vector2d(s * frame.edge_u.norm(), t * frame.edge_v.norm()));
        }
        const std::size_t axis = middles.sizes().x() >= middles.sizes().y() ? 0 : 1;
        std::vector<std::pair<double, std::uint32_t>> order;
        for (const std::uint32_t piece : pieces) order.emplace_back(place(piece)[axis], piece);
        std::sort(order.begin(), order.end());
        for (std::size_t k = 0; k < order.size(); ++k) pieces[k] = order[k].second;
        const std::size_t middle = order.size() / 2;
        for (std::size_t off = 0; off < middle; ++off) {
            for (const std::size_t at : {middle - off, middle + off}) {
                if (at < order.size() && order[at].first - order[at - 1].first > same_row) return at;
            }
        }
        return middle;
    }
};

ClusterTree::ClusterTree(const std::vector<Surface>& surfaces, const JoinedSurfaces& walls) {
    Builder(*this, surfaces, walls);
}

}  // namespace ff
