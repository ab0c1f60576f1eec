#include "studies/form_factors/rounds.hpp"

#include "core/support/error.hpp"
#include "core/tracing/tracer.hpp"
#include "stats/multiplicity.hpp"
#include "studies/form_factors/choice.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>

namespace ff::studies {
namespace {

/// Rate at which sound estimates are said to contradict each other, over all pairs.
constexpr double contradiction_rate = 1e-3;

/// An earlier estimate of a pair, for comparison.
struct Earlier {
    std::size_t pair = 0;
    SampledSum sum;
};

class Rounds {
  public:
    Rounds(const Scene& scene, const FacePairs& geometry, const FormFactorRequest& request, double alpha)
        : scene_(scene),
          geometry_(geometry),
          request_(request),
          alpha_(alpha),
          aim_{geometry, request.tolerance, round_level(alpha, 0)} {
        outcome_.estimates.resize(geometry.pairs.size());
        progress_.pairs = pairs_of(geometry.faces());
        progress_.within = progress_.pairs - static_cast<std::size_t>(
                                                 std::count_if(geometry.pairs.begin(), geometry.pairs.end(),
                                                               [](const FacePair& pair) { return pair.is_sampled(); }));
    }

    SamplingOutcome find(bool rays_are_exact_enough) {
        try {
            for (const std::vector<std::size_t>& pairs : batches(aim_)) {
                round_ = 0;
                choosing_ = true;
                last_ = false;
                make_pilots(pairs, rays_are_exact_enough);
                expect_budget();
                while (!work_.empty()) {
                    run_round();
                    evaluate();
                    keep_within_budget();
                }
            }
        } catch (const Stopped&) {
            outcome_.interrupted = true;
            note_unfinished();
        }
        compare();
        return std::move(outcome_);
    }

  private:
    const Scene& scene_;
    const FacePairs& geometry_;
    const FormFactorRequest& request_;
    double alpha_;
    Aim aim_;
    std::unique_ptr<Tracer> tracer_;
    std::vector<Work> work_;
    std::vector<Earlier> earlier_;
    std::vector<bool> done_ = std::vector<bool>(geometry_.pairs.size(), false);
    std::vector<bool> recorded_ = done_;  ///< the estimate is of a round that counts
    std::size_t round_ = 0;
    bool choosing_ = true;  ///< the first round is that of all candidates
    bool last_ = false;     ///< the budget ends with this round
    SamplingOutcome outcome_;
    FormFactorProgress progress_;
    std::mutex reporting_;

    void add_rays(const std::map<std::size_t, std::vector<std::size_t>>& rows) {
        if (rows.empty()) return;
        if (!tracer_)
            tracer_ = request_.tracer ? request_.tracer(scene_) : make_tracer(scene_, TracerChoice::automatic);
        for (const auto& [from, pairs] : rows) work_.push_back({Job(scene_, geometry_, from, pairs)});
    }

    /// Rays that the pairs of a row are likely to take: of none of them less than none may hit.
    [[nodiscard]] double expected_rays(std::size_t pair) const {
        constexpr double gain = 10;  // over independent rays, measured: docs/convergence.md
        const FacePair& faces = geometry_.pairs[pair];
        const double area = geometry_.areas[aim_.owner(pair)];
        const double width = aim_.wanted(pair) / area;
        return std::max(std::log(2 / (1 - aim_.level)) / width, faces.most / area / (width * width) / gain);
    }

    /// Both for pairs that both can do; of many pairs not where points are expected to be cheaper for a whole row.
    void make_pilots(const std::vector<std::size_t>& pairs, bool rays_are_exact_enough) {
        struct Row {
            std::vector<std::size_t> pairs;
            bool needs_rays = false;
            double rays = 0;
            double points = 0;
        };
        constexpr double rounds_of_points = 8;  // the later ones are larger than the first
        std::map<std::size_t, Row> rows;
        for (const std::size_t pair : pairs) {
            const FacePair& faces = geometry_.pairs[pair];
            Row& row = rows[aim_.owner(pair)];
            row.needs_rays = row.needs_rays || !faces.by_points;
            if (faces.by_points) {
                expect_more_time(request_.stop);
                work_.push_back({Job(scene_, geometry_, pair, aim_.wanted(pair))});
                row.points += rounds_of_points * work_.back().job.cost();
            }
            if (!faces.by_points || rays_are_exact_enough) {
                row.pairs.push_back(pair);
                row.rays = std::max(row.rays, expected_rays(pair));
            }
        }
        std::map<std::size_t, std::vector<std::size_t>> shot;
        for (auto& [from, row] : rows) {
            const bool tried = row.needs_rays || geometry_.effort == PointEffort::full || row.rays < row.points;
            if (!row.pairs.empty() && tried) shot[from] = std::move(row.pairs);
        }
        add_rays(shot);
    }

