#include "reports/pictures/drawing_request.hpp"

#include <nlohmann/json.hpp>

namespace ff::reports {

std::string drawing_request(const studies::StudyResults& results, const Templates& templates) {
    using Json = nlohmann::ordered_json;
    Json kinds = Json::object();
    Json pictures = Json::array();
    const auto add = [&](const std::vector<Picture>& more) {
        for (const Picture& picture : more) {
            if (!kinds.contains(picture.kind))
                kinds[picture.kind] = Json::parse(templates.text(picture.kind + ".json"));
            pictures.push_back({{"id", picture.id}, {"kind", picture.kind}, {"values", Json::parse(picture.values)}});
        }
    };
    const auto lead = lead_picture(results);
    if (lead && lead->kind == "ranking") add({*lead});  // others are among those below
    add(pictures_by_size(results));
    for (const PictureGroup& group : picture_groups(results)) add(group.pictures);
    return Json{{"kinds", std::move(kinds)}, {"pictures", std::move(pictures)}}.dump();
}

}  // namespace ff::reports
