#include "reports/templates/mustache.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/readers/printable.hpp"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

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

/// Names of the templates that a template includes.
std::vector<std::string> included_in(std::string_view text) {
    std::vector<std::string> names;
    std::string begin = "{{";
    std::string end = "}}";
    for (std::size_t at = 0; (at = text.find(begin, at)) != std::string_view::npos;) {
        at += begin.size();
        const std::size_t stop = std::min(text.find(end, at), text.size());
        const std::string_view tag = trimmed(text.substr(at, stop - at));
        at = std::min(stop + end.size(), text.size());
        if (tag.starts_with('>')) names.emplace_back(trimmed(tag.substr(1)));
        const std::size_t blank = tag.find(' ');
        if (tag.size() < 4 || !tag.starts_with('=') || blank == std::string_view::npos) continue;
        begin = trimmed(tag.substr(1, blank - 1));  // {{=<% %>=}} changes the delimiters
        end = trimmed(tag.substr(blank, tag.size() - 1 - blank));
        if (begin.empty() || end.empty()) break;  // refused when it is parsed
    }
    return names;
}

/// A template that includes itself would never end. @throws UserError where one does
/// @param path  of templates that include each other, down to this one
void expect_no_circle(const Templates& templates, const std::string& name, std::vector<std::string>& path) {
    const auto file = templates.files().find(name + std::string(extension));
    if (file == templates.files().end()) return;
    const bool again = std::find(path.begin(), path.end(), name) != path.end();
    path.push_back(name);
    if (again) {
        throw UserError("{}: the template includes itself ({}). Leave one of these out.", file->first,
                        fmt::join(path, " > "));
    }
    for (const std::string& next : included_in(file->second)) expect_no_circle(templates, next, path);
    path.pop_back();
}

}  // namespace

std::string fill_template(const Templates& templates, std::string_view name, const nlohmann::ordered_json& view,
                          std::string (*escape)(const std::string&)) {
    std::vector<std::string> path;
    expect_no_circle(templates, std::string(name), path);
    mustache::data data = to_data(view);
    for (const auto& [file, text] : templates.files()) {
        if (!file.ends_with(extension)) continue;
        data.set(file.substr(0, file.size() - extension.size()), mustache::partial([&body = text] { return body; }));
    }
    const std::string file = fmt::format("{}{}", name, extension);
    mustache::mustache document(templates.text(file));
    if (!document.is_valid()) {
        throw UserError("{}: malformed template ({}). Fix it.", file,
                        studies::visible_text(excerpt(document.error_message())));
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
