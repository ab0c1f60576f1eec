#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace ff::studies {

/// A value of an enumeration, and its name in files.
template <class Enum>
struct Named {
    Enum value;
    std::string_view name;
    bool suggested = true;  ///< messages about unknown names suggest it
};
template <class Enum>
Named(Enum, std::string_view, bool = true) -> Named<Enum>;

template <class... Names>
constexpr auto name_table(Names... names) {
    return std::array{names...};
}

/// The values of an enumeration that have names in files; specialised beside each such enumeration.
template <class Enum>
inline constexpr std::array<Named<Enum>, 0> names_of{};

template <class Enum>
concept HasNames = !names_of<Enum>.empty();

/// @pre the value is in the table
template <HasNames Enum>
constexpr std::string_view name(Enum value) {
    return std::ranges::find(names_of<Enum>, value, &Named<Enum>::value)->name;
}

template <HasNames Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
    const auto found = std::ranges::find(names_of<Enum>, name, &Named<Enum>::name);
    return found == names_of<Enum>.end() ? std::nullopt : std::optional(found->value);
}

template <HasNames Enum>
std::vector<std::string_view> suggested_names() {
    std::vector<std::string_view> names;
    for (const auto& each : names_of<Enum>) {
        if (each.suggested) names.push_back(each.name);
    }
    return names;
}

}  // namespace ff::studies
