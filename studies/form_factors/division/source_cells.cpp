#include "studies/form_factors/division/source_cells.hpp"

#include <algorithm>
#include <cmath>

namespace ff::studies::form_factors {

double power_of_unmet(bool curved) {
    return curved ? 1.25 : 1.5;
}

double smooth_unmet(const SourceCell& cell, double share, bool curved) {
    return cell.area * cell.change * (curved ? 8.0 / 15 : 1.0 / 3) / std::pow(share, power_of_unmet(curved));
}

SourceRange SourceRange::half(bool along_s, bool upper) const {
    SourceRange result = *this;
    double& low = along_s ? result.s0 : result.t0;
    double& high = along_s ? result.s1 : result.t1;
    (upper ? low : high) = middle(along_s);
    return result;
}

const SourceCell* SourceCells::at(double s, double t) const {
    const Node* node = nodes.data();
    while (node->halves != 0) {
        // Halves of [0, 1) are told apart by the next binary digit.
        double& x = node->along_s ? s : t;
        x *= 2;
        const bool upper = x >= 1;
        x -= upper ? 1 : 0;
        node = &nodes[node->halves + (upper ? 1 : 0)];
    }
    return node->cell < 0 ? nullptr : &mixed[static_cast<std::size_t>(node->cell)];
}

UnmetBound unmet(const SourceCells& cells, bool hidden) {
    UnmetBound result{.rough = 0, .smooth = 0, .power = power_of_unmet(cells.curved)};
    for (const SourceCell& cell : cells.mixed) {
        const double most = cell.area / cell.share * std::min(cell.change, hidden ? cell.most_hidden : cell.most_whole);
        const double smooth = smooth_unmet(cell, cell.share, cells.curved);
        if (smooth * std::pow(cells.due, result.power - 1) < most)
            result.smooth = std::max(result.smooth, smooth);
        else
            result.rough = std::max(result.rough, most);
    }
    return result;
}

}  // namespace ff::studies::form_factors
