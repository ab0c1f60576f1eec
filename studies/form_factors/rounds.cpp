#include "studies/form_factors/rounds.hpp"

#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Rate at which sound estimates are said to contradict each other, over all pairs.
constexpr double contradiction_rate = 1e-3;

std::uint64_t points_of(const SampledSum& sum) {
    std::uint64_t points = 0;
    for (const SampledSum::Term& term : sum.terms) points += term.share.points;
    return points;
}

}  // namespace

double round_level(double alpha, std::size_t round) {
    return 1 - alpha * (round == 0 ? 0.9 : 0.1 / (most_rounds - 1));
}

Rounds::Rounds(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha,
               bool rays_are_exact_enough, const PairsOfRows& rows)
    : scene_(scene),
      request_(request),
      alpha_(alpha),
      rays_are_exact_enough_(rays_are_exact_enough),
      aim_{geometry, request, round_level(alpha, 0)} {
    for (const FacePair& pair : geometry.pairs) aim_.expected.push_back((pair.known + pair.most) / 2);
    for (const auto& row : rows) sampled_ += row.second.size();
    progress_.pairs = pairs_of(geometry.faces());
    progress_.within = progress_.pairs - sampled_;
}

bool Rounds::sample(const PairsOfRows& rows, std::uint64_t budget) {
    left_ = budget;
    round_ = 0;
    progress_.round = 0;
    choosing_ = true;
    last_ = false;
    rows_.clear();
    pairs_.clear();
    work_.clear();
    earlier_.clear();
    for (const auto& [row, pairs] : rows) {
        rows_[row].row = static_cast<std::uint32_t>(row);
        for (const std::size_t pair : pairs) pairs_[pair];
    }
    bool complete = true;
    try {
        integrate_cells();
        make_pilots(rows);
        expect_budget();
        while (!work_.empty()) {
            run_round();
            evaluate();
            keep_within_budget();
        }
    } catch (const Stopped&) {
        complete = false;
        note_unfinished();
    }
    compare();
    return complete;
}

std::vector<SampledRow> Rounds::result() const {
    std::map<std::size_t, SampledRow> rows = rows_;
    for (const auto& [pair, state] : pairs_)
        rows[aim_.owner(pair)].estimates.emplace_back(static_cast<std::uint32_t>(pair), state.estimate);
    std::vector<SampledRow> result;
    for (auto& row : rows) result.push_back(std::move(row.second));
    return result;
}

/// Makes pilots by points and by rays for pairs that both methods can sample, where rays may be cheaper.
void Rounds::make_pilots(PairsOfRows rows) {
    for (auto& row : rows) std::erase_if(row.second, [&](std::size_t pair) { return pairs_[pair].done; });
    for (const auto& [pair, state] : pairs_) {
        if (!aim_.geometry.pairs[pair].by_points || state.done) continue;
        expect_more_time(request_.stop);
        work_.push_back({Job(scene_, aim_.geometry, pair, aim_.wanted(pair)), state.rounds});
    }
    const PairsOfRows shot = rows_to_shoot(scene_, aim_, rows, work_, rays_are_exact_enough_);
    if (!shot.empty() && !tracer_)
        tracer_ = request_.tracer ? request_.tracer(scene_) : make_tracer(scene_, TracerChoice::automatic);
    for (const auto& [from, pairs] : shot) {
        std::size_t rounds = 0;
        for (const std::size_t pair : pairs) rounds = std::max(rounds, pairs_[pair].rounds);
        work_.push_back({Job(scene_, aim_.geometry, from, pairs), rounds});
    }
}

std::uint64_t Rounds::planned() const {
    std::uint64_t sum = 0;
    for (const Work& work : work_) sum += work.job.samples();
    return sum;
}

/// Requires that the budget allows the smallest rounds. If it does not, but earlier rows have been sampled, these rows
/// are left unsampled. @throws UserError if nothing has been sampled yet
void Rounds::expect_budget() {
    if (2 * planned() <= left_) return;
    if (samples_ > 0) {
        work_.clear();
        return;
    }
    throw UserError(fmt::format("--max-samples {} (the smallest rounds of this scene take {}). Allow more.",
                                request_.max_samples, 2 * planned()));
}

void Rounds::begin_reporting() {
    const bool counts = std::any_of(work_.begin(), work_.end(), [](const Work& work) { return !work.pilot; });
    progress_.stage = counts ? Progress::Stage::rounds : Progress::Stage::pilots;
    if (counts) ++progress_.round;
}

/// @param done  of a round of `all` @param samples  in all rounds
void Rounds::report(std::uint64_t done, std::uint64_t all, std::uint64_t samples) {
    progress_.share = static_cast<double>(done) / static_cast<double>(all);
    progress_.samples = samples;
    request_.report(progress_);
}

/// The tasks of a round. All randomisations of a small job form one task, because they share what is made once for
/// them.
std::vector<Rounds::Task> Rounds::tasks() const {
    constexpr std::uint64_t small = 2048;
    constexpr auto all = static_cast<std::uint32_t>(randomisations);
    std::vector<Task> tasks;
    for (std::size_t w = 0; w < work_.size(); ++w) {
        const std::uint32_t count = work_[w].job.samples() <= small ? all : 1;
        for (std::uint32_t first = 0; first < all; first += count) tasks.push_back({w, first, count});
    }
    return tasks;
}

/// Of the random numbers of a round.
StreamKey Rounds::key_of(std::string_view samples) const {
    return derive_key(request_.seed,
                      fmt::format("form factors of {}, {}, round {}", scene_.canonical, samples, round_));
}

