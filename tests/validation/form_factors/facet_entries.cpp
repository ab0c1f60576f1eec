#include "tests/validation/form_factors/facet_entries.hpp"

#include "core/geometry/scene.hpp"
#include "core/visibility/facing.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace ff::studies::form_factors {
namespace {

using PairOfFaces = std::pair<std::uint32_t, std::uint32_t>;

/// How a matrix is computed.
struct FacetWay {
    double tolerance = 0;
    bool cells = true;
    bool is_first = false;  ///< what does not depend on the tolerance is looked at once
};

constexpr std::array facet_ways{FacetWay{1e-4, true, true}, FacetWay{1e-3, true, false}, FacetWay{1e-3, false, false}};

/// A pair that is computed with every seed.
struct ChosenPair {
    PairOfFaces faces;
    std::size_t reference = 0;
    std::uint64_t place = 0;  ///< among those of its method
};

Request facet_request(const FacetWay& way, const FacetCoverageOptions& options, std::uint64_t seed) {
    Request request;
    request.tolerance = way.tolerance;
    request.cells = way.cells;
    request.seed = Seed{options.seed.value + seed};
    return request;
}

/// The same pairs come first by cells and by rays, so that they share references.
std::uint32_t rank_of(const PairOfFaces& faces, StreamKey key) {
    return philox({key, 0, faces.first, faces.second}, 0, Purpose::permutation)[0];
}

/// Pairs by method, drawn without regard to their values. @param matrix  by cells: those that it samples, rays would
std::map<ExchangeMethod, std::vector<PairOfFaces>> draw_pairs(const Scene& scene, const Matrix& matrix,
                                                              const FacetWay& way,
                                                              const FacetCoverageOptions& options) {
    std::map<ExchangeMethod, std::vector<PairOfFaces>> pairs;
    for (const FaceExchange& exchange : matrix.exchanges) {
        const ExchangeMethod method = *exchange.method;
        if (exchange.from == exchange.to) continue;
        if (!way.cells && exchange.is_sampled())
            pairs[ExchangeMethod::rays].emplace_back(exchange.from, exchange.to);
        else if (way.cells && (way.is_first || method >= ExchangeMethod::bounds))
            pairs[method].emplace_back(exchange.from, exchange.to);
    }
    if (way.is_first) {
        auto listed = matrix.exchanges.begin();
        for (std::uint32_t from = 0; from < matrix.faces(); ++from) {
            for (std::uint32_t to = from; to < matrix.faces(); ++to) {
                if (listed != matrix.exchanges.end() && PairOfFaces(listed->from, listed->to) == PairOfFaces(from, to))
                    ++listed;
                else if (from != to && face_each_other(scene.surfaces[from], scene.surfaces[to]))
                    pairs[ExchangeMethod::none].emplace_back(from, to);
            }
        }
    }
    const StreamKey key = derive_key(options.seed, fmt::format("facets of {}, {:g}", scene.canonical, way.tolerance));
    for (auto& [method, drawn] : pairs) {
        const auto order = [&](const PairOfFaces& faces) { return std::pair(rank_of(faces, key), faces); };
        std::ranges::sort(drawn, {}, order);
        drawn.resize(std::min(drawn.size(), options.pairs));
    }
    return pairs;
}

/// Computes the chosen pairs in one way, with one seed after the other.
class FacetLook {
  public:
    FacetLook(const Scene& scene, const FacetWay& way, const FacetCoverageOptions& options)
        : scene_(scene), way_(way), options_(options) {}

    /// @param matrix  at this tolerance, by cells
    void choose(const Matrix& matrix, std::map<PairOfFaces, std::size_t>& references) {
        for (const auto& [method, pairs] : draw_pairs(scene_, matrix, way_, options_)) {
            const bool is_sampled = method >= ExchangeMethod::cells;
            std::vector<ChosenPair>& chosen = is_sampled ? sampled_ : known_;
            for (std::size_t place = 0; place < pairs.size(); ++place) {
                const std::size_t reference = references.emplace(pairs[place], references.size()).first->second;
                chosen.push_back({pairs[place], reference, place});
            }
        }
        for (const ChosenPair& pair : known_) add(matrix, pair, 0, true, known_entries_);
    }

    /// The data that do not depend on the seed.
    [[nodiscard]] const std::vector<FacetEntry>& known() const { return known_entries_; }

    [[nodiscard]] std::vector<FacetEntry> at(std::uint64_t seed) const {
        std::vector<FacetEntry> entries;
        if (sampled_.empty()) return entries;
        Request request = facet_request(way_, options_, seed);
        if (!way_.cells) request.finished = rows_without_turn(seed);
        const Matrix matrix = find_matrix(scene_, request);
        for (const ChosenPair& pair : sampled_) add(matrix, pair, seed, has_turn(pair.place, seed), entries);
        if (scene_.closed && way_.cells) add_sums(matrix, seed, entries);
        return entries;
    }

  private:
    const Scene& scene_;
    FacetWay way_;
    const FacetCoverageOptions& options_;
    std::vector<ChosenPair> sampled_;
    std::vector<ChosenPair> known_;
    std::vector<FacetEntry> known_entries_;

    [[nodiscard]] bool has_turn(std::uint64_t place, std::uint64_t seed) const {
        return place % options_.seeds == seed;
    }

