#pragma once

#include <pugixml.hpp>

#include <string>

namespace ff::reports {

/// A single page without scripts, as a tree whose content is escaped on output.
struct HtmlPage {
    pugi::xml_document document;
    pugi::xml_node body;
};

/// A page whose title is also its first heading. @param style CSS in addition to that of all such pages
HtmlPage begin_page(const std::string& title, const std::string& style);

void set_attribute(pugi::xml_node node, const char* attribute, const std::string& value);

/// A new last child with this text, which must not be empty.
pugi::xml_node add_element(pugi::xml_node parent, const char* element, const std::string& text);

/// A picture with the text alternative `label`.
pugi::xml_node add_svg(pugi::xml_node parent, double width, double height, const std::string& label);

/// The text of the page, with the document type.
std::string page_text(const HtmlPage& page);

}  // namespace ff::reports
