#include "studies/form_factors/choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// A pilot does not decide on a round that is larger by more than this; a larger pilot does.
constexpr std::uint64_t farthest_sight = 64;
constexpr std::uint64_t pilot_growth = 16;

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
Work part_of_row(const Scene& scene, const Aim& aim, const Work& whole, const std::vector<std::size_t>& pairs) {
    const Job& row = whole.job;
    std::uint64_t size = 0;
    for (std::size_t t = 0; t < row.pairs().size(); ++t) {
        const std::size_t pair = row.pairs()[t];
        if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) continue;
        size = std::max(size, row.rays_for(t, aim.wanted(pair), aim.level));
    }
    Work work{Job(scene, aim.geometry, aim.owner(pairs.front()), pairs), whole.rounds};
    const std::uint64_t now = work.job.sizes().front();
    work.pilot = size / farthest_sight > now;
    work.job.set_sizes({work.pilot ? now * pilot_growth : std::max(size, now)});
    return work;
}

/// Rays that a pair is likely to take: as many as show that less than the tolerance hits, and no less than a pilot and
/// a round.
double expected_rays(const Aim& aim, std::size_t pair) {
    constexpr double gain = 10;  // over independent rays, measured: docs/convergence.md
    const double area = aim.geometry.areas[aim.owner(pair)];
    const double width = aim.wanted(pair) / area;
    return std::max({2.0 * randomisations * least_rays, std::log(2 / (1 - aim.level)) / width,
                     aim.geometry.pairs[pair].most / area / (width * width) / gain});
}

}  // namespace

std::size_t owner_of(const FacePairs& geometry, std::size_t pair) {
    const FacePair& faces = geometry.pairs[pair];
    return geometry.areas[faces.to] < geometry.areas[faces.from] ? faces.to : faces.from;
}

PairsOfRows pairs_to_sample(const FacePairs& geometry) {
    PairsOfRows rows;
    for (std::size_t pair = 0; pair < geometry.pairs.size(); ++pair) rows[owner_of(geometry, pair)].push_back(pair);
    return rows;
}

double Aim::wanted(std::size_t pair, double exchange) const {
    const FacePair& faces = geometry.pairs[pair];
    const double tolerance = request.tolerance_between(faces.from, faces.to) * geometry.areas[owner(pair)];
    return std::max(tolerance, request.relative * exchange) - faces.bound;
}

std::vector<double> Aim::wanted(const Job& job) const {
    std::vector<double> result;
    for (const std::size_t pair : job.pairs()) result.push_back(wanted(pair));
    return result;
}

PairsOfRows rows_to_shoot(const Scene& scene, const Aim& aim, const PairsOfRows& rows,
                          const std::vector<Work>& by_points, bool are_exact_enough) {
    constexpr double rounds_of_points = 4;  // the later ones are larger than the first
    std::map<std::size_t, double> cost_of_points;
    for (const Work& work : by_points)
        cost_of_points[aim.owner(work.job.pairs().front())] += rounds_of_points * work.job.cost();
    PairsOfRows result;
    for (const auto& [from, pairs] : rows) {
        bool needs_rays = false;
        double rays = 0;
        std::vector<std::size_t> row;
        for (const std::size_t pair : pairs) {
            const bool needs = !aim.geometry.pairs[pair].by_points;
            if (!needs && !are_exact_enough) continue;
            row.push_back(pair);
            needs_rays = needs_rays || needs;
            rays = std::max(rays, expected_rays(aim, pair));
        }
        const bool tried =
            needs_rays || aim.geometry.effort == PointEffort::full || rays * cost_of_ray(scene) < cost_of_points[from];
        if (!row.empty() && tried) result[from] = std::move(row);
    }
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
        if (!stays[w] && !pairs.empty()) chosen.push_back(part_of_row(scene, aim, candidates[w], pairs));
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

}  // namespace ff::studies::form_factors
