#pragma once

#include <pugixml.hpp>

#include <string>

namespace ff::reports {

/// A page by itself, without scripts, as a tree: what is put into it is escaped when it is written.
struct HtmlPage {
    pugi::xml_document document;
    pugi::xml_node body;
};

/// With a title that is its first heading too. @param style  CSS beside that of all such pages
HtmlPage begin_page(const std::string& title, const std::string& style);

void set_attribute(pugi::xml_node node, const char* attribute, const std::string& value);

/// A new last child with this text, which must not be empty.
pugi::xml_node add_element(pugi::xml_node parent, const char* element, const std::string& text);

/// A picture that is called `label` where it is not seen.
pugi::xml_node add_svg(pugi::xml_node parent, double width, double height, const std::string& label);

/// Its text, with the document type.
std::string page_text(const HtmlPage& page);

}  // namespace ff::reports