    /// Rays take a long time: only rows of pairs whose turn it is are shot.
    [[nodiscard]] std::vector<bool> rows_without_turn(std::uint64_t seed) const {
        std::vector<bool> rows(scene_.faces.size(), true);
        for (const ChosenPair& pair : sampled_) {
            if (!has_turn(pair.place, seed)) continue;
            rows[pair.faces.first] = false;
            rows[pair.faces.second] = false;
        }
        return rows;
    }

    void add(const Matrix& matrix, const ChosenPair& pair, std::uint64_t seed, bool is_one,
             std::vector<FacetEntry>& entries) const {
        const auto [from, to] = pair.faces;
        const FaceExchange found = matrix.exchange(from, to);
        if (!found.method) return;  // rows that were left out
        const double shift = found.is_sampled() ? options_.shift * half_width(found) : 0;
        const double shrink = found.is_sampled() ? options_.shrink : 1;
        entries.push_back({name(*found.method), from, to, pair.reference, static_cast<std::uint32_t>(seed),
                           found.clipped, is_one, way_.tolerance, std::min(matrix.areas[from], matrix.areas[to]),
                           found.value + shift, found.value + shift - shrink * (found.value - found.low),
                           found.value + shift + shrink * (found.high - found.value)});
    }

    /// Sums of the factors to all parts of a closed room are 1: the reference of number 0.
    void add_sums(const Matrix& matrix, std::uint64_t seed, std::vector<FacetEntry>& entries) const {
        for (std::uint32_t row = 0; row < matrix.faces(); ++row) {
            const RowSum& sum = matrix.rows[row];
            const double shift = options_.shift * std::max(sum.high - sum.value, sum.value - sum.low);
            entries.push_back({"row sum", row, row, 0, static_cast<std::uint32_t>(seed), false, has_turn(row, seed),
                               way_.tolerance, 1, sum.value + shift,
                               sum.value + shift - options_.shrink * (sum.value - sum.low),
                               sum.value + shift + options_.shrink * (sum.high - sum.value)});
        }
    }
};

bool is_wide(const PlainReference& reference, double accuracy) {
    return std::max(reference.high - reference.value, reference.value - reference.low) > accuracy;
}

}  // namespace

FacetEntries facet_entries(const Scene& scene, const FacetCoverageOptions& options) {
    FacetEntries result;
    std::map<PairOfFaces, std::size_t> references{{{0, 0}, 0}};  // the sum of a row
    std::vector<FacetLook> looks;
    Matrix matrix;
    for (const FacetWay& way : facet_ways) {
        if (way.cells) matrix = find_matrix(scene, facet_request(way, options, 0));
        looks.emplace_back(scene, way, options).choose(matrix, references);
    }

    result.pairs.resize(references.size());
    for (const auto& [faces, index] : references) result.pairs[index] = faces;
    constexpr double rounding_of_sums = 1e-12;
    result.references.assign(references.size(), {1, 1 - rounding_of_sums, 1 + rounding_of_sums});
    const StreamKey key = derive_key(options.seed, fmt::format("references of {}", scene.canonical));
    for_each_index(references.size() - 1, options.threads, [&](std::uint64_t i) {
        const auto [from, to] = result.pairs[i + 1];
        result.references[i + 1] = plain_reference(scene, from, to, options.effort, key);
    });
    // Eight means that look skewed say little; more of them say more.
    const auto wide = [&] {
        std::vector<std::size_t> found;
        for (std::size_t k = 1; k < result.pairs.size(); ++k) {
            const auto [from, to] = result.pairs[k];
            const double smaller = std::min(area(scene.surfaces[from].shape), area(scene.surfaces[to].shape));
            if (is_wide(result.references[k], options.effort.accuracy * smaller)) found.push_back(k);
        }
        return found;
    };
    for (const auto& [index, sharper] : sharper_references(scene, result, wide(), options))
        result.references[index] = sharper;
    result.wide_references = wide().size();

    std::vector<std::vector<FacetEntry>> by_seed(looks.size() * options.seeds);
    for_each_index(by_seed.size(), options.threads,
                   [&](std::uint64_t i) { by_seed[i] = looks[i % looks.size()].at(i / looks.size()); });
    for (const FacetLook& look : looks) by_seed.push_back(look.known());
    for (std::vector<FacetEntry>& entries : by_seed)
        std::move(entries.begin(), entries.end(), std::back_inserter(result.entries));
    return result;
}

std::map<std::size_t, PlainReference> sharper_references(const Scene& scene, const FacetEntries& entries,
                                                         const std::vector<std::size_t>& doubtful,
                                                         const FacetCoverageOptions& options) {
    std::set<std::size_t> unique(doubtful.begin(), doubtful.end());
    unique.erase(0);
    const std::vector<std::size_t> wanted(unique.begin(), unique.end());
    ReferenceEffort effort = options.effort;
    effort.randomisations *= 4;
    effort.accuracy = 0;
    effort.level = 0.999;
    std::vector<PlainReference> found(wanted.size());
    const StreamKey key = derive_key(options.seed, fmt::format("sharper references of {}", scene.canonical));
    for_each_index(wanted.size(), options.threads, [&](std::uint64_t i) {
        const auto [from, to] = entries.pairs[wanted[i]];
        found[i] = plain_reference(scene, from, to, effort, key);
    });
    std::map<std::size_t, PlainReference> result;
    for (std::size_t k = 0; k < wanted.size(); ++k) result.emplace(wanted[k], found[k]);
    return result;
}

}  // namespace ff::studies::form_factors
