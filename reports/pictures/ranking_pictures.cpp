#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/findings/letters.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/diagnostics/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

/// The texts beside a ranking.
struct RankingText {
    std::string id;
    std::string title;
    std::string axis;
    std::string finding;
    std::string description;  ///< text alternative, in addition to what is drawn
    bool log = false;
    bool isolates = true;  ///< whether a method can be shown alone
};

/// The picture of a ranking, row by row, in blocks with a heading each.
class RankingRows {
  public:
    RankingRows(const studies::StudyResults& results, const MethodChoice& methods)
        : results_(results), chosen_(methods) {}

    /// Begins a block.
    void heading(const std::string& text) {
        ++blocks_;
        block_ = text;
        begun_ = false;
    }

    /// Adds a row unless the method is not chosen.
    void add(const RankedMethod& row) {
        const std::string& method = results_.findings.plan.spec.methods[row.method].name;
        if (!chosen_.has(method)) return;
        if (!std::exchange(begun_, true)) order_.push_back(block_);
        ++rows_;
        methods_.insert(method);
        order_.push_back(fmt::format("{}|{}", block_, row.label));
        values_.add({order_.back(), method, row.size, drawn(row.value), drawn_low(row.interval),
                     drawn_high(row.interval), row.interval ? drawn(row.interval->high) : drawn(row.value),
                     drawn(row.expected), row.group});
    }

    [[nodiscard]] std::size_t blocks() const { return blocks_; }
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] bool full() const { return blocks_ >= most_blocks && blocks_ + rows_ >= most_lines; }

    Picture picture(const RankingText& text) {
        const auto styles = method_styles(results_, chosen_);
        auto names = Json::array();
        for (const MethodStyle& style : styles) {
            if (methods_.contains(style.method)) names.push_back(style.method);
        }
        if (names.size() > 1 && text.isolates) values_.set("isolate", std::move(names));
        Json scales = style_scales(styles);
        scales["y"] = {{"domain", order_}};
        values_.set("scales", std::move(scales));
        values_.set("titles", {{"x", text.axis}});
        if (text.log) values_.set("log", true);
        constexpr std::size_t most_above_axis = 26;  // with more rows, the axis below is not on the first screen
        if (rows_ > most_above_axis) values_.set("tall", true);
        return {text.id,
                "ranking",
                text.title,
                text.finding,
                fmt::format("A row for each method: {}, with its interval. {}", text.axis, text.description),
                values_.text()};
    }

  private:
    static constexpr std::size_t most_blocks = 4;  // unless they are so short that there is room for more
    static constexpr std::size_t most_lines = 30;
    const studies::StudyResults& results_;
    const MethodChoice& chosen_;
    bool begun_ = false;  ///< whether the heading of this block is written
    PictureValues values_{{"row", "method", "size", "value", "low", "high", "end", "expected", "group"}};
    std::string block_;
    Json order_ = Json::array();
    std::size_t blocks_ = 0;
    std::size_t rows_ = 0;
    std::set<std::string> methods_;
};

/// Sizes that are compared: from a power of two to the next. A ladder has one size in each.
struct Octave {
    std::map<std::uint64_t, std::size_t> sizes;  ///< evaluations per face, with how many cells have them
    std::set<std::size_t> methods;
    std::vector<std::size_t> cells;

    /// The size that most cells have.
    [[nodiscard]] std::uint64_t usual() const {
        return std::max_element(sizes.begin(), sizes.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; })
            ->first;
    }
};

std::map<int, Octave> octaves_of(const studies::Analysis& findings) {
    std::map<int, Octave> octaves;
    for (const studies::CellAnalysis& found : findings.cells) {
        if (found.evaluations_per_face == 0) continue;
        Octave& octave = octaves[static_cast<int>(std::bit_width(found.evaluations_per_face))];
        ++octave.sizes[found.evaluations_per_face];
        octave.methods.insert(findings.plan.cells[found.cell].method);
        octave.cells.push_back(found.cell);
    }
    std::erase_if(octaves, [](const auto& each) { return each.second.methods.size() < 2; });
    return octaves;
}

