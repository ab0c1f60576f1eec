#include "reports/html/html_page.hpp"

#include <fmt/format.h>

#include <sstream>

namespace ff::reports {
namespace {

constexpr const char* common_style =
    "body{font:16px/1.4 sans-serif;margin:2em auto;max-width:75em;padding:0 1em;color:#1b1b1b;background:#fff}"
    "table{border-collapse:collapse}td,th{text-align:left;vertical-align:top;padding:.4em .8em;"
    "border-bottom:1px solid #ccc}svg{display:block}";

}  // namespace

HtmlPage begin_page(const std::string& title, const std::string& style) {
    HtmlPage page;
    pugi::xml_node html = page.document.append_child("html");
    set_attribute(html, "lang", "en");
    pugi::xml_node head = html.append_child("head");
    set_attribute(head.append_child("meta"), "charset", "utf-8");
    add_element(head, "title", title);
    add_element(head, "style", common_style + style);
    page.body = html.append_child("body");
    add_element(page.body, "h1", title);
    return page;
}

void set_attribute(pugi::xml_node node, const char* attribute, const std::string& value) {
    node.append_attribute(attribute).set_value(value.c_str());
}

pugi::xml_node add_element(pugi::xml_node parent, const char* element, const std::string& text) {
    pugi::xml_node node = parent.append_child(element);
    node.text().set(text.c_str());
    return node;
}

pugi::xml_node add_svg(pugi::xml_node parent, double width, double height, const std::string& label) {
    pugi::xml_node svg = parent.append_child("svg");
    set_attribute(svg, "width", fmt::format("{:g}", width));
    set_attribute(svg, "height", fmt::format("{:g}", height));
    set_attribute(svg, "role", "img");
    set_attribute(svg, "aria-label", label);
    return svg;
}

std::string page_text(const HtmlPage& page) {
    std::ostringstream out;
    out << "<!doctype html>\n";
    page.document.child("html").print(out, "", pugi::format_raw | pugi::format_no_declaration);
    out << "\n";
    return out.str();
}

}  // namespace ff::reports
