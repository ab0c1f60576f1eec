#include "studies/form_factors/words.hpp"

#include <array>

namespace ff::studies::form_factors {
namespace {

constexpr std::string_view no_time = "no time to sample it";
/// In files of earlier versions: rays served pairs that cells serve now.
constexpr std::string_view rays_of_row = "the rays of its row do as well";

constexpr std::array every_method{ExchangeMethod::none,       ExchangeMethod::closed_form, ExchangeMethod::contour,
                                  ExchangeMethod::quadrature, ExchangeMethod::remainder,   ExchangeMethod::bounds,
                                  ExchangeMethod::cells,      ExchangeMethod::points,      ExchangeMethod::rays};
constexpr std::array every_reason{ExchangeReason::turned_away,   ExchangeReason::aligned,      ExchangeReason::polygons,
                                  ExchangeReason::far,           ExchangeReason::small,        ExchangeReason::blocked,
                                  ExchangeReason::covers,        ExchangeReason::leaves,       ExchangeReason::curved,
                                  ExchangeReason::many_blockers, ExchangeReason::many_surfaces};

}  // namespace

std::string_view method_of(const FaceExchange& exchange) {
    return name(exchange.method.value_or(ExchangeMethod::bounds));
}

std::string_view reason_of(const FaceExchange& exchange) {
    if (!exchange.method) return no_time;
    return in_words(exchange.reason);
}

bool set_method(FaceExchange& exchange, std::string_view method, std::string_view reason) {
    exchange.method.reset();
    if (reason == no_time) return method == name(ExchangeMethod::bounds);
    for (const ExchangeMethod known : every_method) {
        if (method == name(known)) exchange.method = known;
    }
    if (!exchange.method) return false;
    if (reason == rays_of_row) reason = in_words(ExchangeReason::blocked);
    for (const ExchangeReason known : every_reason) {
        exchange.reason = known;
        if (reason == in_words(known)) return true;
    }
    return false;
}

}  // namespace ff::studies::form_factors