/// The method, with its size where that is not the usual one or where it has several.
std::string label_of(const studies::Analysis& findings, const Octave& octave, std::size_t cell) {
    const studies::StudyPlan& plan = findings.plan;
    const auto is_another = [&](std::size_t other) {
        return other != cell && plan.cells[other].method == plan.cells[cell].method &&
               plan.cells[other].scene == plan.cells[cell].scene;
    };
    if (std::any_of(octave.cells.begin(), octave.cells.end(), is_another)) return cell_label(plan, plan.cells[cell]);
    const std::string& method = plan.spec.methods[plan.cells[cell].method].name;
    const std::uint64_t size = findings.cells[cell].evaluations_per_face;
    return size == octave.usual() ? method : fmt::format("{} ({})", method, size);
}

}  // namespace

std::vector<Picture> errors_at_sizes(const studies::StudyResults& results, const MethodChoice& methods) {
    const studies::Analysis& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    const auto is_luck = [&](std::size_t cell) { return studies::may_be_luck(plan, plan.cells[cell]); };
    const auto has_no_bar = [&](std::size_t cell) { return plan.cells[cell].deterministic && !is_luck(cell); };
    const double level = studies::level_of_each_class(findings);
    std::vector<Picture> pictures;
    for (const auto& entry : octaves_of(findings)) {
        const auto& octave = entry.second;
        RankingRows rows(results, methods);
        for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
            std::vector<std::size_t> cells = octave.cells;
            std::erase_if(cells, [&](std::size_t cell) { return plan.cells[cell].scene != scene; });
            const auto luck = std::stable_partition(cells.begin(), cells.end(), std::not_fn(is_luck));
            const std::vector<std::size_t> unranked(luck, cells.end());
            cells.erase(luck, cells.end());
            for (const PairClass pair_class : pair_classes) {
                const auto ranked = studies::rank_errors(findings, cells, pair_class, level);
                const auto others = studies::rank_errors(findings, unranked, pair_class, level);
                if (ranked.size() + others.size() < 2 || rows.full()) continue;
                rows.heading(heading_of(plan, scene, pair_class));
                const auto add = [&](const studies::Ranked& each, const std::string& group) {
                    RankedMethod row = ranked_cell(plan, each, group);
                    row.label = label_of(findings, octave, each.index);
                    rows.add(row);
                };
                for (const studies::Ranked& each : ranked) add(each, letter(ranked, each));
                for (const studies::Ranked& each : others) add(each, "");
            }
        }
        if (rows.rows() < 2) continue;
        const auto if_any = [&](const auto& holds, std::string_view words) {
            return std::any_of(octave.cells.begin(), octave.cells.end(), holds) ? words : "";
        };
        pictures.push_back(rows.picture(
            {fmt::format("errors-at-{}", octave.usual()),
             fmt::format("Errors at {} evaluations per face, smallest first.", octave.usual()), "RMSE of a run",
             fmt::format("Bars: {:g} % intervals. {}{}{}{}", 100 * plan.spec.level,
                         letters_in_words(plan.spec.level, rows.blocks()),
                         if_any(has_no_bar, " Without bars: deterministic methods."),
                         if_any(is_luck,
                                " Last, without a letter: point sets that are not randomised, whose one error may be "
                                "luck."),
                         octave.sizes.size() > 1
                             ? " Methods made for other sizes are shown at theirs, named in brackets."
                             : ""),
             "", true}));
        pictures.back().name = fmt::format("errors at {} evaluations per face", octave.usual());
    }
    return pictures;
}

