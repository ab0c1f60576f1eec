#include "studies/form_factors/rounds.hpp"

#include "core/support/error.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace ff::studies::form_factors {
namespace {

/// Rate at which sound estimates are said to contradict each other, over all pairs.
constexpr double contradiction_rate = 1e-3;

/// A pilot does not decide on a round that is larger than itself by more than this factor; a larger pilot does.
constexpr std::uint64_t farthest_sight = 64;
constexpr std::uint64_t pilot_growth = 16;

/// Least and largest number of evaluations for two surfaces: at most some seconds.
constexpr std::uint64_t least_evaluations = 256;
constexpr std::uint64_t most_evaluations = std::uint64_t{1} << 22;

}  // namespace

double round_level(double alpha, std::size_t round) {
    return 1 - alpha * (round == 0 ? 0.9 : 0.1 / (most_rounds - 1));
}

Rounds::Rounds(const Scene& scene, const FacePairs& geometry, const Request& request, double alpha,
               const PairsOfRows& rows)
    : scene_(scene), request_(request), alpha_(alpha), geometry_(geometry) {
    for (const FacePair& pair : geometry.pairs) expected_.push_back((pair.known + pair.most) / 2);
    for (const auto& row : rows) sampled_ += row.second.size();
    progress_.pairs = pairs_of(geometry.faces());
    progress_.within = progress_.pairs - sampled_;
}

bool Rounds::sample(const PairsOfRows& rows, std::uint64_t budget) {
    left_ = budget;
    round_ = 0;
    progress_.round = 0;
    last_ = false;
    rows_.clear();
    pairs_.clear();
    work_.clear();
    earlier_.clear();
    for (const auto& [row, pairs] : rows) {
        rows_[row].row = static_cast<std::uint32_t>(row);
        std::vector<std::size_t> by_rays;
        for (const std::size_t pair : pairs) {
            pairs_[pair];
            if (!is_by_cells(pair)) by_rays.push_back(pair);
        }
        if (!by_rays.empty()) work_.push_back({RowByRays(scene_, geometry_, row, std::move(by_rays))});
    }
    bool complete = true;
    try {
        integrate_cells();
        shoot_rays();
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
        rows[geometry_.owner(pair)].estimates.emplace_back(static_cast<std::uint32_t>(pair), state.estimate);
    std::vector<SampledRow> result;
    for (auto& row : rows) result.push_back(std::move(row.second));
    return result;
}

bool Rounds::is_by_cells(std::size_t pair) const {
    return request_.cells && geometry_.pairs[pair].by_cells;
}

/// The half width that a pair is to stay below, if its exchange area is as large as expected.
double Rounds::wanted(std::size_t pair) const {
    const FacePair& faces = geometry_.pairs[pair];
    const double tolerance = request_.tolerance_between(faces.from, faces.to) * geometry_.areas[geometry_.owner(pair)];
    const double width = std::max(tolerance, request_.relative * expected_[pair]);
    constexpr double least = 0.1;  // nothing comes near it where bounds are as wide
    return std::max(least * width, width - faces.bound);
}

/// The key of the random numbers of a round.
StreamKey Rounds::key_of(std::string_view samples) const {
    return derive_key(request_.seed,
                      fmt::format("form factors of {}, {}, round {}", scene_.canonical, samples, round_));
}

/// Whether the budget allows the smallest rounds. If it does not, but earlier rows have been sampled, these rows are
/// left unsampled. @throws UserError if nothing has been sampled yet
bool Rounds::allows(std::uint64_t least) const {
    if (least <= left_) return true;
    if (samples_ > 0) return false;
    throw UserError("--max-samples {} (the smallest rounds of this scene take {}). Allow more.", request_.max_samples,
                    least);
}

std::uint64_t Rounds::planned() const {
    std::uint64_t sum = 0;
    for (const Work& work : work_) sum += work.row.samples();
    return sum;
}

/// Integrates pairs cell by cell where that is possible, in rounds of their own.
void Rounds::integrate_cells() {
    constexpr double finer = 0.4;
    std::vector<std::size_t> pairs;
    for (const auto& entry : pairs_) {
        if (is_by_cells(entry.first)) pairs.push_back(entry.first);
    }
    const bool shares_budget = !work_.empty();
    for (std::size_t round = 0; round < most_rounds && !pairs.empty(); ++round) {
        const auto surfaces_of = [&](std::size_t pair) { return std::size_t{geometry_.pairs[pair].count}; };
        std::uint64_t surfaces = 0;  // pairs of them
        for (const std::size_t pair : pairs) surfaces += surfaces_of(pair);
        if (!allows(least_evaluations * surfaces * (shares_budget ? 2 : 1))) return;
        const std::uint64_t most =
            std::min(left_ / (shares_budget ? 2 : 1) / std::max<std::uint64_t>(1, surfaces), most_evaluations);
        progress_.stage = Progress::Stage::rounds;
        progress_.round = round + 1;
        std::size_t done = 0;
        std::vector<std::optional<CellSum>> found(pairs.size());
        const StreamKey key = key_of(fmt::format("cells {}", round + 1));
        for_each_index(pairs.size(), request_.threads, [&](std::uint64_t i) {
            if (request_.stop != nullptr && *request_.stop) return;
            const std::size_t pair = pairs[i];
            const CellLimits limits{wanted(pair) * std::pow(finer, round), level(round), most * surfaces_of(pair),
                                    request_.stop};
            found[i] = cell_sum(scene_, geometry_, geometry_.pairs[pair], limits, key);
            if (!request_.report) return;
            const std::lock_guard lock(reporting_);
            report(++done, pairs.size(), samples_);
        });
        std::vector<std::size_t> wide;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (found[i] && !take(pairs[i], std::move(*found[i]), round)) wide.push_back(pairs[i]);
        }
        if (request_.report) report(1, 1, samples_);
        expect_more_time(request_.stop);
        pairs = std::move(wide);
    }
}

