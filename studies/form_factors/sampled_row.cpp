#include "studies/form_factors/sampled_row.hpp"

#include <bit>
#include <concepts>
#include <type_traits>

namespace ff::studies::form_factors {
namespace {

/// The order of members, said once for both directions.
template <class Archive>
void pass(Archive& archive, EstimatedSum& estimate) {
    archive(estimate.value, estimate.down, estimate.up, estimate.unmet);
}

template <class Archive>
void pass(Archive& archive, SampledSum::Term& term) {
    SampledShare& share = term.share;
    archive(term.scale, share.points, share.unmet.rough, share.unmet.smooth, share.unmet.power, share.hits, share.met);
    archive.list(share.means, [&](double& mean) { archive(mean); });
}

template <class Archive>
void pass(Archive& archive, PairEstimate& estimate) {
    archive(estimate.method, estimate.level, estimate.samples, estimate.contradicted);
    pass(archive, estimate.other);
    bool is_sampled = estimate.sum.has_value();
    archive(is_sampled);
    if (!is_sampled) return;
    if (!estimate.sum) estimate.sum.emplace();
    archive(estimate.sum->offset, estimate.sum->offset_error);
    archive.list(estimate.sum->terms, [&](SampledSum::Term& term) { pass(archive, term); });
}

template <class Archive>
void pass(Archive& archive, SampledRow& row) {
    archive(row.row, row.samples, row.rays, row.lost);
    archive.list(row.estimates, [&](std::pair<std::uint32_t, PairEstimate>& pair) {
        archive(pair.first);
        pass(archive, pair.second);
    });
}

template <class Value>
concept WholeOrName = std::integral<Value> || std::is_enum_v<Value>;

std::uint64_t to_word(double value) {
    return std::bit_cast<std::uint64_t>(value);
}
template <WholeOrName Whole>
std::uint64_t to_word(Whole value) {
    return static_cast<std::uint64_t>(value);
}
void from_word(std::uint64_t word, double& value) {
    value = std::bit_cast<double>(word);
}
template <WholeOrName Whole>
void from_word(std::uint64_t word, Whole& value) {
    value = static_cast<Whole>(word);
}

struct WordWriter {
    std::vector<std::uint64_t> words;

    template <class... Values>
    void operator()(const Values&... values) {
        (words.push_back(to_word(values)), ...);
    }
    template <class Value, class Each>
    void list(std::vector<Value>& values, Each each) {
        words.push_back(values.size());
        for (Value& value : values) each(value);
    }
};

/// Gives zeros and empty lists after the end, and says so.
struct WordReader {
    std::span<const std::uint64_t> words;
    bool sound = true;

    template <class... Values>
    void operator()(Values&... values) {
        (from_word(next(), values), ...);
    }
    template <class Value, class Each>
    void list(std::vector<Value>& values, Each each) {
        const std::uint64_t size = next();
        sound = sound && size <= words.size();
        for (std::uint64_t i = 0; sound && i < size; ++i) each(values.emplace_back());
    }

  private:
    std::uint64_t next() {
        sound = sound && !words.empty();
        if (!sound) return 0;
        const std::uint64_t word = words.front();
        words = words.subspan(1);
        return word;
    }
};

}  // namespace

std::vector<std::uint64_t> to_words(const SampledRow& row) {
    WordWriter writer;
    SampledRow copy = row;
    pass(writer, copy);
    return std::move(writer.words);
}

std::optional<SampledRow> sampled_row(std::span<const std::uint64_t> words) {
    WordReader reader{words};
    SampledRow row;
    pass(reader, row);
    if (!reader.sound || !reader.words.empty()) return std::nullopt;
    return row;
}

}  // namespace ff::studies::form_factors
