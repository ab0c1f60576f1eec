#include "studies/form_factors/cells/cell_factors.hpp"

#include "core/geometry/surface_map.hpp"

#include <utility>

namespace ff::studies::form_factors {

using Eigen::Vector2d;
using Eigen::Vector3d;

CellFactors::CellFactors(const CellPair& pair)
    : source_(pair.source),
      origin_(middle(pair.source)),
      target_(pair.target, pair.exchange.blockers, pair.source_end) {
    if (!is_polygon(source_.shape)) round_.emplace(source_);
}

std::span<const Factors> CellFactors::at(const Cell& cell, std::span<const Vector2d> places, bool some) {
    evaluations_ += places.size();
    seen_.resize(places.size());
    if (round_) {
        for (std::size_t k = 0; k < places.size(); ++k) {
            const SurfacePoint place = round_->at(cell.shape.at(places[k]));
            seen_[k] = target_.from(place.position, place.normal, cell.blockers);
        }
    } else {
        positions_.clear();
        for (const Vector2d& uv : places) positions_.emplace_back(origin_ + cell.shape.at(uv));
        if (some)
            target_.find(positions_, source_.normal, cell.blockers, seen_);
        else
            target_.find(positions_, source_.normal, seen_);
    }
    factors_.clear();
    for (const VisiblePolygon::Factors& seen : seen_) factors_.push_back({seen.visible, seen.whole - seen.visible});
    return factors_;
}

double CellFactors::area_at(const Cell& cell, const Vector2d& uv) const {
    return cell.shape.stretch(uv) * round_stretch(cell, uv);
}

CellFactors::RandomPlace CellFactors::random_place(const Cell& cell, const Vector2d& xy) const {
    const auto [uv, area] = cell.shape.random_place(xy);
    return {uv, area * round_stretch(cell, uv)};
}

void CellFactors::bound(Cell& cell, const PartBounds& bounds, std::span<const std::uint32_t> blockers) const {
    PartBounds::Bounds found = bounds.of(round_ ? round_->extent(cell.shape, origin_) : cell.shape.extent(), blockers);
    const double area = cell.shape.most_area() * (round_ ? round_->most_stretch(cell.shape) : 1);
    cell.blockers = std::move(found.blockers);
    cell.jumps = {area * found.visible, area * found.hidden};
    cell.change = area * found.change / 3;
}

}  // namespace ff::studies::form_factors
