// SPDX-License-Identifier: MIT
#include "output/vector/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using glm::dvec2;

// How far the handles of a curve may lie off its chord, thousandths, for it to be a straight line.
constexpr double straight = 1.5;
constexpr double opaque = 0.9995;

bool is_straight(std::int64_t x, std::int64_t y, const std::array<std::int64_t, 6>& to) noexcept {
    const auto dx = static_cast<double>(to[4] - x), dy = static_cast<double>(to[5] - y);
    const double length = std::hypot(dx, dy);
    for (std::size_t i = 0; i < 4; i += 2) {
        const auto hx = static_cast<double>(to[i] - x), hy = static_cast<double>(to[i + 1] - y);
        const double on = hx * dx + hy * dy;
        if (std::abs(hx * dy - hy * dx) > straight * length || on < 0.0 || on > length * length) return false;
    }
    return true;
}

} // namespace

SvgWriter::SvgWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
                     PageCounts& counts)
    : out_(writer), settings_(settings), counts_(counts), shapes_(memory, settings) {
    header(page);
}

void SvgWriter::header(const PageInfo& page) {
    out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
            "version=\"1.1\" width=\""
         << page.width << "mm\" height=\"" << page.height << "mm\" viewBox=\"0 0 " << page.width << ' ' << page.height
         << "\">\n";
    const auto element = [&](const char* name, const char* content) {
        if (content != nullptr && *content != '\0')
            (out_ << '<' << name << '>').escaped(content) << "</" << name << ">\n";
    };
    element("title", page.title);
    element("desc", page.description);
    out_ << "<metadata>";
    if (page.metadata != nullptr && *page.metadata != '\0') out_.escaped(page.metadata) << '\n';
    out_ << "hrbfnpr " << page.program << "</metadata>\n";
}

void SvgWriter::rect(const Frame& frame) {
    out_ << "<rect x=\"" << frame.left << "\" y=\"" << frame.top << "\" width=\"" << frame.right - frame.left
         << "\" height=\"" << frame.bottom - frame.top << '"';
}

// Of letters, digits and '-'.
void SvgWriter::id(std::string_view name) {
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        out_ << (plain ? c : '-');
    }
}

void SvgWriter::begin_layer(std::string_view name) {
    out_ << "<g id=\"";
    if (views_ > 0) out_ << "view-" << views_ << '-';
    out_ << "layer-" << groups_ << '-';
    id(name);
    (out_ << "\" inkscape:groupmode=\"layer\" inkscape:label=\"").escaped(name) << '"';
}

void SvgWriter::color(const char* property, const glm::vec4& color) {
    std::array<char, 8> text{};
    const auto byte = [](float part) { return static_cast<unsigned>(std::clamp(part, 0.0F, 1.0F) * 255.0F + 0.5F); };
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.x), byte(color.y), byte(color.z));
    out_ << ' ' << property << "=\"" << text.data() << '"';
}

void SvgWriter::opacity(const char* property, double value) {
    if (value < opaque) out_ << ' ' << property << "=\"" << value << '"';
}

void SvgWriter::begin_view(const PageView& view) {
    ++views_;
    paper_ = view.paper;
    out_ << "<clipPath id=\"frame-" << views_ << "\">";
    rect(view.frame);
    out_ << "/></clipPath>\n<g id=\"view-" << views_ << "\" clip-path=\"url(#frame-" << views_ << ")\"";
    if (!view.name.empty()) (out_ << " inkscape:label=\"").escaped(view.name) << '"';
    out_ << ">\n";
    if (!view.with_paper || !(paper_.w > 0.0F)) return;
    begin_layer("paper");
    out_ << ">\n";
    rect(view.frame);
    color("fill", paper_);
    opacity("fill-opacity", static_cast<double>(paper_.w));
    out_ << "/>\n</g>\n";
}

void SvgWriter::begin_group(const PageGroup& group) {
    group_ = group;
    ++groups_;
    ++counts_.groups;
    begin_layer(group.name);
    color("fill", group.ink);
    color("stroke", group.ink);
    out_ << " stroke-width=\"0\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
}

void SvgWriter::path(const PagePath& path) {
    ++counts_.paths;
    shapes_.shape(path, group_, *this);
}

void SvgWriter::dot(const PageDot& dot) {
    ++counts_.dots;
    if (settings_.dots_of(group_.pen_width) != DotShapes::circles) {
        shapes_.shape(dot, group_, *this);
        return;
    }
    out_ << "<circle cx=\"" << dot.x << "\" cy=\"" << dot.y << "\" r=\"" << dot.radius << '"';
    if (dot.is_paper) color("fill", paper_);
    opacity("fill-opacity", dot.is_paper ? dot.opacity : dot.opacity * static_cast<double>(group_.ink.w));
    out_ << "/>\n";
}

void SvgWriter::text(const PageText& text) {
    (out_ << "<text x=\"" << text.x << "\" y=\"" << text.y
          << "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" << text.height / capitals_of_size << "\">")
            .escaped(text.text)
        << "</text>\n";
}

void SvgWriter::begin_fill(double value) {
    out_ << "<path";
    opacity("fill-opacity", value * static_cast<double>(group_.ink.w));
    out_ << " d=\"";
    letter_ = ' ';
}

void SvgWriter::begin_line(double width, Cap cap, double value) {
    out_ << "<path fill=\"none\" stroke-width=\"" << width << '"';
    if (cap == Cap::flat) out_ << " stroke-linecap=\"butt\"";
    opacity("stroke-opacity", value * static_cast<double>(group_.ink.w));
    out_ << " d=\"";
    letter_ = ' ';
}

void SvgWriter::command(char letter) {
    if (letter == letter_)
        out_ << ' ';
    else
        out_ << letter;
    letter_ = letter;
}

void SvgWriter::pair(std::int64_t x, std::int64_t y) { (out_.thousandths(x) << ' ').thousandths(y); }

void SvgWriter::move_to(const dvec2& p) {
    x_ = in_thousandths(p.x);
    y_ = in_thousandths(p.y);
    letter_ = ' ';
    command('M');
    pair(x_, y_);
    letter_ = ' ';
}

void SvgWriter::line_to(const dvec2& p) {
    const std::int64_t x = in_thousandths(p.x), y = in_thousandths(p.y);
    if (x == x_ && y == y_ && letter_ != ' ') return;
    command('l');
    pair(x - x_, y - y_);
    x_ = x;
    y_ = y;
    ++counts_.segments;
}

void SvgWriter::curve_to(const Cubic& c) {
    const std::array<std::int64_t, 6> to{in_thousandths(c.control_1.x), in_thousandths(c.control_1.y),
                                         in_thousandths(c.control_2.x), in_thousandths(c.control_2.y),
                                         in_thousandths(c.end.x),       in_thousandths(c.end.y)};
    if (is_straight(x_, y_, to)) {
        line_to(c.end);
        return;
    }
    command('c');
    for (std::size_t i = 0; i < 6; i += 2) {
        if (i > 0) out_ << ' ';
        pair(to[i] - x_, to[i + 1] - y_);
    }
    x_ = to[4];
    y_ = to[5];
    ++counts_.segments;
}

void SvgWriter::close() {
    out_ << 'z';
    letter_ = ' ';
}

void SvgWriter::end_shape() { out_ << "\"/>\n"; }

void SvgWriter::end_group() { out_ << "</g>\n"; }

void SvgWriter::end_view() { out_ << "</g>\n"; }

void SvgWriter::finish() {
    out_ << "</svg>\n";
    out_.flush();
    counts_.bytes = out_.bytes();
}

} // namespace hrbfnpr::output
