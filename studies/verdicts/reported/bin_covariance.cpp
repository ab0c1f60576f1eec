#include "studies/verdicts/reported/bin_covariance.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/means/box_distance.hpp"
#include "studies/readers/csv_reader.hpp"
#include "studies/readers/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>

namespace ff::studies::gates {
namespace {

constexpr std::array<std::string_view, 3> covariance_columns{"bin", "other_bin", "covariance"};
constexpr std::size_t most_bins = 1000;

/// Bins by their names, numbered as the effects are.
using Places = std::unordered_map<std::string_view, std::size_t>;

[[noreturn]] void refuse_covariance(const Gate& gate, const std::string& problem) {
    throw UserError("{}: {}: {}", gate.place, gate.covariance.string(), problem);
}

void expect_header(CsvReader& reader, std::string_view origin) {
    std::vector<CsvField> header;
    const bool is_there = reader.next(header);
    if (is_there && std::equal(header.begin(), header.end(), covariance_columns.begin(), covariance_columns.end(),
                               [](const CsvField& field, std::string_view name) { return field.text == name; }))
        return;
    throw UserError("{}:1:1: not a file of covariances. Begin it with the line {}.", origin,
                    fmt::join(covariance_columns, ","));
}

double read_number(const CsvReader& reader, const CsvField& field) {
    const auto value = parse_bare_number<double>(field.text);
    if (!value || !(std::abs(*value) <= largest_magnitude))
        reader.fail(field, fmt::format("covariance = '{}' (not a finite number, at most {:g}). Write it like 2.5e-6.",
                                       field.text, largest_magnitude));
    return *value;
}

/// What a file says of the covariance of the bins that are judged.
struct ReadCovariance {
    std::vector<double> matrix;  ///< row by row; NaN where the file has no line for a pair
    std::size_t digits = 4;      ///< significant digits of its numbers; shorter ones are taken as exact to four
};

/// Digits from the first that is not 0 up to the exponent.
std::size_t significant_digits(std::string_view number) {
    std::size_t digits = 0;
    for (const char c : number.substr(0, number.find_first_of("eE"))) {
        const bool counts = digits > 0 || c != '0';
        digits += counts && c >= '0' && c <= '9' ? 1u : 0u;
    }
    return digits;
}

/// Bins that are not judged are passed over.
ReadCovariance read_covariance(const Gate& gate, const Places& places) {
    const std::string origin = gate.covariance.string();
    const std::string text = read_text_file(gate.covariance, FileKind::estimates);
    CsvReader reader(text, origin);
    expect_header(reader, origin);
    ReadCovariance read;
    std::vector<double>& matrix = read.matrix;
    matrix.assign(places.size() * places.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<CsvField> record;
    while (reader.next(record)) {
        if (record.size() != covariance_columns.size())
            reader.fail(record.front(),
                        fmt::format("{} cells (the header has 3). Give every column a value.", record.size()));
        const double value = read_number(reader, record[2]);
        read.digits = std::max(read.digits, significant_digits(record[2].text));
        const auto one = places.find(record[0].text);
        const auto other = places.find(record[1].text);
        if (one == places.end() || other == places.end()) continue;
        for (const std::size_t at :
             {one->second * places.size() + other->second, other->second * places.size() + one->second}) {
            if (!std::isnan(matrix[at]) && matrix[at] != value)
                reader.fail(record[2], fmt::format("the covariance of '{}' and '{}' stands here again, with another "
                                                   "value. Keep one.",
                                                   record[0].text, record[1].text));
            matrix[at] = value;
        }
    }
    return read;
}

/// Correlations, row by row.
std::vector<double> correlations_of(const ReadCovariance& read, std::size_t size) {
    std::vector<double> correlations(size * size);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j)
            correlations[i * size + j] =
                read.matrix[i * size + j] / std::sqrt(read.matrix[i * size + i] * read.matrix[j * size + j]);
    }
    return correlations;
}

/// How much the digits of the file leave open of any eigenvalue of its correlations: roundings of half a unit are as
/// good as random, and a random symmetric matrix has no eigenvalue beyond 2 √n standard deviations of its elements
/// (the semicircle law), of which half as many again are allowed here.
double left_open(const std::vector<double>& correlations, std::size_t digits, std::size_t size) {
    double squares = 0;
    for (const double each : correlations) {
        if (each == 0) continue;
        const double unit = std::pow(10.0, std::floor(std::log10(std::abs(each))) + 1 - static_cast<double>(digits));
        squares += unit * unit / 12;
    }
    return 3 * std::sqrt(squares / static_cast<double>(size));
}

/// The same with `more` added to each element of the diagonal.
std::vector<double> raised(std::vector<double> correlations, std::size_t size, double more) {
    for (std::size_t i = 0; i < size; ++i) correlations[i * size + i] += more;
    return correlations;
}

}  // namespace

