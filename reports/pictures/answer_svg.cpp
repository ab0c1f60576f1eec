#include "reports/pictures/answer_svg.hpp"

namespace ff::reports {

std::optional<Picture> answer_picture(const studies::StudyResults& results) {
    auto lead = lead_picture(results);
    return lead && (lead->kind == "ranking" || has_lines_svg(*lead)) ? lead : answer_ranking(results);
}

std::string answer_svg(const Picture& picture) {
    return has_lines_svg(picture) ? lines_svg(picture) : ranking_svg(picture);
}

}  // namespace ff::reports