    [[nodiscard]] std::uint64_t planned() const {
        std::uint64_t sum = 0;
        for (const Work& work : work_) sum += work.job.samples();
        return sum;
    }

    [[nodiscard]] std::uint64_t left() const {
        return request_.max_samples > outcome_.samples ? request_.max_samples - outcome_.samples : 0;
    }

    /// Of later batches nothing is sampled where not even that is left.
    void expect_budget() {
        if (2 * planned() <= left()) return;
        if (outcome_.samples > 0) {
            work_.clear();
            return;
        }
        throw UserError(fmt::format("--max-samples {} (the smallest rounds of this scene take {}). Allow more.",
                                    request_.max_samples, 2 * planned()));
    }

    void begin_reporting() {
        const bool counts = std::any_of(work_.begin(), work_.end(), [](const Work& work) { return !work.pilot; });
        progress_.stage = counts ? FormFactorProgress::Stage::rounds : FormFactorProgress::Stage::pilots;
        if (counts) ++progress_.round;
    }

    /// @param done  samples of this round; of a round of `all`
    void report(std::uint64_t done, std::uint64_t all) {
        if (!request_.report) return;
        progress_.share = static_cast<double>(done) / static_cast<double>(all);
        progress_.samples = outcome_.samples + done;
        request_.report(progress_);
    }

    void run_round() {
        begin_reporting();
        const std::uint64_t all = planned();
        std::uint64_t done = 0;
        const auto key_of = [&](const char* samples) {
            return derive_key(request_.seed,
                              fmt::format("form factors of {}, {}, round {}", scene_.canonical, samples, round_));
        };
        const StreamKey of_points = key_of("points");
        const StreamKey of_rays = key_of("rays");
        ++round_;
        const std::size_t jobs = work_.size();
        for_each_index(jobs * randomisations, request_.threads, [&](std::uint64_t i) {
            Job& job = work_[i % jobs].job;
            job.run(tracer_.get(), job.by_points() ? of_points : of_rays, static_cast<std::uint32_t>(i / jobs),
                    request_.stop);
            const std::lock_guard lock(reporting_);
            done += job.samples() / randomisations;
            report(done, all);
        });
        outcome_.samples += all;
        for (Work& work : work_) {
            work.has_run = true;
            if (work.job.by_points()) continue;
            outcome_.rays += work.job.samples();
            outcome_.lost += work.job.lost();
        }
    }

    void remember(const Job& job) {
        for (const std::size_t pair : job.pairs()) earlier_.push_back({pair, job.sum(pair)});
    }

    void record(const Job& job, std::size_t pair, std::size_t round) {
        PairEstimate& estimate = outcome_.estimates[pair];
        estimate.level = level(round);
        estimate.sum = job.sum(pair);
        estimate.by_points = job.by_points();
        estimate.samples = points_of(*estimate.sum);
        recorded_[pair] = true;
    }

    static std::uint64_t points_of(const SampledSum& sum) {
        std::uint64_t points = 0;
        for (const SampledSum::Term& term : sum.terms) points += term.share.points;
        return points;
    }

    /// Of a stopped run the last complete round of each pair counts, were it a pilot: what time is left is no matter of
    /// what the samples were.
    void note_unfinished() {
        for (const Earlier& earlier : earlier_) {
            if (recorded_[earlier.pair]) continue;
            PairEstimate& estimate = outcome_.estimates[earlier.pair];
            estimate.sum = earlier.sum;
            estimate.level = level(0);
            estimate.by_points = !earlier.sum.terms.front().share.hits;
            estimate.samples = points_of(earlier.sum);
        }
    }

    [[nodiscard]] double level(std::size_t rounds_done) const { return round_level(alpha_, rounds_done); }

