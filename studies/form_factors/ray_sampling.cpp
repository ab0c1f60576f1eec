#include "studies/form_factors/ray_sampling.hpp"

#include "samplers/sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace ff::studies::form_factors {
namespace {

constexpr std::uint32_t not_wanted = std::numeric_limits<std::uint32_t>::max();

}  // namespace

bool RaySampling::is_shot(std::uint32_t from, std::uint32_t to) const {
    if (pairs_->shot.empty()) return true;
    const std::vector<std::uint32_t>& others = pairs_->shot[from];
    return std::binary_search(others.begin(), others.end(), to);
}

std::vector<std::uint32_t> RaySampling::targets_of_faces() const {
    std::vector<std::uint32_t> result(scene_->faces.size(), not_wanted);
    for (std::size_t t = 0; t < targets_.size(); ++t) result[targets_[t]] = static_cast<std::uint32_t>(t);
    return result;
}

RaySampling::RaySampling(const Scene& scene, const FacePairs& pairs, std::size_t from, std::vector<std::size_t> targets)
    : scene_(&scene), pairs_(&pairs), from_(from), targets_(std::move(targets)) {
    const std::vector<std::uint32_t> target_of_face = targets_of_faces();
    const auto n = static_cast<std::uint32_t>(scene.surfaces.size());
    const auto is_wanted = [&](std::uint32_t surface) {
        const int face = scene.surfaces[surface].face;
        return face != no_face && target_of_face[static_cast<std::size_t>(face)] != not_wanted;
    };
    for (std::uint32_t s = 0; s < n; ++s) {
        if (scene.surfaces[s].face != static_cast<int>(from)) continue;
        bool counts = pairs.shot.empty();
        if (!counts) counts = std::any_of(pairs.shot[s].begin(), pairs.shot[s].end(), is_wanted);
        if (!counts) continue;
        sources_.push_back({s, 0});
        source_area_ += area(scene.surfaces[s].shape);
    }
    double before = 0;
    for (Source& source : sources_) {
        source.first = static_cast<std::uint64_t>(before / source_area_ * 0x1p32);
        before += area(scene.surfaces[source.surface].shape);
    }
    sources_.push_back({no_surface, std::uint64_t{1} << 32});
}

RaySampling::Hits RaySampling::run(const Tracer& tracer, StreamKey key, std::uint32_t randomisation, std::uint64_t rays,
                                   const std::atomic<bool>* stop) const {
    const auto sampler = samplers::house_sampler().make({.points = rays, .dimension = 4});
    const Stream stream{.key = key, .trial = randomisation, .source = static_cast<std::uint32_t>(from_)};
    const auto block = std::make_unique<PointBlock>();
    const auto part = std::make_unique<PointBlock>();
    const std::vector<std::uint32_t> target_of_face = targets_of_faces();
    std::vector<Hit> found(block_capacity);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // source, point
    Hits result{std::vector<std::uint64_t>(targets_.size()), 0};

    const auto shoot = [&](std::uint32_t surface, const PointBlock& points) {
        const std::span<Hit> hits(found.data(), points.size);
        tracer.find_ends(scene_->surfaces[surface], surface, undivided, 0, points, hits);
        for (const Hit& hit : hits) {
            if (hit.surface == no_surface) {
                ++result.lost;
            } else if (hit.received && is_shot(surface, hit.surface)) {
                const auto face = static_cast<std::size_t>(scene_->surfaces[hit.surface].face);
                if (target_of_face[face] != not_wanted) ++result.hits[target_of_face[face]];
            }
        }
    };
    for (std::uint64_t first = 0; first < rays; first += block->size) {
        expect_more_time(stop);
        block->size = static_cast<std::size_t>(std::min<std::uint64_t>(block_capacity, rays - first));
        sampler->fill(stream, first, *block);
        if (sources_.size() == 2) {
            shoot(sources_.front().surface, *block);
            continue;
        }
        order.clear();
        for (std::uint32_t i = 0; i < block->size; ++i) {
            const auto after = std::upper_bound(sources_.begin(), sources_.end(), block->coordinate[0][i],
                                                [](std::uint64_t u, const Source& s) { return u < s.first; });
            order.emplace_back(static_cast<std::uint32_t>(after - sources_.begin() - 1), i);
        }
        std::sort(order.begin(), order.end());
        for (std::size_t begin = 0; begin < order.size();) {
            const std::uint32_t source = order[begin].first;
            const std::uint64_t low = sources_[source].first;
            const std::uint64_t share = sources_[source + 1].first - low;
            part->size = 0;
            std::size_t at = begin;
            for (; at < order.size() && order[at].first == source; ++at) {
                const std::uint32_t i = order[at].second;
                // Stretched over [0, 1); what lies below the last bit is its middle.
                part->coordinate[0][part->size] = static_cast<std::uint32_t>(
                    (((block->coordinate[0][i] - low) << 32) + (std::uint64_t{1} << 31)) / share);
                for (std::size_t d = 1; d < 4; ++d) part->coordinate[d][part->size] = block->coordinate[d][i];
                ++part->size;
            }
            shoot(sources_[source].surface, *part);
            begin = at;
        }
    }
    return result;
}

}  // namespace ff::studies::form_factors
