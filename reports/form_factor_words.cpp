#include "reports/form_factor_words.hpp"

#include <algorithm>

namespace ff::reports {
namespace {

using studies::FaceExchange;
using studies::FacePair;

bool has_bounds_only(const FacePair& pair, const FaceExchange& exchange) {
    return pair.is_sampled() && !exchange.sampled_by;
}

}  // namespace

std::string_view method_of(const FacePair& pair, const FaceExchange& exchange) {
    if (has_bounds_only(pair, exchange)) return "bounds";
    if (exchange.sampled_by) return name(*exchange.sampled_by);
    ExchangeMethod dearest = ExchangeMethod::none;
    for (std::size_t m = 0; m < pair.methods.size(); ++m) {
        if (pair.methods[m] > 0) dearest = static_cast<ExchangeMethod>(m);
    }
    return name(dearest);
}

std::string_view reason_of(const FacePair& pair, const FaceExchange& exchange) {
    if (has_bounds_only(pair, exchange)) return "no time to sample it";
    if (exchange.sampled_by == ExchangeMethod::rays && pair.by_points) return "the rays of its row do as well";
    return in_words(pair.reason);
}

double worst_half_width(const studies::FormFactorMatrix& matrix, std::size_t pair) {
    const FaceExchange& exchange = matrix.exchanges[pair];
    const FacePair& faces = matrix.geometry.pairs[pair];
    return std::max(exchange.high - exchange.value, exchange.value - exchange.low) /
           std::min(matrix.geometry.areas[faces.from], matrix.geometry.areas[faces.to]);
}

}  // namespace ff::reports