std::optional<Picture> claims_picture(const studies::StudyResults& results) {
    const auto& claims = results.claimed_errors;
    const auto fails = [](const studies::ClaimedErrors& each) {
        return each.finding == studies::ClaimedErrorFinding::fails;
    };
    const auto failing = std::count_if(claims.begin(), claims.end(), fails);
    const bool is_stated = std::any_of(claims.begin(), claims.end(), [](const studies::ClaimedErrors& each) {
        return each.claimant != studies::Claimant::one_run;
    });
    if (!is_stated && failing == 0) return std::nullopt;
    const studies::StudyPlan& plan = results.findings.plan;
    const MethodChoice all;
    RankingRows rows(results, all);
    std::string heading;
    for (const PairClass pair_class : pair_classes) {
        for (const studies::ClaimedErrors& each : claims) {
            const studies::Cell& cell = plan.cells[each.cell];
            const std::string its_heading = heading_of(plan, cell.scene, pair_class);
            constexpr std::size_t most_rows = 40;
            if (each.pair_class != pair_class || rows.rows() == most_rows) continue;
            if (its_heading != heading) {
                if (rows.full()) break;
                rows.heading(its_heading);
                heading = its_heading;
            }
            const studies::Method& method = plan.spec.methods[cell.method];
            const std::string size = size_label(plan, cell);
            rows.add({.label = fmt::format("{}{}{}", method.name, method.sizes.size() > 1 ? ", " + size : "",
                                           each.claimant == studies::Claimant::one_run ? ", as random" : ""),
                      .method = cell.method,
                      .size = size,
                      .value = static_cast<double>(each.worst_held) / static_cast<double>(cell.trials),
                      .interval = each.worst_share_interval,
                      .expected = each.promised,
                      .group = fails(each) ? "fails" : ""});
        }
    }
    const std::string finding = fmt::format("{} of {} claims about errors {} not hold as often as they should.",
                                            failing, claims.size(), failing == 1 ? "does" : "do");
    return rows.picture({"claimed-errors", "How often errors are within the claimed ones",
                         "share of runs within the claimed error, on the worst pair", finding,
                         "The line across a row is the share in which the claim should hold. " + finding});
}

std::optional<Picture> lead_picture(const studies::StudyResults& results, const MethodChoice& methods) {
    const MainFinding found = answer(results).finding;
    if (found.subject == Subject::light) {
        const auto group = radiosity_pictures(results);
        return group && !group->pictures.empty() ? std::optional(group->pictures.front()) : std::nullopt;
    }
    if (found.subject == Subject::occlusion) return pictures_by_size(results, methods).front();
    if (found.subject == Subject::publication) {
        if (auto picture = publication_picture(results, methods)) return picture;
    }
    return answer_ranking(results, methods);
}

std::optional<Picture> answer_ranking(const studies::StudyResults& results, const MethodChoice& methods) {
    const Answer said = answer(results);
    const MainFinding& found = said.finding;
    if (found.subject == Subject::light || found.subject == Subject::occlusion) return std::nullopt;
    const bool is_about_all = found.subject == Subject::coverage || found.subject == Subject::configurations;
    if (is_about_all && !methods.names.empty()) return std::nullopt;
    // Rankings at which another size is equal are pictures of their own.
    std::vector<std::string> sizes;
    for (const Ranking& ranking : found.rankings) {
        if (std::ranges::find(sizes, ranking.at) == sizes.end()) sizes.push_back(ranking.at);
    }
    std::vector<Picture> drawn_sizes;
    for (const std::string& size : sizes) {
        RankingRows rows(results, methods);
        for (const Ranking& ranking : found.rankings) {
            if (ranking.at != size) continue;
            if (!is_about_all && rows.full()) break;
            rows.heading(ranking.heading);
            for (const RankedMethod& row : ranking.methods) rows.add(row);
        }
        if (rows.rows() < 2) continue;  // one number needs no picture
        const std::string id = drawn_sizes.empty() ? "answer" : fmt::format("answer-{}", drawn_sizes.size() + 1);
        drawn_sizes.push_back(rows.picture({id, found.title, found.axis, found.note, said.text, found.logarithmic,
                                            found.subject != Subject::coverage}));
        drawn_sizes.back().name = size.empty() ? size : size.substr(std::string_view(" with ").size());
    }
    if (drawn_sizes.empty()) return std::nullopt;
    Picture picture = drawn_sizes.front();
    picture.alternatives.assign(std::next(drawn_sizes.begin()), drawn_sizes.end());
    if (found.subject == Subject::rates) {
        picture.name = "convergence rates";
        picture.alternatives = errors_at_sizes(results, methods);
    }
    return picture;
}

}  // namespace ff::reports