void Rounds::run_round() {
    begin_reporting();
    const std::uint64_t all = planned();
    std::uint64_t done = 0;
    const StreamKey of_points = key_of("points");
    const StreamKey of_rays = key_of("rays");
    ++round_;
    const std::vector<Task> tasks = this->tasks();
    for_each_index(tasks.size(), request_.threads, [&](std::uint64_t i) {
        const Task& task = tasks[i];
        Job& job = work_[task.work].job;
        job.run(tracer_.get(), job.by_points() ? of_points : of_rays, task.first, task.count, request_.stop);
        if (!request_.report) return;
        const std::lock_guard lock(reporting_);
        done += job.samples() / randomisations * task.count;
        report(done, all, samples_ + done);
    });
    samples_ += all;
    left_ -= std::min(all, left_);
    for (Work& work : work_) {
        work.has_run = true;
        SampledRow& row = rows_[aim_.owner(work.job.pairs().front())];
        row.samples += work.job.samples();
        if (work.job.by_points()) continue;
        row.rays += work.job.samples();
        row.lost += work.job.lost();
    }
}

void Rounds::remember(const Job& job) {
    for (const std::size_t pair : job.pairs()) {
        earlier_.push_back({pair, job.sum(pair)});
        aim_.expected[pair] = std::max(0.0, estimate_of(earlier_.back().sum, aim_.level).value);
    }
}

void Rounds::record(const Job& job, std::size_t pair, std::size_t round) {
    State& state = pairs_[pair];
    state.estimate.level = level(round);
    state.estimate.sum = job.sum(pair);
    state.estimate.method = job.by_points() ? ExchangeMethod::points : ExchangeMethod::rays;
    state.estimate.samples = points_of(*state.estimate.sum);
    state.recorded = true;
}

/// When sampling stops early, the last complete round of each pair counts, even if it was a pilot. This is sound
/// because the time that is left does not depend on what was sampled.
void Rounds::note_unfinished() {
    for (const Earlier& earlier : earlier_) {
        State& state = pairs_[earlier.pair];
        if (state.recorded) continue;
        state.estimate.sum = earlier.sum;
        state.estimate.level = level(0);
        state.estimate.method = earlier.sum.terms.front().share.hits ? ExchangeMethod::rays : ExchangeMethod::points;
        state.estimate.samples = points_of(earlier.sum);
    }
}

/// Half widths that a job has to come to; what is done already needs no more.
std::vector<double> Rounds::missing(const Job& job) {
    std::vector<double> widths = aim_.wanted(job);
    for (std::size_t k = 0; k < widths.size(); ++k) {
        if (pairs_[job.pairs()[k]].done) widths[k] = std::numeric_limits<double>::max();
    }
    return widths;
}

void Rounds::evaluate() {
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
            State& state = pairs_[pair];
            const EstimatedSum found = estimate_of(*state.estimate.sum, state.estimate.level);
            aim_.expected[pair] = std::max(0.0, found.value);
            const bool within = found.half_width() <= aim_.wanted(pair);
            if (within && !state.done) ++progress_.within;
            state.done = within || work.rounds + 1 == most_rounds || last_;
            if (!state.done) open.push_back(pair);
        }
        if (open.empty()) continue;
        ++work.rounds;
        set_next(work, missing(work.job), level(work.rounds));
        if (!work.job.by_points() && open.size() < work.job.pairs().size()) {
            Job rest(scene_, aim_.geometry, aim_.owner(open.front()), open);
            rest.set_sizes(work.job.sizes());
            work.job = std::move(rest);
            work.has_run = false;
        }
        going_on.push_back(std::move(work));
    }
    work_ = std::move(going_on);
}

/// The round that would go over the budget is made to fit, and is the last.
void Rounds::keep_within_budget() {
    if (work_.empty()) return;
    const bool has_pilots = std::any_of(work_.begin(), work_.end(), [](const Work& work) { return work.pilot; });
    if (planned() <= (has_pilots ? left_ / 4 : left_)) return;
    for (Work& work : work_) {
        if (work.pilot && work.has_run) work.job.set_sizes(work.job.sizes_for(aim_.wanted(work.job), level(0)));
    }
    for (;;) {
        const bool least = std::all_of(work_.begin(), work_.end(), [](const Work& w) { return w.job.is_least(); });
        if (planned() <= left_) break;
        if (least) {
            note_unfinished();
            work_.clear();
            return;
        }
        const auto largest = std::max_element(
            work_.begin(), work_.end(), [](const Work& a, const Work& b) { return a.job.samples() < b.job.samples(); });
        largest->job.halve();
    }
    for (Work& work : work_) work.pilot = false;
    last_ = true;
}

/// Every estimate beside those of the rounds before it. Each pair has its share of the error rate, so that what is
/// found does not depend on the others.
void Rounds::compare() {
    std::map<std::size_t, std::size_t> comparisons;
    for (const Earlier& earlier : earlier_) ++comparisons[earlier.pair];
    for (const Earlier& earlier : earlier_) {
        State& state = pairs_[earlier.pair];
        if (!state.recorded) continue;
        const double level = 1 - stats::bonferroni_level(contradiction_rate, sampled_ * comparisons[earlier.pair]) / 2;
        const EstimatedSum a = estimate_of(*state.estimate.sum, level);
        const EstimatedSum b = estimate_of(earlier.sum, level);
        // Contour integrals and traced rays agree within single precision.
        const double room = 1e-6 * aim_.geometry.areas[aim_.owner(earlier.pair)];
        if (a.value - a.down <= b.value + b.up + room && b.value - b.down <= a.value + a.up + room) continue;
        state.estimate.contradicted = true;
        state.estimate.other = b;
    }
}

}  // namespace ff::studies::form_factors