/// @return whether it needs no other round
bool Rounds::take(std::size_t pair, CellSum cells, std::size_t round) {
    rows_[geometry_.owner(pair)].samples += cells.evaluations;
    samples_ += cells.evaluations;
    left_ -= std::min(left_, cells.evaluations);
    const EstimatedSum estimate = estimate_of(cells.sum, level(round));
    expected_[pair] = std::max(0.0, estimate.value);
    const bool within = estimate.half_width() <= wanted(pair);
    const auto method = cells.between_lines ? ExchangeMethod::cells : ExchangeMethod::points;
    State& state = pairs_[pair];
    if (state.recorded) earlier_.push_back({pair, std::move(*state.estimate.sum)});
    state.estimate = {std::move(cells.sum), method, level(round), cells.evaluations, false, {}};
    state.recorded = true;
    state.done = within || cells.at_limit;
    if (within) ++progress_.within;
    return state.done;
}

void Rounds::shoot_rays() {
    if (work_.empty() || !allows(2 * planned())) return;
    if (!tracer_) tracer_ = request_.tracer ? request_.tracer(scene_) : make_tracer(scene_, TracerChoice::automatic);
    while (!work_.empty()) {
        run_round();
        evaluate();
        keep_within_budget();
    }
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

/// A task of a thread is one randomisation of a row.
void Rounds::run_round() {
    begin_reporting();
    const std::uint64_t all = planned();
    std::uint64_t done = 0;
    const StreamKey key = key_of("rays");
    ++round_;
    for_each_index(work_.size() * randomisations, request_.threads, [&](std::uint64_t i) {
        RowByRays& row = work_[i / randomisations].row;
        row.run(*tracer_, key, static_cast<std::uint32_t>(i % randomisations), request_.stop);
        if (!request_.report) return;
        const std::lock_guard lock(reporting_);
        done += row.rays();
        report(done, all, samples_ + done);
    });
    samples_ += all;
    left_ -= std::min(all, left_);
    for (const Work& work : work_) {
        SampledRow& row = rows_[geometry_.owner(work.row.pairs().front())];
        row.samples += work.row.samples();
        row.rays += work.row.samples();
        row.lost += work.row.lost();
    }
}

/// @return whether the half width is what is wanted
bool Rounds::record(const Work& work, std::size_t pair) {
    State& state = pairs_[pair];
    state.estimate.level = level(work.rounds);
    state.estimate.sum = work.row.sum(pair);
    state.estimate.method = ExchangeMethod::rays;
    state.estimate.samples = work.row.samples();
    state.recorded = true;
    const EstimatedSum found = estimate_of(*state.estimate.sum, state.estimate.level);
    expected_[pair] = std::max(0.0, found.value);
    return found.half_width() <= wanted(pair);
}

/// When sampling stops early, the last complete round of each pair counts, even if it was a pilot. This is sound
/// because the time that is left does not depend on what was sampled.
void Rounds::note_unfinished() {
    for (const Earlier& earlier : earlier_) {
        State& state = pairs_[earlier.pair];
        if (state.recorded) continue;
        state.estimate.sum = earlier.sum;
        state.estimate.level = level(0);
        state.estimate.method = ExchangeMethod::rays;
        state.estimate.samples = earlier.sum.terms.front().share.points;
    }
}

/// Half widths that a row has to reach; pairs that are finished need nothing more.
std::vector<double> Rounds::missing(const RowByRays& row) const {
    std::vector<double> widths;
    for (const std::size_t pair : row.pairs())
        widths.push_back(pairs_.at(pair).done ? std::numeric_limits<double>::max() : wanted(pair));
    return widths;
}

/// The rays of the next round from the last one, and whether the next is still a pilot.
void Rounds::set_next(Work& work) {
    const std::uint64_t now = work.row.rays();
    std::uint64_t rays = work.row.rays_for(missing(work.row), level(work.rounds));
    if (!work.pilot) rays = std::max(rays, 2 * now);
    work.pilot = work.pilot && rays / farthest_sight > now;
    if (work.pilot) rays = std::min(rays, pilot_growth * now);
    work.row.set_rays(rays);
}

void Rounds::evaluate() {
    std::vector<Work> going_on;
    for (Work& work : work_) {
        if (work.pilot) {
            for (const std::size_t pair : work.row.pairs()) {
                earlier_.push_back({pair, work.row.sum(pair)});
                expected_[pair] = std::max(0.0, estimate_of(earlier_.back().sum, level(0)).value);
            }
            set_next(work);
            going_on.push_back(std::move(work));
            continue;
        }
        std::vector<std::size_t> open;
        for (const std::size_t pair : work.row.pairs()) {
            const bool within = record(work, pair);
            State& state = pairs_[pair];
            if (within && !state.done) ++progress_.within;
            state.done = within || work.rounds + 1 == most_rounds || last_;
            if (!state.done) open.push_back(pair);
        }
        if (open.empty()) continue;
        ++work.rounds;
        set_next(work);
        if (open.size() < work.row.pairs().size()) {
            RowByRays rest(scene_, geometry_, geometry_.owner(open.front()), open);
            rest.set_rays(work.row.rays());
            work.row = std::move(rest);
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
        if (work.pilot) work.row.set_rays(work.row.rays_for(missing(work.row), level(0)));
    }
    while (planned() > left_) {
        const auto largest = std::max_element(work_.begin(), work_.end(),
                                              [](const Work& a, const Work& b) { return a.row.rays() < b.row.rays(); });
        if (largest->row.rays() <= least_rays) {
            note_unfinished();
            work_.clear();
            return;
        }
        largest->row.set_rays(std::max(least_rays, largest->row.rays() / 2));
    }
    for (Work& work : work_) work.pilot = false;
    last_ = true;
}

/// Compares every estimate with those of earlier rounds. Each pair has its own share of the error rate, so that the
/// result does not depend on other pairs.
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
        const double room = 1e-6 * geometry_.areas[geometry_.owner(earlier.pair)];
        if (a.value - a.down <= b.value + b.up + room && b.value - b.down <= a.value + a.up + room) continue;
        state.estimate.contradicted = true;
        state.estimate.other = b;
    }
}

}  // namespace ff::studies::form_factors
