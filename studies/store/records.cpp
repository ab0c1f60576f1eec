#include "studies/store/records.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <bit>

namespace ff::studies {
namespace {

constexpr std::size_t head_words = 4;         // unit, observations, patch hits, their squares
constexpr std::size_t observation_words = 5;  // what, from, to, trial, value

std::uint64_t index_of(std::string_view observable) {
    const auto* found = std::ranges::find(observable::all, observable);
    FF_EXPECT(found != observable::all.end());
    return static_cast<std::uint64_t>(found - observable::all.begin());
}

}  // namespace

std::vector<std::uint64_t> to_words(const UnitRecord& record) {
    std::vector<std::uint64_t> words{record.unit, record.observations.size(), record.patch_hits.size(),
                                     record.patch_hits_squared.size()};
    words.reserve(head_words + observation_words * record.observations.size() + record.patch_hits.size() +
                  record.patch_hits_squared.size());
    for (const Observation& observation : record.observations) {
        const bool real = std::holds_alternative<double>(observation.value);
        words.push_back(2 * index_of(observation.observable) + (real ? 1 : 0));
        words.push_back(static_cast<std::uint64_t>(observation.from_face));
        words.push_back(static_cast<std::uint64_t>(observation.to_face));
        words.push_back(observation.trial);
        words.push_back(real ? std::bit_cast<std::uint64_t>(std::get<double>(observation.value))
                             : std::bit_cast<std::uint64_t>(std::get<std::int64_t>(observation.value)));
    }
    words.insert(words.end(), record.patch_hits.begin(), record.patch_hits.end());
    words.insert(words.end(), record.patch_hits_squared.begin(), record.patch_hits_squared.end());
    return words;
}

UnitRecord from_words(std::span<const std::uint64_t> words) {
    FF_EXPECT(words.size() >= head_words);
    FF_EXPECT(words.size() == head_words + observation_words * words[1] + words[2] + words[3]);
    UnitRecord record;
    record.unit = words[0];
    const std::span<const std::uint64_t> observations = words.subspan(head_words, observation_words * words[1]);
    record.observations.reserve(words[1]);
    for (std::size_t i = 0; i < observations.size(); i += observation_words) {
        Observation observation;
        observation.observable = observable::all.at(observations[i] / 2);
        observation.from_face = static_cast<int>(observations[i + 1]);
        observation.to_face = static_cast<int>(observations[i + 2]);
        observation.trial = observations[i + 3];
        if (observations[i] % 2 == 1) {
            observation.value = std::bit_cast<double>(observations[i + 4]);
        } else {
            observation.value = std::bit_cast<std::int64_t>(observations[i + 4]);
        }
        record.observations.push_back(observation);
    }
    const auto sums = words.subspan(head_words + observations.size());
    record.patch_hits.assign(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(words[2]));
    record.patch_hits_squared.assign(sums.begin() + static_cast<std::ptrdiff_t>(words[2]), sums.end());
    return record;
}

}  // namespace ff::studies
