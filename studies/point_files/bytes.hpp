#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

namespace ff::studies {

/// The little-endian number that stands at a place. @pre all its bytes are there
template <class Number>
Number number_at(std::string_view bytes, std::size_t at) {
    static_assert(std::endian::native == std::endian::little);
    Number value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

}  // namespace ff::studies
