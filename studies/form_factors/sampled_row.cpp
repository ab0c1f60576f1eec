#include "studies/form_factors/sampled_row.hpp"

#include "stats/basics/moments.hpp"
#include "stats/means/mean_interval.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

namespace ff::studies::form_factors {
namespace {

/// Student's half width; 0 for equal means.
double student_half_width(const std::vector<double>& means, double level) {
    const auto interval = stats::mean_interval_t(stats::moments_of(means), level);
    return interval ? interval->width() / 2 : 0;
}

/// Copies values to words, or words to values. In the latter case, values beyond the end of the words are left
/// unchanged, and this is reported.
struct RowWords {
    std::vector<std::uint64_t> words{};
    bool reads = false;
    std::size_t at = 0;
    bool sound = true;

    template <class... Values>
    void operator()(Values&... values) {
        (pass(values), ...);
    }
    template <class Value, class Each>
    void list(std::vector<Value>& values, Each each) {
        std::uint64_t size = values.size();
        pass(size);
        sound = sound && (!reads || size <= words.size() - at);
        for (std::uint64_t i = 0; sound && i < size; ++i) each(reads ? values.emplace_back() : values[i]);
    }

  private:
    template <class Value>
    void pass(Value& value) {
        if constexpr (std::is_same_v<Value, double>) {
            std::uint64_t word = std::bit_cast<std::uint64_t>(value);
            pass(word);
            value = std::bit_cast<double>(word);
        } else if (!reads) {
            words.push_back(static_cast<std::uint64_t>(value));
        } else {
            sound = sound && at < words.size();
            if (sound) value = static_cast<Value>(words[at++]);
        }
    }
};

/// The order of members, stated once for both directions.
void pass(RowWords& words, SampledSum::Term& term) {
    SampledShare& share = term.share;
    words(term.scale, share.points, share.unmet.rough, share.unmet.smooth, share.unmet.power, share.hits, share.met);
    words.list(share.means, [&](double& mean) { words(mean); });
}

void pass(RowWords& words, PairEstimate& estimate) {
    words(estimate.method, estimate.level, estimate.samples, estimate.contradicted);
    words(estimate.other.value, estimate.other.down, estimate.other.up, estimate.other.unmet);
    bool is_sampled = estimate.sum.has_value();
    words(is_sampled);
    if (!is_sampled) return;
    if (!estimate.sum) estimate.sum.emplace();
    words(estimate.sum->offset, estimate.sum->offset_error);
    words.list(estimate.sum->terms, [&](SampledSum::Term& term) { pass(words, term); });
}

void pass(RowWords& words, SampledRow& row) {
    words(row.row, row.samples, row.rays, row.lost);
    words.list(row.estimates, [&](std::pair<std::uint32_t, PairEstimate>& pair) {
        words(pair.first);
        pass(words, pair.second);
    });
}

}  // namespace

double none_of(std::uint64_t points, double level) {
    return -std::expm1(std::log((1 - level) / 2) / static_cast<double>(points));
}

double UnmetBound::at(double p) const {
    return std::max(rough * p, smooth * std::pow(p, power));
}

double unmet_of(double scale, const SampledShare& share, double level) {
    return std::abs(scale) * share.unmet.at(none_of(share.points, level));
}

EstimatedSum with_means(EstimatedSum known, const std::vector<double>& means, double unmet, double level) {
    known.unmet = unmet;
    known.value += *stats::moments_of(means).mean();
    const double width = student_half_width(means, level) + unmet;
    known.down += width;
    known.up += width;
    return known;
}

EstimatedSum estimate_of(const SampledSum& sum, double level) {
    const EstimatedSum known{sum.offset, sum.offset_error, sum.offset_error, 0};
    if (sum.terms.empty()) return known;
    std::vector<double> sums(sum.terms.front().share.means.size(), 0.0);
    double unmet = 0;
    for (const auto& [scale, share] : sum.terms) {
        for (std::size_t r = 0; r < sums.size(); ++r) sums[r] += scale * share.means[r];
        // The points of all terms together share the few that a set of places may be entitled to and get none of.
        unmet = std::max(unmet, unmet_of(scale, share, level));
    }
    return with_means(known, sums, unmet, level);
}

std::vector<std::uint64_t> to_words(const SampledRow& row) {
    RowWords words;
    SampledRow copy = row;
    pass(words, copy);
    return std::move(words.words);
}

std::optional<SampledRow> sampled_row(std::span<const std::uint64_t> words) {
    RowWords reader{.words = {words.begin(), words.end()}, .reads = true};
    SampledRow row;
    pass(reader, row);
    if (!reader.sound || reader.at < words.size()) return std::nullopt;
    return row;
}

}  // namespace ff::studies::form_factors