    /// Half widths that a job has to come to; what is done already needs no more.
    [[nodiscard]] std::vector<double> missing(const Job& job) const {
        std::vector<double> widths = aim_.wanted(job);
        for (std::size_t k = 0; k < widths.size(); ++k) {
            if (done_[job.pairs()[k]]) widths[k] = std::numeric_limits<double>::max();
        }
        return widths;
    }

    void evaluate() {
        if (choosing_) {
            for (Work& work : work_) {
                work.job.choose_sides();
                remember(work.job);
            }
            work_ = choose_methods(scene_, aim_, std::move(work_));
            choosing_ = false;
            return;
        }
        std::vector<Work> going_on;
        for (Work& work : work_) {
            if (work.pilot) {
                work.job.choose_sides();
                remember(work.job);
                set_next(work, missing(work.job), level(work.rounds));
                going_on.push_back(std::move(work));
                continue;
            }
            std::vector<std::size_t> open;
            for (const std::size_t pair : work.job.pairs()) {
                record(work.job, pair, work.rounds);
                const PairEstimate& estimate = outcome_.estimates[pair];
                const double half_width = estimate_of(*estimate.sum, estimate.level).half_width();
                const bool within = half_width <= aim_.wanted(pair);
                if (within && !done_[pair]) ++progress_.within;
                done_[pair] = within || work.rounds + 1 == most_rounds || last_;
                if (!done_[pair]) open.push_back(pair);
            }
            if (open.empty()) continue;
            ++work.rounds;
            set_next(work, missing(work.job), level(work.rounds));
            if (!work.job.by_points() && open.size() < work.job.pairs().size()) {
                Job rest(scene_, geometry_, aim_.owner(open.front()), open);
                rest.set_sizes(work.job.sizes());
                work.job = std::move(rest);
                work.has_run = false;
            }
            going_on.push_back(std::move(work));
        }
        work_ = std::move(going_on);
    }

    /// The round that would go over the budget is made to fit, and is the last.
    void keep_within_budget() {
        if (work_.empty()) return;
        const std::uint64_t left = this->left();
        const bool has_pilots = std::any_of(work_.begin(), work_.end(), [](const Work& work) { return work.pilot; });
        if (planned() <= (has_pilots ? left / 4 : left)) return;
        for (Work& work : work_) {
            if (work.pilot && work.has_run) work.job.set_sizes(work.job.sizes_for(aim_.wanted(work.job), level(0)));
        }
        for (;;) {
            const bool least = std::all_of(work_.begin(), work_.end(), [](const Work& w) { return w.job.is_least(); });
            if (planned() <= left) break;
            if (least) {
                note_unfinished();
                work_.clear();
                return;
            }
            const auto largest = std::max_element(work_.begin(), work_.end(), [](const Work& a, const Work& b) {
                return a.job.samples() < b.job.samples();
            });
            largest->job.halve();
        }
        for (Work& work : work_) work.pilot = false;
        last_ = true;
    }

    /// Every estimate beside those of the rounds before it.
    void compare() {
        if (earlier_.empty()) return;
        const double level = 1 - stats::bonferroni_level(contradiction_rate, earlier_.size()) / 2;
        for (const Earlier& earlier : earlier_) {
            PairEstimate& estimate = outcome_.estimates[earlier.pair];
            if (!recorded_[earlier.pair]) continue;
            const Estimate a = estimate_of(*estimate.sum, level);
            const Estimate b = estimate_of(earlier.sum, level);
            // Contour integrals and traced rays agree within single precision.
            const double room = 1e-6 * geometry_.areas[aim_.owner(earlier.pair)];
            if (a.value - a.down <= b.value + b.up + room && b.value - b.down <= a.value + a.up + room) continue;
            estimate.contradicted = true;
            estimate.other = b;
        }
    }
};

}  // namespace

double round_level(double alpha, std::size_t round) {
    return 1 - alpha * (round == 0 ? 0.9 : 0.1 / (most_rounds - 1));
}

SamplingOutcome sample_pairs(const Scene& scene, const FacePairs& geometry, const FormFactorRequest& request,
                             double alpha, bool rays_are_exact_enough) {
    return Rounds(scene, geometry, request, alpha).find(rays_are_exact_enough);
}

}  // namespace ff::studies
