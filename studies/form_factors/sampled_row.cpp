#include "studies/form_factors/sampled_row.hpp"

#include <bit>
#include <type_traits>

namespace ff::studies::form_factors {
namespace {

/// Copies values to words, or words to values. In the latter case, values beyond the end of the words are left
/// unchanged, and this is reported.
struct Words {
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
void pass(Words& words, SampledSum::Term& term) {
    SampledShare& share = term.share;
    words(term.scale, share.points, share.unmet.rough, share.unmet.smooth, share.unmet.power, share.hits, share.met);
    words.list(share.means, [&](double& mean) { words(mean); });
}

void pass(Words& words, PairEstimate& estimate) {
    words(estimate.method, estimate.level, estimate.samples, estimate.contradicted);
    words(estimate.other.value, estimate.other.down, estimate.other.up, estimate.other.unmet);
    bool is_sampled = estimate.sum.has_value();
    words(is_sampled);
    if (!is_sampled) return;
    if (!estimate.sum) estimate.sum.emplace();
    words(estimate.sum->offset, estimate.sum->offset_error);
    words.list(estimate.sum->terms, [&](SampledSum::Term& term) { pass(words, term); });
}

void pass(Words& words, SampledRow& row) {
    words(row.row, row.samples, row.rays, row.lost);
    words.list(row.estimates, [&](std::pair<std::uint32_t, PairEstimate>& pair) {
        words(pair.first);
        pass(words, pair.second);
    });
}

}  // namespace

std::vector<std::uint64_t> to_words(const SampledRow& row) {
    Words words;
    SampledRow copy = row;
    pass(words, copy);
    return std::move(words.words);
}

std::optional<SampledRow> sampled_row(std::span<const std::uint64_t> words) {
    Words reader{.words = {words.begin(), words.end()}, .reads = true};
    SampledRow row;
    pass(reader, row);
    if (!reader.sound || reader.at < words.size()) return std::nullopt;
    return row;
}

}  // namespace ff::studies::form_factors
