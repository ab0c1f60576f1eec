#include "studies/form_factors/choice.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace ff::studies {
namespace {

/// A pilot does not decide on a round that is larger by more than this; a larger pilot does.
constexpr std::uint64_t farthest_sight = 64;
constexpr std::uint64_t pilot_growth = 16;

/// A job takes some kilobytes.
constexpr std::size_t most_pairs_at_once = 16384;

/// Jobs by points, by their pair.
using PointJobs = std::map<std::size_t, const Job*>;

/// The pairs of a row that are left to rays.
std::vector<std::size_t> row_by_rays(const Aim& aim, const Job& rays, const PointJobs& by_points) {
    struct Candidate {
        std::size_t pair;
        std::uint64_t rays;
        double points;  ///< cost
    };
    std::vector<Candidate> free;
    std::vector<std::size_t> result;
    std::uint64_t least = 0;
    const std::vector<double> widths = aim.wanted(rays);
    for (std::size_t t = 0; t < rays.pairs().size(); ++t) {
        const std::size_t pair = rays.pairs()[t];
        const std::uint64_t needed = rays.rays_for(t, widths[t], aim.level);
        const auto other = by_points.find(pair);
        if (other == by_points.end()) {
            result.push_back(pair);
            least = std::max(least, needed);
            continue;
        }
        const Job& points = *other->second;
        free.push_back({pair, needed, points.cost(points.sizes_for({widths[t]}, aim.level))});
    }
    std::sort(free.begin(), free.end(), [](const Candidate& a, const Candidate& b) { return a.rays > b.rays; });
    double best = std::numeric_limits<double>::max();
    std::size_t best_moved = 0;
    double moved_cost = 0;
    for (std::size_t moved = 0; moved <= free.size(); ++moved) {
        const std::uint64_t size = std::max(least, moved < free.size() ? free[moved].rays : 0);
        const double cost = moved_cost + (size > 0 ? rays.cost({size}) : 0);
        if (cost < best) {
            best = cost;
            best_moved = moved;
        }
        if (moved < free.size()) moved_cost += free[moved].points;
    }
    for (std::size_t k = best_moved; k < free.size(); ++k) result.push_back(free[k].pair);
    return result;
}

/// Rays for some pairs of a row, by what the rays of all have shown.
Work part_of_row(const Scene& scene, const Aim& aim, const Job& row, const std::vector<std::size_t>& pairs) {
    std::uint64_t size = 0;
    for (std::size_t t = 0; t < row.pairs().size(); ++t) {
        const std::size_t pair = row.pairs()[t];
        if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) continue;
        size = std::max(size, row.rays_for(t, aim.wanted(pair), aim.level));
    }
    Work work{Job(scene, aim.geometry, aim.owner(pairs.front()), pairs)};
    const std::uint64_t now = work.job.sizes().front();
    work.pilot = size / farthest_sight > now;
    work.job.set_sizes({work.pilot ? now * pilot_growth : std::max(size, now)});
    return work;
}

}  // namespace

std::size_t Aim::owner(std::size_t pair) const {
    const FacePair& faces = geometry.pairs[pair];
    return geometry.areas[faces.to] < geometry.areas[faces.from] ? faces.to : faces.from;
}

double Aim::wanted(std::size_t pair) const {
    return tolerance * geometry.areas[owner(pair)] - geometry.pairs[pair].bound;
}

std::vector<double> Aim::wanted(const Job& job) const {
    std::vector<double> result;
    for (const std::size_t pair : job.pairs()) result.push_back(wanted(pair));
    return result;
}

std::vector<std::vector<std::size_t>> batches(const Aim& aim) {
    const FacePairs& geometry = aim.geometry;
    std::vector<std::vector<std::size_t>> rows(geometry.faces());
    for (std::size_t pair = 0; pair < geometry.pairs.size(); ++pair) {
        if (geometry.pairs[pair].is_sampled()) rows[aim.owner(pair)].push_back(pair);
    }
    std::vector<std::vector<std::size_t>> result(1);
    for (const std::vector<std::size_t>& row : rows) {
        if (result.back().size() >= most_pairs_at_once) result.emplace_back();
        result.back().insert(result.back().end(), row.begin(), row.end());
    }
    for (auto& batch : result) std::sort(batch.begin(), batch.end());
    return result;
}

void set_next(Work& work, const std::vector<double>& wanted, double level) {
    std::vector<std::uint64_t> sizes = work.job.sizes_for(wanted, level);
    const std::vector<std::uint64_t>& now = work.job.sizes();
    bool far = false;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        far = far || sizes[k] / farthest_sight > now[k];
        if (!work.pilot) sizes[k] = std::max(sizes[k], 2 * now[k]);
    }
    work.pilot = work.pilot && far;
    if (work.pilot) {
        for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = std::min(sizes[k], now[k] * pilot_growth);
    }
    work.job.set_sizes(std::move(sizes));
}

std::vector<Work> choose_methods(const Scene& scene, const Aim& aim, std::vector<Work> candidates) {
    PointJobs by_points;
    for (const Work& work : candidates) {
        if (work.job.by_points()) by_points[work.job.pairs().front()] = &work.job;
    }
    std::vector<Work> chosen;
    std::vector<bool> stays(candidates.size(), true);
    std::vector<std::size_t> shot;  // pairs that points could do
    for (std::size_t w = 0; w < candidates.size(); ++w) {
        const Job& rays = candidates[w].job;
        if (rays.by_points()) continue;
        const std::vector<std::size_t> pairs = row_by_rays(aim, rays, by_points);
        stays[w] = pairs.size() == rays.pairs().size();
        if (!stays[w] && !pairs.empty()) chosen.push_back(part_of_row(scene, aim, rays, pairs));
        shot.insert(shot.end(), pairs.begin(), pairs.end());
    }
    for (std::size_t w = 0; w < candidates.size(); ++w) {
        const Job& job = candidates[w].job;
        if (job.by_points()) stays[w] = std::find(shot.begin(), shot.end(), job.pairs().front()) == shot.end();
        if (!stays[w]) continue;
        set_next(candidates[w], aim.wanted(job), aim.level);
        chosen.push_back(std::move(candidates[w]));
    }
    return chosen;
}

}  // namespace ff::studies
