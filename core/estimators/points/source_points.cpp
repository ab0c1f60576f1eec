#include "core/estimators/points/source_points.hpp"

#include "core/support/contract.hpp"
#include "core/visibility/mirrors.hpp"

#include <algorithm>
#include <memory>
#include <vector>

namespace ff {

Eigen::MatrixXd average_over_sources(const Scene& scene, const EstimatorTask& task, std::size_t dimension,
                                     const SourceSum& sum) {
    FF_EXPECT(task.options.allocation == Allocation::patch || task.points->equal_weights());
    const auto faces = static_cast<Eigen::Index>(scene.faces.size());
    const PatchSequences sequences(scene, task.subdivision, task.options.allocation, task.samples);
    const auto block = std::make_unique_for_overwrite<WeightedBlock>();
    block->dimension = dimension;

    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(faces, faces);
    std::vector<double> sums(scene.surfaces.size());
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& source = scene.surfaces[s];
        if (!is_of_face(source)) continue;
        std::fill(sums.begin(), sums.end(), 0.0);
        const Grid grid = task.subdivision.of(source);
        for (std::uint32_t p = 0; p < grid.parts(); ++p) {
            const auto [of_stream, first] = sequences.of(s, p);
            const Stream stream{.key = task.key, .trial = task.trial, .source = of_stream};
            for_each_block(*task.points, stream, first, task.samples, *block, [&](PointIndex) {
                sum({s, grid, p}, *block, sums);
            });
        }
        // The weights of a sequence add up to 1, whether it serves a patch or several.
        const double share = area(source.shape) / face_area(scene, source.face) / sequences.count(s);
        for (std::size_t t = 0; t < sums.size(); ++t) {
            if (is_of_face(scene.surfaces[t])) result(source.face, scene.surfaces[t].face) += share * sums[t];
        }
    }
    return result;
}

}  // namespace ff
