#pragma once

#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/words/findings/standing.hpp"
#include "studies/results/results.hpp"

#include <cstddef>
#include <set>
#include <string>

namespace ff::reports {

/// Rows of a ranking, in blocks with a heading each.
class RankingRows {
  public:
    RankingRows(const studies::StudyPlan& plan, const MethodChoice& methods) : plan_(plan), chosen_(methods) {}

    /// Begins a block.
    void heading(const std::string& text);
    /// Adds a row unless the method is not chosen.
    void add(const RankedMethod& row);
    /// Adds a block.
    void add(const Ranking& ranking);
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] bool full() const { return blocks_ >= most_blocks; }
    PictureValues& values() { return values_; }
    [[nodiscard]] const Json& order() const { return order_; }
    [[nodiscard]] const std::set<std::string>& methods() const { return methods_; }

  private:
    static constexpr std::size_t most_blocks = 4;
    const studies::StudyPlan& plan_;
    const MethodChoice& chosen_;
    bool begun_ = false;  ///< whether the heading of this block is written
    PictureValues values_{{"row", "method", "size", "value", "low", "high", "end", "expected", "group"}};
    std::string block_;
    Json order_ = Json::array();
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

}  // namespace ff::reports
