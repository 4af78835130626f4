// SPDX-License-Identifier: MIT
#include "output/vector/shapes.h"
#include "output/vector/text_out.h"
#include "output/vector/writers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

// All places in a file are thousandths. A curve is written as a straight line if its handles lie off its chord by no
// more than this, and an opacity from `opaque` on is left out: neither makes a difference in the file.
constexpr double straight = 1.5;
constexpr double opaque = 0.9995;

struct Place {
    std::int64_t x, y; // thousandths
};
Place in_file(const dvec2& p) noexcept { return {in_thousandths(p.x), in_thousandths(p.y)}; }

bool is_straight(const Place& from, std::span<const Place> handles, const Place& to) noexcept {
    const auto dx = static_cast<double>(to.x - from.x), dy = static_cast<double>(to.y - from.y);
    const double length = std::hypot(dx, dy);
    return std::all_of(handles.begin(), handles.end(), [&](const Place& handle) {
        const auto hx = static_cast<double>(handle.x - from.x), hy = static_cast<double>(handle.y - from.y);
        const double on = hx * dx + hy * dy;
        return !(std::abs(hx * dy - hy * dx) > straight * length || on < 0.0 || on > length * length);
    });
}

class SvgWriter final : public PageSink, private ShapeSink {
public:
    SvgWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
              PageCounts& counts)
        : out_(writer), settings_(settings), counts_(counts), shapes_(memory, settings) {
        out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
                "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
                "version=\"1.1\" width=\""
             << page.width << "mm\" height=\"" << page.height << "mm\" viewBox=\"0 0 " << page.width << ' '
             << page.height << "\">\n";
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

    void begin_view(const PageView& view) override {
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
    void begin_group(const PageGroup& group) override {
        group_ = group;
        ++groups_;
        ++counts_.groups;
        begin_layer(group.name);
        color("fill", group.ink);
        color("stroke", group.ink);
        out_ << " stroke-width=\"0\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    }
    void path(const PagePath& path) override {
        ++counts_.paths;
        shapes_.shape(path, group_, *this);
    }
    void dot(const PageDot& dot) override {
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
    void text(const PageText& text) override {
        (out_ << "<text x=\"" << text.x << "\" y=\"" << text.y
              << "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" << text.height / capitals_of_size
              << "\">")
                .escaped(text.text)
            << "</text>\n";
    }
    void end_group() override { out_ << "</g>\n"; }
    void end_view() override { out_ << "</g>\n"; }
    void finish() override {
        out_ << "</svg>\n";
        out_.flush();
        counts_.bytes = out_.bytes();
    }

private:
    void begin_fill(double value) override {
        out_ << "<path";
        opacity("fill-opacity", value * static_cast<double>(group_.ink.w));
        out_ << " d=\"";
    }
    void begin_line(double width, drawing::Cap cap, double value) override {
        out_ << "<path fill=\"none\" stroke-width=\"" << width << '"';
        if (cap == drawing::Cap::flat) out_ << " stroke-linecap=\"butt\"";
        opacity("stroke-opacity", value * static_cast<double>(group_.ink.w));
        out_ << " d=\"";
    }
    void move_to(const dvec2& p) override {
        at_ = in_file(p);
        (out_ << 'M').thousandths(at_.x) << ' ';
        out_.thousandths(at_.y);
        letter_ = ' ';
    }
    void line_to(const dvec2& p) override {
        const Place to = in_file(p);
        if (to.x == at_.x && to.y == at_.y && letter_ != ' ') return;
        command('l', {&to, 1});
    }
    void curve_to(const geometry::Cubic& c) override {
        const std::array<Place, 3> to{in_file(c.control_1), in_file(c.control_2), in_file(c.end)};
        if (is_straight(at_, std::span(to).first(2), to[2]))
            line_to(c.end);
        else
            command('c', to);
    }
    void close() override {
        out_ << 'z';
        letter_ = ' ';
    }
    void end_shape() override { out_ << "\"/>\n"; }

    // Writes places from where the pen stands; it then stands at the last one. A letter is not written again.
    void command(char letter, std::span<const Place> places) {
        char before = letter == letter_ ? ' ' : letter;
        for (const Place& p : places) {
            (out_ << before).thousandths(p.x - at_.x) << ' ';
            out_.thousandths(p.y - at_.y);
            before = ' ';
        }
        letter_ = letter;
        at_ = places.back();
        ++counts_.segments;
    }
    void rect(const Frame& frame) {
        out_ << "<rect x=\"" << frame.left << "\" y=\"" << frame.top << "\" width=\"" << frame.right - frame.left
             << "\" height=\"" << frame.bottom - frame.top << '"';
    }
    // An id has letters, digits and '-'.
    void begin_layer(std::string_view name) {
        out_ << "<g id=\"";
        if (views_ > 0) out_ << "view-" << views_ << '-';
        out_ << "layer-" << groups_ << '-';
        for (const char c : name) {
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
            out_ << (plain ? c : '-');
        }
        (out_ << "\" inkscape:groupmode=\"layer\" inkscape:label=\"").escaped(name) << '"';
    }
    void color(const char* property, const glm::vec4& color) {
        std::array<char, 8> text{};
        const auto byte = [](float part) {
            return static_cast<unsigned>(std::clamp(part, 0.0F, 1.0F) * 255.0F + 0.5F);
        };
        std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(color.x), byte(color.y), byte(color.z));
        out_ << ' ' << property << "=\"" << text.data() << '"';
    }
    void opacity(const char* property, double value) {
        if (value < opaque) out_ << ' ' << property << "=\"" << value << '"';
    }

    TextOut out_;
    ShapeSettings settings_;
    PageCounts& counts_;
    Shapes shapes_;
    PageGroup group_;
    glm::vec4 paper_{0.0F}; // the view's paper
    std::int64_t views_ = 0, groups_ = 0;
    Place at_{0, 0};    // where the pen stands
    char letter_ = ' '; // the last command
};

} // namespace

std::unique_ptr<PageSink> svg_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                     const PageSettings& settings, PageCounts& counts) {
    return std::make_unique<SvgWriter>(memory, writer, page, settings.shapes, counts);
}

} // namespace hrbfnpr::output
