#include "reports/mustache.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

namespace ff::reports {
namespace {

namespace mustache = kainjow::mustache;

constexpr std::string_view extension = ".mustache";

mustache::data to_data(const nlohmann::ordered_json& view) {
    if (view.is_object()) {
        mustache::data object;
        for (const auto& [key, value] : view.items()) object.set(key, to_data(value));
        return object;
    }
    if (view.is_array()) {
        mustache::data list(mustache::data::type::list);
        for (const auto& value : view) list.push_back(to_data(value));
        return list;
    }
    if (view.is_boolean()) return view.get<bool>();
    // An empty text opens no section; this library would take it for one that is there.
    if (view.is_null() || view.get_ref<const std::string&>().empty()) return false;
    return view.get_ref<const std::string&>();
}

}  // namespace

std::string fill_template(const Templates& templates, std::string_view name, const nlohmann::ordered_json& view,
                          std::string (*escape)(const std::string&)) {
    mustache::data data = to_data(view);
    for (const auto& [file, text] : templates.files()) {
        if (!file.ends_with(extension)) continue;
        data.set(file.substr(0, file.size() - extension.size()), mustache::partial([&body = text] { return body; }));
    }
    const std::string file = fmt::format("{}{}", name, extension);
    mustache::mustache document(templates.text(file));
    if (!document.is_valid()) {
        throw UserError(fmt::format("{}: malformed template ({}). Mend it.", file, document.error_message()));
    }
    document.set_custom_escape(escape);
    return document.render(data);
}

std::string escape_html(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace ff::reports
