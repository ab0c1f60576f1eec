#include "core/support/instruction_sets.hpp"

#include "core/support/error.hpp"

#include <fmt/format.h>
#include <hwy/targets.h>

#include <cstdint>

namespace ff {

std::vector<std::string> instruction_sets() {
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
    return names;
}

void use_instruction_set(std::string_view name) {
    hwy::SetSupportedTargetsForTest(0);  // so that all are looked through
    std::int64_t chosen = 0;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        if (name == hwy::TargetName(target)) chosen = target;
    }
    if (chosen == 0 && !name.empty())
        throw UserError("instruction set '{}' is unknown here. Known: {}.", name, fmt::join(instruction_sets(), ", "));
    hwy::SetSupportedTargetsForTest(chosen);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace ff
