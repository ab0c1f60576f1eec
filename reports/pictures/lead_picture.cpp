#include "reports/pictures/pictures.hpp"
#include "reports/pictures/ranking_rows.hpp"
#include "reports/words/answer.hpp"

namespace ff::reports {

std::optional<Picture> lead_picture(const studies::StudyResults& results, const MethodChoice& methods) {
    const Answer said = answer(results);
    const MainFinding& found = said.finding;
    if (found.subject == Subject::light) {
        const auto group = radiosity_pictures(results);
        return group && !group->pictures.empty() ? std::optional(group->pictures.front()) : std::nullopt;
    }
    if (found.subject == Subject::occlusion) return occlusion_pictures(results, methods).front();
    const bool is_about_all = found.subject == Subject::coverage || found.subject == Subject::configurations;
    if (is_about_all && !methods.names.empty()) return std::nullopt;
    RankingRows rows(results.findings.plan, methods);
    for (const Ranking& ranking : found.rankings) {
        if (is_about_all || !rows.full()) rows.add(ranking);
    }
    if (rows.rows() < 2) return std::nullopt;  // one number needs no picture
    Picture picture = ranking_picture(results,
                                      {"answer", found.title, found.axis, found.note, said.text, found.logarithmic,
                                       found.subject != Subject::coverage},
                                      methods, rows);
    if (found.subject == Subject::rates) {
        picture.name = "convergence rates";
        picture.alternatives = errors_at_sizes(results, methods);
    }
    return picture;
}

}  // namespace ff::reports
