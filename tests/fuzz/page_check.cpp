// SPDX-License-Identifier: MIT
// Readers of the five page formats. Each reads just enough to show that a page has the format.
#include "drawings.h"

#include <algorithm>
#include <cstring>

namespace fuzz {
namespace {

// Reads the characters of a text one after the other.
class Text {
public:
    explicit Text(std::string_view left) : left_(left) {}
    [[nodiscard]] bool is_empty() const { return left_.empty(); }
    [[nodiscard]] char peek() const { return left_.empty() ? '\0' : left_.front(); }
    bool skip(std::string_view expected) {
        if (left_.substr(0, expected.size()) != expected) return false;
        left_.remove_prefix(expected.size());
        return true;
    }
    std::string_view until(std::string_view end, const char* contract) {
        const std::size_t at = left_.find(end);
        require(at != std::string_view::npos, contract);
        const std::string_view found = left_.substr(0, at);
        left_.remove_prefix(at + end.size());
        return found;
    }
    std::string_view while_in(std::string_view set) {
        const std::size_t count = std::min(left_.find_first_not_of(set), left_.size());
        const std::string_view found = left_.substr(0, count);
        left_.remove_prefix(count);
        return found;
    }
    // Skips a decimal number without an exponent, and returns whether one was found.
    bool number() {
        if (!left_.empty() && left_.front() == '-') left_.remove_prefix(1);
        const std::size_t whole = while_in("0123456789").size();
        const std::size_t part = skip(".") ? while_in("0123456789").size() : 0;
        return whole + part > 0;
    }

private:
    std::string_view left_;
};

constexpr std::string_view spaces = " \t\r\n";

// Checks that the text is UTF-8 with only the characters that XML 1.0 allows.
void require_characters(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80   ? 1
                                   : lead < 0xC2 ? 0
                                   : lead < 0xE0 ? 2
                                   : lead < 0xF0 ? 3
                                   : lead < 0xF5 ? 4
                                                 : 0;
        require(length > 0 && i + length <= text.size(), "SVG is UTF-8");
        std::uint32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            require((next & 0xC0U) == 0x80U, "SVG is UTF-8");
            code = code << 6U | (next & 0x3FU);
        }
        require(code >= 0x20 || code == '\t' || code == '\n' || code == '\r', "XML has no control characters");
        require(code != 0xFFFE && code != 0xFFFF && (code < 0xD800 || code > 0xDFFF), "XML has no such character");
        i += length;
    }
}

void require_entities(std::string_view text) {
    require(text.find('<') == std::string_view::npos, "text has no tag");
    for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at + 1)) {
        const std::string_view entity = text.substr(at, text.substr(at).find(';') + 1);
        static constexpr std::string_view known[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};
        require(std::find(std::begin(known), std::end(known), entity) != std::end(known) || entity.substr(0, 2) == "&#",
                "an ampersand begins an entity");
    }
}

void require_attribute(std::string_view name, std::string_view value) {
    require_entities(value);
    if (name == "d")
        require(value.find_first_not_of("MmLlCcSsQqAaHhVvZz0123456789.- ,") == std::string_view::npos,
                "a path has numbers only");
    static constexpr std::string_view lengths[] = {"x",
                                                   "y",
                                                   "width",
                                                   "height",
                                                   "cx",
                                                   "cy",
                                                   "r",
                                                   "stroke-width",
                                                   "viewBox",
                                                   "stroke-dasharray",
                                                   "fill-opacity",
                                                   "stroke-opacity"};
    if (std::find(std::begin(lengths), std::end(lengths), name) != std::end(lengths))
        require(value.find_first_not_of("0123456789.- ,m") == std::string_view::npos, "a length is a number");
}

// Reads the rest of a tag. Returns whether the element has no content.
bool read_attributes(Text& text) {
    for (;;) {
        const bool apart = !text.while_in(spaces).empty();
        if (text.skip("/>")) return true;
        if (text.skip(">")) return false;
        require(apart, "attributes stand apart");
        const std::string_view name = text.until("=\"", "an attribute has a value");
        require(!name.empty() && name.find_first_of("<>\"' \n") == std::string_view::npos, "an attribute has a name");
        require_attribute(name, text.until("\"", "a value ends"));
    }
}

// Reads a tag whose '<' has been read.
void read_tag(Text& text, std::vector<std::string>& open) {
    if (text.skip("!--")) {
        require(text.until("--", "a comment ends").find("--") == std::string_view::npos && text.skip(">"),
                "a comment has no two hyphens");
        return;
    }
    const bool ends = text.skip("/");
    const std::string name(text.while_in("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789:-"));
    require(!name.empty(), "an element has a name");
    if (!ends) {
        if (!read_attributes(text)) open.push_back(name);
        return;
    }
    text.while_in(spaces);
    require(text.skip(">") && !open.empty() && open.back() == name, "elements end in the order that they began in");
    open.pop_back();
}

