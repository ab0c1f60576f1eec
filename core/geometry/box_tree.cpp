#include "core/geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ff {
namespace {

constexpr std::uint32_t most_in_leaf = 2;

}  // namespace

BoxTree::BoxTree(std::vector<Eigen::AlignedBox3d> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
}

void BoxTree::build(std::uint32_t first, std::uint32_t end) {
    const auto at = static_cast<std::uint32_t>(nodes_.size());
    Node node;
    Eigen::AlignedBox3d centres;
    for (std::uint32_t i = first; i < end; ++i) {
        node.box.extend(boxes_[order_[i]]);
        centres.extend(boxes_[order_[i]].center());
    }
    const bool is_leaf = end - first <= most_in_leaf;
    node.first = first;
    node.count = is_leaf ? end - first : 0;
    nodes_.push_back(node);
    if (is_leaf) return;
    Eigen::Index axis = 0;
    centres.sizes().maxCoeff(&axis);
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return std::pair(boxes_[a].center()[axis], a) < std::pair(boxes_[b].center()[axis], b);
                     });
    build(first, middle);
    nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end);
}

}  // namespace ff
