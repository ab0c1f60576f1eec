#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace ff::reports {

/// The methods that a picture shows: the named ones, or all.
struct MethodChoice {
    std::vector<std::string> names;  ///< empty: all
    [[nodiscard]] bool has(const std::string& method) const {
        return names.empty() || std::find(names.begin(), names.end(), method) != names.end();
    }
};

}  // namespace ff::reports
