#include "app/folders/grown_study.hpp"

#include "core/support/error.hpp"
#include "studies/run/growth.hpp"
#include "studies/store/store.hpp"

#include <fmt/format.h>

#include <string_view>

namespace ff::app {
namespace {

using studies::CommonTrials;
using studies::Store;

constexpr std::string_view store_name = "results.sqlite";

std::string in_words(const CommonTrials& common, const std::string& difference) {
    return fmt::format("{} of {} trials are there already, from a study that differs in {}", common.reused,
                       common.wanted, difference);
}

void expect_wanted(const CommonTrials& common, const std::filesystem::path& file, const std::string& difference) {
    if (common.left_behind == 0) return;
    const std::uint64_t saved = common.reused + common.left_behind;
    throw UserError(fmt::format(
        "{}: holds another study (differs in {}): {} of its {} trials are none of this one. Choose another --out, or "
        "add --replace, which keeps the old store aside.",
        file.string(), difference, common.left_behind, saved));
}

/// A name that no file has.
std::filesystem::path place_aside(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        auto file = folder / fmt::format("results.before-{}.sqlite", number);
        if (!std::filesystem::exists(file)) return file;
    }
}

/// Leaves the store without a log beside it, so that it can be moved. @throws UserError where another program has it
/// open
Store open_whole(const std::filesystem::path& file) {
    Store store = Store::create_or_resume(file, Store::open(file).plan());
    if (!store.seal()) {
        throw UserError(
            fmt::format("{}: another program has it open. Close that one, or choose another --out.", file.string()));
    }
    return store;
}

}  // namespace

std::string grow_study(OutputFolder& folder, const studies::StudyPlan& plan, bool replace, unsigned threads) {
    const auto file = folder.path() / store_name;
    if (!std::filesystem::exists(file)) return {};
    const std::string difference = studies::difference_of_study(file, plan.spec);
    if (difference.empty()) return {};
    const auto grown = folder.make_workshop() / store_name;
    CommonTrials common;
    {
        const Store stored = open_whole(file);
        common = common_trials(stored, plan);
        if (!replace) expect_wanted(common, file, difference);
        Store store = Store::create_or_resume(grown, plan);
        adopt(stored, file, common, store, threads);
        studies::Context context = stored.context();
        context.erase("command");  // that of this study follows
        store.set_context(context);
        store.seal();
    }
    std::string text = in_words(common, difference);
    if (common.left_behind > 0) {
        const auto aside = place_aside(folder.path());
        std::filesystem::rename(file, aside);
        text += fmt::format("; the old store is kept as {}", aside.string());
    }
    std::filesystem::rename(grown, file);
    return text;
}

std::string describe_growth(const std::filesystem::path& folder, const studies::StudyPlan& plan) {
    const auto file = folder / store_name;
    if (!std::filesystem::exists(file)) return {};
    const std::string difference = studies::difference_of_study(file, plan.spec);
    if (difference.empty()) return {};
    const auto common = common_trials(Store::open(file), plan);
    return in_words(common, difference) +
           (common.left_behind == 0
                ? ""
                : fmt::format("; {} are none of this study, and need --replace", common.left_behind));
}

}  // namespace ff::app