void require_svg(std::string_view page) {
    require_characters(page);
    Text text(page);
    require(text.skip("<?xml "), "SVG begins as XML does");
    text.until("?>", "a declaration ends");
    text.while_in(spaces);
    require(text.skip("<svg"), "the root is svg");
    std::vector<std::string> open = {"svg"};
    read_attributes(text);
    while (!open.empty()) {
        require_entities(text.until("<", "every element ends"));
        read_tag(text, open);
    }
    text.while_in(spaces);
    require(text.is_empty(), "nothing follows the root");
}

// The last lines state the offset of the table of objects, and the table must be there.
void require_pdf(std::string_view page) {
    require(page.substr(0, 5) == "%PDF-", "PDF says that it is");
    const std::size_t at = page.rfind("startxref");
    require(at != std::string_view::npos, "PDF says where its objects are");
    Text end(page.substr(at + std::strlen("startxref")));
    end.while_in(spaces);
    const std::string offset(end.while_in("0123456789"));
    require(!offset.empty() && offset.size() < 12, "the place of a table is a number");
    end.while_in(spaces);
    require(end.skip("%%EOF"), "PDF has an end");
    Text table(page.substr(std::min<std::size_t>(std::stoull(offset), page.size())));
    require(table.skip("xref") || (!table.while_in("0123456789").empty() && table.skip(" 0 obj")),
            "the table of objects stands where PDF says");
}

// Reads pairs of numbers.
void read_pairs(Text& text) {
    for (bool more = true; more; more = text.skip(",")) {
        require(text.number() && text.skip(",") && text.number(), "places are pairs of numbers");
    }
}

void require_hpgl(std::string_view page) {
    Text text(page);
    require(text.skip("IN;"), "HPGL begins with IN");
    while (!text.is_empty()) {
        if (!text.while_in("\r\n;").empty()) continue;
        if (text.skip("LB")) {
            text.until("\x03", "a label ends");
        } else if (text.skip("PU") || text.skip("PD")) {
            if (text.peek() != ';') read_pairs(text);
        } else if (text.skip("SI")) {
            read_pairs(text);
        } else {
            require(text.skip("SP") && text.number(), "HPGL has pens, lines and labels");
        }
        require(text.is_empty() || text.peek() == ';' || text.peek() == '\n', "an instruction ends");
    }
}

// A line consists of words, a letter and a number each, and of comments in parentheses, which do not nest.
void require_gcode_line(std::string_view line) {
    Text text(line);
    while (!text.is_empty()) {
        if (!text.while_in(spaces).empty()) continue;
        if (text.skip("(")) {
            require(text.until(")", "a comment ends").find('(') == std::string_view::npos, "comments do not nest");
            continue;
        }
        require(text.while_in("GMXYZFSIJPQ").size() == 1 && text.number(), "a word is a letter and a number");
    }
}

void require_gcode(std::string_view page, const hrbfnpr_page_desc& desc) {
    if (desc.pen_up != nullptr || desc.pen_down != nullptr) return; // the lines are the caller's
    Text text(page);
    while (!text.is_empty()) require_gcode_line(text.until("\n", "a line ends"));
}

// A file consists of pairs of lines: a code and a value. Its sections end, and it ends with EOF.
void require_dxf(std::string_view page) {
    Text text(page);
    bool in_section = false, ended = false;
    while (!text.is_empty()) {
        require(!ended, "nothing follows EOF");
        const std::string code(text.until("\n", "a code ends"));
        require(!code.empty() && code.size() < 5 && code.find_first_not_of("0123456789") == std::string::npos,
                "a code is a small number");
        const std::string_view value = text.until("\n", "a value ends");
        for (const char c : value) require(c >= ' ' && c < 0x7F, "values are ASCII");
        const int number = std::stoi(code);
        if (number >= 10 && number < 60) {
            Text digits(value);
            require(digits.number() && digits.is_empty(), "places and lengths are numbers");
        }
        if (number != 0) continue;
        if (value == "SECTION") {
            require(!in_section, "sections do not nest");
            in_section = true;
        } else if (value == "ENDSEC") {
            require(in_section, "a section begins before it ends");
            in_section = false;
        } else if (value == "EOF") {
            ended = true;
        } else {
            require(in_section, "entities are in sections");
        }
    }
    require(ended && !in_section, "DXF has an end");
}

} // namespace

void require_sound_page(std::string_view page, const hrbfnpr_page_desc& desc) {
    switch (desc.format) {
    case HRBFNPR_PAGE_FORMAT_SVG: require_svg(page); break;
    case HRBFNPR_PAGE_FORMAT_PDF: require_pdf(page); break;
    case HRBFNPR_PAGE_FORMAT_HPGL: require_hpgl(page); break;
    case HRBFNPR_PAGE_FORMAT_GCODE: require_gcode(page, desc); break;
    case HRBFNPR_PAGE_FORMAT_DXF: require_dxf(page); break;
    default: require(false, "a page of no known format is not written");
    }
}

} // namespace fuzz