double p_by_covariance(const Gate& gate, const Bins& bins, const std::vector<BinEffect>& effects) {
    const std::size_t size = effects.size();
    if (size > most_bins)
        refuse_covariance(
            gate,
            fmt::format("a covariance of {} bins (at most {}). Take combine = \"cauchy\", or divide the quantity.",
                        size, most_bins));
    Places places;
    std::vector<double> value;
    std::vector<double> low;
    std::vector<double> high;
    double freedom = std::numeric_limits<double>::infinity();
    for (const BinEffect& effect : effects) {
        places.emplace(bins.name(effect.name), places.size());
        value.push_back(effect.value);
        low.push_back(effect.band.low);
        high.push_back(effect.band.high);
        freedom = std::min(freedom, effect.freedom);
    }
    const auto of_bins = static_cast<double>(size);
    if (freedom < of_bins)
        refuse_covariance(
            gate, fmt::format("errors of {:.3g} samples tell nothing of the covariance of {} bins. Give n above the "
                              "number of bins, or take combine = \"cauchy\".",
                              freedom + 1, size));
    const ReadCovariance read = read_covariance(gate, places);
    const std::vector<double>& matrix = read.matrix;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            if (std::isnan(matrix[i * size + j]))
                refuse_covariance(gate,
                                  fmt::format("no covariance of bins '{}' and '{}'. Add it, 0 where there is none.",
                                              bins.name(effects[i].name), bins.name(effects[j].name)));
        }
        constexpr double rounding = 0.05;
        const double variance = effects[i].error * effects[i].error;
        if (std::abs(matrix[i * size + i] - variance) > rounding * variance)
            refuse_covariance(
                gate,
                fmt::format(
                    "bin '{}' has the variance {:.3g} here, and a standard error of {:.3g}, whose square is {:.3g} "
                    "(covariances are those of the differences that are judged, not of single samples). Give those.",
                    bins.name(effects[i].name), matrix[i * size + i], effects[i].error, variance));
    }
    // No distance may become too large by roundings, and what may be singular but for them is refused.
    const std::vector<double> correlations = correlations_of(read, size);
    const double open = left_open(correlations, read.digits, size);
    if (!stats::is_positive_definite(raised(correlations, size, -open), size))
        refuse_covariance(
            gate,
            fmt::format("not positive definite to its {} digits (some bins are sums of others, or the covariance is of "
                        "fewer runs than bins). Leave those bins out, or give more digits.",
                        read.digits));
    auto covariance = raised(correlations, size, open);
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) covariance[i * size + j] *= effects[i].error * effects[j].error;
    }
    const auto squared = stats::distance_to_box(value, low, high, covariance);
    FF_ENSURE(squared);
    const double below = freedom - of_bins + 1;  // infinite where the covariance is known
    const double shrink = std::isinf(freedom) ? 1 : below / freedom;
    return stats::fisher_tail(*squared * shrink / of_bins, of_bins, below);
}

}  // namespace ff::studies::gates
