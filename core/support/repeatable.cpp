#include "core/support/repeatable.hpp"

#include "core/support/error.hpp"

namespace ff {

void Repeatable::refuse_unrepeatable(std::string_view title, std::string_view when, std::string_view what) const {
    throw UserError(
        "{}: {}, it {} different {} (they must follow from seed and sizes alone, not from the time, the process or a "
        "generator that runs on). Let its random numbers follow from {}.",
        title, when, words_.gives, what, words_.seed);
}

void Repeatable::refuse_seedless(std::string_view title, std::string_view what) const {
    throw UserError(
        "{}: {} the same {} for every seed (trials would be equal). Let its random numbers follow from {}, "
        "or {} where nothing is random.",
        title, words_.gives, what, words_.seed, words_.no_seed);
}

}  // namespace ff
