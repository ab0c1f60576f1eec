#pragma once

#include "reports/pictures/method_choice.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "studies/comparison/ranking.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ff::reports {

/// Rows of a ranking, in blocks with a heading each.
class RankingRows {
  public:
    explicit RankingRows(const MethodChoice& methods) : chosen_(methods) {}

    struct Row {
        std::string label;
        std::string method;
        std::string size;
        std::optional<double> value;
        std::optional<stats::Interval> interval;
        std::optional<double> expected;
        std::string group;
    };

    /// Begins a block.
    void heading(const std::string& text);
    /// Adds a row unless the method is not chosen.
    void add(const Row& row);
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] bool full() const { return blocks_ >= most_blocks; }
    PictureValues& values() { return values_; }
    [[nodiscard]] const nlohmann::ordered_json& order() const { return order_; }
    [[nodiscard]] const std::set<std::string>& methods() const { return methods_; }

  private:
    static constexpr std::size_t most_blocks = 4;
    const MethodChoice& chosen_;
    bool begun_ = false;  ///< whether the heading of this block stands
    PictureValues values_{{"row", "method", "size", "value", "low", "high", "end", "expected", "group"}};
    std::string block_;
    nlohmann::ordered_json order_ = nlohmann::ordered_json::array();
    std::size_t blocks_ = 0;
    std::size_t rows_ = 0;
    std::set<std::string> methods_;
};

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

Picture ranking_picture(const studies::StudyResults& results, const RankingText& text, const MethodChoice& methods,
                        RankingRows& rows);

/// Letter of a group: a for the best; empty where all are in one.
std::string letter(const std::vector<studies::Ranked>& ranked, const studies::Ranked& one);
/// What the letters mean.
std::string letters_in_words(double level);

/// The heading of a class of pairs: "adjacent pairs", "cube: adjacent pairs".
std::string heading_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class);

}  // namespace ff::reports
