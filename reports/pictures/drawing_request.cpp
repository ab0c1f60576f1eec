#include "reports/pictures/drawing_request.hpp"

#include "reports/text/json_values.hpp"

#include <iterator>
#include <utility>

namespace ff::reports {

std::vector<Picture> all_pictures(const studies::StudyResults& results, const MethodChoice& methods) {
    std::vector<Picture> all;
    const auto add = [&](std::vector<Picture> more) { std::move(more.begin(), more.end(), std::back_inserter(all)); };
    if (auto lead = lead_picture(results, methods)) {
        auto alternatives = std::move(lead->alternatives);
        const bool are_below = lead->id != "answer";  // under their own names, as the lead itself
        lead->id = "answer";
        add({std::move(*lead)});
        if (!are_below) add(std::move(alternatives));
    }
    add(pictures_by_size(results, methods));
    if (!methods.names.empty()) return all;  // the others are of one method, or of the scene
    for (PictureGroup& group : picture_groups(results)) add(std::move(group.pictures));
    return all;
}

std::string drawing_request(const std::vector<Picture>& pictures, const Templates& templates,
                            const std::optional<FigureStyle>& style) {
    Json request{{"kinds", Json::object()}, {"pictures", Json::array()}};
    Json& kinds = request["kinds"];
    for (const Picture& picture : pictures) {
        if (!kinds.contains(picture.kind)) kinds[picture.kind] = Json::parse(templates.text(picture.kind + ".json"));
        request["pictures"].push_back(
            {{"id", picture.id}, {"kind", picture.kind}, {"values", Json::parse(picture.values)}});
    }
    if (style) {
        request["style"] = {{"width", style->width}, {"fontSize", style->font_size}, {"font", style->font}};
        if (style->height) request["style"]["height"] = *style->height;
    }
    return request.dump();
}

}  // namespace ff::reports
