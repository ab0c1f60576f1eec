#include "studies/heat/flow_sampling.hpp"

#include "core/points/stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace ff::studies::heat {
namespace {

constexpr std::size_t most_matrices = 4;

/// Nine tenths of the error rate for the first matrix by plan, which seldom misses.
double level_of(double level, std::size_t matrix) {
    return 1 - (1 - level) * (matrix == 1 ? 0.9 : 0.1 / (most_matrices - 1));
}

Seed seed_of(Seed seed, std::size_t matrix) {
    const StreamKey key = derive_key(seed, fmt::format("flows, matrix {}", matrix));
    return Seed{(std::uint64_t{key.word0} << 32) | key.word1};
}

/// The tolerances of a plan, for the next matrix.
void set_tolerances(form_factors::Request& request, const form_factors::Matrix& matrix,
                    std::vector<double> tolerances) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    double least = request.tolerance;
    for (std::size_t p = 0; p < matrix.exchanges.size(); ++p) {
        pairs.emplace_back(matrix.exchanges[p].from, matrix.exchanges[p].to);
        if (tolerances[p] > 0) least = std::min(least, tolerances[p]);
    }
    for (double& tolerance : tolerances) tolerance = std::max(tolerance, least);
    request.tolerance = least;
    request.tolerance_of = [pairs = std::move(pairs), tolerances = std::move(tolerances), least](std::uint32_t from,
                                                                                                 std::uint32_t to) {
        const auto wanted = std::pair(from, to);
        const auto found = std::lower_bound(pairs.begin(), pairs.end(), wanted);
        return found != pairs.end() && *found == wanted ? tolerances[static_cast<std::size_t>(found - pairs.begin())]
                                                        : least;
    };
}

/// Tolerance of the pilot: so much coarser than what is wanted that the pilot costs only a fraction.
double pilot_tolerance(const FlowTolerance& tolerance) {
    constexpr double coarsest = 0.01;
    constexpr double finest = 1e-5;
    constexpr double share = 10;
    return tolerance.is_power ? coarsest : std::clamp(share * tolerance.amount, finest, coarsest);
}

class FlowSampling {
  public:
    FlowSampling(const Scene& scene, const form_factors::Request& asked, const Materials& materials, double scale,
                 const FlowTolerance& tolerance, const FlowIntervals& intervals)
        : scene_(scene),
          asked_(asked),
          materials_(materials),
          scale_(scale),
          tolerance_(tolerance),
          intervals_(intervals),
          aim_(tolerance),
          request_(asked) {
        request_.tolerance = pilot_tolerance(tolerance);
        request_.randomisations = true;
        aim_.amount *= surplus;
    }

    SampledFlows find() {
        bool goes_on = true;
        while (goes_on) goes_on = sample() && matrices_ < most_matrices;
        if (!best_) std::rethrow_exception(unresolved_);
        best_->matrices = matrices_;
        best_->samples = samples_;
        return std::move(*best_);
    }

  private:
    /// Half widths turn out to be about half of what a plan requests: rounds are sized so that they seldom miss.
    static constexpr double surplus = 1.4;
    static constexpr double margin = 0.9;            ///< factor on the tolerance of a plan that follows a failed one
    static constexpr double least_tolerance = 1e-6;  ///< rays are traced in single precision

    const Scene& scene_;
    const form_factors::Request& asked_;
    const Materials& materials_;
    double scale_;
    FlowTolerance tolerance_;
    FlowIntervals intervals_;
    FlowTolerance aim_;  ///< of bounds, which plans are made for
    form_factors::Request request_;
    std::optional<SampledFlows> best_;
    std::exception_ptr unresolved_;  ///< why there are no flows
    std::size_t matrices_ = 0;
    std::uint64_t samples_ = 0;

    /// Samples one matrix. @return whether another one may help
    bool sample() {
        request_.level = level_of(asked_.level, matrices_);
        request_.seed = seed_of(asked_.seed, matrices_);
        request_.max_samples = asked_.max_samples - samples_;
        try {
            form_factors::Matrix matrix = form_factors::find_matrix(scene_, request_);
            samples_ += matrix.samples;
            ++matrices_;
            const bool goes_on = !keep(matrix) && !matrix.interrupted;
            if (goes_on) plan(matrix);
            return goes_on && samples_ < asked_.max_samples;
        } catch (const UserError&) {
            // No samples are left for another matrix, or it happens to be unusable: there is one already.
            if (!best_) throw;
            return false;
        }
    }

    /// @return whether its flows are known well enough
    bool keep(const form_factors::Matrix& matrix) {
        try {
            intervals_.level = request_.level;
            Flows flows = find_flows(scene_, matrix, materials_, scale_, intervals_);
            const double worst = flows.worst;
            if (matrices_ == 1 && flows.statistical && worst > 0)
                aim_.amount *= std::max(1.0, find_flows(scene_, matrix, materials_, scale_).worst / worst);
            const double wanted = tolerance_.power(flows.throughput);
            const bool enough = flows.within(tolerance_);
            if (!best_ || worst < best_->flows.worst)
                best_ = SampledFlows{matrix, std::move(flows), tolerance_, request_.tolerance};
            if (matrices_ > 1 && worst > wanted) aim_.amount *= margin * wanted / worst;
            return enough;
        } catch (const UnresolvedFlows&) {
            unresolved_ = std::current_exception();
            return false;
        }
    }

    void plan(const form_factors::Matrix& matrix) {
        auto plan = plan_flows(scene_, matrix, materials_, scale_, aim_, least_tolerance);
        if (plan && plan->even) {
            request_.tolerance = std::max(least_tolerance, plan->tolerances.front());
            request_.tolerance_of = {};
        } else if (plan) {
            set_tolerances(request_, matrix, std::move(plan->tolerances));
        } else {
            constexpr double finer = 10;
            request_.tolerance = std::max(least_tolerance, request_.tolerance / finer);
        }
    }
};

}  // namespace

SampledFlows sample_flows(const Scene& scene, const form_factors::Request& request, const Materials& materials,
                          double scale, const FlowTolerance& tolerance, const FlowIntervals& intervals) {
    return FlowSampling(scene, request, materials, scale, tolerance, intervals).find();
}

}  // namespace ff::studies::heat
