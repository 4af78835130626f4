// SPDX-License-Identifier: MIT
// The last stages of the pipeline: writers of SVG and PDF, which write lines as curves, and of HPGL and G-code. HPGL
// has straight lines only. Its arcs have centres and angles in whole units, so they end up to a pen's width off.
#include "output/vector/curve_writer.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using glm::dvec2;

// ---- SVG

// Positions in a file are whole thousandths of a millimetre. A curve is written as a straight line if its handles are
// within `straight` thousandths of its chord. An opacity of at least `opaque` is omitted. Neither changes the picture.
constexpr double straight = 1.5;
constexpr double opaque = 0.9995;

struct Place {
    std::int64_t x, y; // in thousandths of a millimetre
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

class SvgWriter final : public CurveWriter {
public:
    SvgWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
              PageCounts& counts)
        : CurveWriter(memory, writer, settings, counts) {
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
    void begin_line(double width, Cap cap, double value) override {
        out_ << "<path fill=\"none\" stroke-width=\"" << width << '"';
        if (cap == Cap::flat) out_ << " stroke-linecap=\"butt\"";
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
    void arc_to(const CurvePiece& arc) override {
        const double radius = glm::distance(arc.centre, arc.end);
        for_parts(arc, arc_tuning.most_sweep_by_radius, [&](const CurvePiece& part) {
            const Place to = in_file(part.end);
            if (1000.0 * radius * (1.0 - std::cos(0.5 * part.sweep)) < straight) {
                line_to(part.end);
                return;
            }
            if (to.x == at_.x && to.y == at_.y) return;
            out_ << (letter_ == 'a' ? ' ' : 'a') << radius << ' ' << radius << " 0 0 "
                 << (part.sweep > 0.0 ? '1' : '0');
            letter_ = ' ';
            command(' ', {&to, 1});
            letter_ = 'a';
        });
    }
    void close() override {
        out_ << 'z';
        letter_ = ' ';
    }
    void end_shape() override { out_ << "\"/>\n"; }

    // Writes places relative to the current point, and makes the last place the current point. A command letter is
    // omitted if it equals the previous one.
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
    // Begins a layer of Inkscape. The id of the layer may contain only letters, digits and '-'.
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

    std::int64_t views_ = 0, groups_ = 0;
    Place at_{0, 0};    // the current point
    char letter_ = ' '; // the previous command letter
};

// ---- PDF

constexpr double points_of_mm = 72.0 / 25.4;
// The numbers of the first PDF objects. Groups have the numbers after these.
enum Object : std::int64_t { content = 1, content_length, catalog, pages, page, information, first_of_groups };

class PdfWriter final : public CurveWriter {
public:
    PdfWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
              PageCounts& counts)
        : CurveWriter(memory, writer, settings, counts), page_(page), groups_(memory), offsets_(memory) {
        out_ << "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n";
        begin_object();
        out_ << "<< /Length " << std::int64_t{content_length} << " 0 R >>\nstream\n";
        content_ = out_.bytes();
        // Sets the units to millimetres from the top-left corner, with y down.
        out_.precise(points_of_mm) << " 0 0 ";
        out_.precise(-points_of_mm) << " 0 ";
        out_.precise(points_of_mm * page.height) << " cm\n1 j\n";
    }

    void begin_view(const PageView& view) override {
        paper_ = view.paper;
        const auto frame = [&] {
            out_ << view.frame.left << ' ' << view.frame.top << ' ' << view.frame.right - view.frame.left << ' '
                 << view.frame.bottom - view.frame.top << " re\n";
        };
        out_ << "q\n";
        frame();
        out_ << "W n\n";
        if (!view.with_paper || !(paper_.w > 0.0F)) return;
        begin_content("paper");
        set_ink(paper_);
        set_opacity(static_cast<double>(paper_.w));
        frame();
        out_ << "f\nEMC\n";
    }
    void begin_group(const PageGroup& group) override {
        group_ = group;
        ++counts_.groups;
        begin_content(group.name);
        set_ink(group.ink);
    }
    // A disc is written as a line of zero length with round ends.
    void dot(const PageDot& dot) override {
        ++counts_.dots;
        set_ink(dot.is_paper ? paper_ : group_.ink);
        if (settings_.dots_of(group_.pen_width) != DotShapes::circles) {
            shapes_.shape(dot, group_, *this);
            return;
        }
        begin_line(2.0 * dot.radius, Cap::round, dot.opacity);
        move_to({dot.x, dot.y});
        line_to({dot.x, dot.y});
        end_shape();
    }
    // Every PDF viewer has Helvetica with Latin letters. Other characters become '?'.
    void text(const PageText& text) override {
        set_ink(group_.ink);
        set_opacity(static_cast<double>(group_.ink.w));
        out_ << "BT /F1 " << text.height / capitals_of_size << " Tf 1 0 0 -1 " << text.x << ' ' << text.y << " Tm (";
        const std::string_view all = text.text;
        for (std::size_t at = 0; at < all.size();) {
            const std::uint32_t code = next_character(all, at);
            const bool known = (code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code < 0x100);
            const char c = known ? static_cast<char>(static_cast<std::uint8_t>(code)) : '?';
            if (c == '(' || c == ')' || c == '\\') out_ << '\\';
            out_ << c;
        }
        out_ << ") Tj ET\n";
    }
    void end_group() override { out_ << "EMC\n"; }
    // "Q" restores the graphics state from before the view, so the cached state is reset.
    void end_view() override {
        out_ << "Q\n";
        ink_ = glm::vec4(-1.0F);
        width_ = -1.0;
        cap_ = alpha_ = -1;
    }
    void finish() override {
        const std::int64_t length = out_.bytes() - content_;
        out_ << "\nendstream";
        end_object();
        begin_object();
        out_ << length;
        end_object();
        begin_object();
        out_ << "<< /Type /Catalog /Pages " << std::int64_t{pages} << " 0 R /PageMode /UseOC /OCProperties << /OCGs [";
        const auto list = [&] {
            for (std::int64_t i = 0; i < groups_.size(); ++i) out_ << ' ' << first_of_groups + i << " 0 R";
        };
        list();
        out_ << " ] /D << /Order [";
        list();
        out_ << " ] /ON [";
        list();
        out_ << " ] >> >> >>";
        end_object();
        begin_object();
        out_ << "<< /Type /Pages /Count 1 /Kids [ " << std::int64_t{page} << " 0 R ] >>";
        end_object();
        begin_object();
        out_ << "<< /Type /Page /Parent " << std::int64_t{pages} << " 0 R /MediaBox [ 0 0 "
             << points_of_mm * page_.width << ' ' << points_of_mm * page_.height << " ] /Contents "
             << std::int64_t{content}
             << " 0 R\n/Resources << /Font << /F1 << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding "
                "/WinAnsiEncoding >> >>\n/ExtGState <<";
        for (std::size_t i = 0; i < alphas_.size(); ++i)
            if (alphas_.test(i))
                out_ << " /A" << static_cast<std::int64_t>(i) << " << /ca " << static_cast<double>(i) / 255.0 << " /CA "
                     << static_cast<double>(i) / 255.0 << " >>";
        out_ << " >>\n/Properties <<";
        for (std::int64_t i = 0; i < groups_.size(); ++i)
            out_ << " /G" << i + 1 << ' ' << first_of_groups + i << " 0 R";
        out_ << " >> >> >>";
        end_object();
        begin_object();
        out_ << "<< /Producer (hrbfnpr " << page_.program << ')';
        const auto entry = [&](const char* name, const char* text) {
            if (text == nullptr || *text == '\0') return;
            out_ << ' ' << name << ' ';
            string(text);
        };
        entry("/Title", page_.title);
        entry("/Subject", page_.description);
        entry("/Keywords", page_.metadata);
        out_ << " >>";
        end_object();
        for (const Name& name : groups_) {
            begin_object();
            out_ << "<< /Type /OCG /Name ";
            string(name.text);
            out_ << " >>";
            end_object();
        }
        const std::int64_t start = out_.bytes();
        out_ << "xref\n0 " << offsets_.size() + 1 << "\n0000000000 65535 f \n";
        for (const std::int64_t offset : offsets_) {
            std::array<char, 11> digits{};
            std::int64_t rest = offset;
            for (std::size_t i = 10; i-- > 0; rest /= 10) digits[i] = static_cast<char>('0' + rest % 10);
            out_ << digits.data() << " 00000 n \n";
        }
        out_ << "trailer\n<< /Size " << offsets_.size() + 1 << " /Root " << std::int64_t{catalog} << " 0 R /Info "
             << std::int64_t{information} << " 0 R >>\nstartxref\n"
             << start << "\n%%EOF\n";
        out_.flush();
        counts_.bytes = out_.bytes();
    }

private:
    void begin_fill(double opacity) override {
        set_opacity(opacity * static_cast<double>(group_.ink.w));
        fills_ = true;
    }
    void begin_line(double width, Cap cap, double opacity) override {
        set_opacity(opacity * static_cast<double>(group_.ink.w));
        set_line(width, cap);
        fills_ = false;
    }
    void move_to(const dvec2& p) override {
        place(p);
        out_ << " m\n";
    }
    void line_to(const dvec2& p) override {
        place(p);
        out_ << " l\n";
        ++counts_.segments;
    }
    void curve_to(const geometry::Cubic& cubic) override {
        place(cubic.control_1);
        out_ << ' ';
        place(cubic.control_2);
        out_ << ' ';
        place(cubic.end);
        out_ << " c\n";
        ++counts_.segments;
    }
    // PDF has no arcs, so make_writer() asks for none.
    void arc_to(const CurvePiece&) override { HRBFNPR_ASSERT(false); }
    void close() override { out_ << "h\n"; }
    void end_shape() override { out_ << (fills_ ? "f\n" : "S\n"); }

    std::int64_t begin_object() {
        offsets_.push_back(out_.bytes());
        out_ << offsets_.size() << " 0 obj\n";
        return offsets_.size();
    }
    void end_object() { out_ << "\nendobj\n"; }
    // Writes a string in UTF-16, as titles and names need.
    void string(std::string_view text) {
        constexpr std::string_view digits = "0123456789ABCDEF";
        const auto unit = [&](std::uint32_t code) {
            for (int shift = 12; shift >= 0; shift -= 4) out_ << digits[code >> static_cast<unsigned>(shift) & 15U];
        };
        out_ << "<FEFF";
        for (std::size_t at = 0; at < text.size();) {
            const std::uint32_t code = next_character(text, at);
            if (code < 0x10000) {
                unit(code);
            } else {
                unit(0xD800 + ((code - 0x10000) >> 10U));
                unit(0xDC00 + ((code - 0x10000) & 0x3FFU));
            }
        }
        out_ << '>';
    }
    void begin_content(std::string_view name) {
        Name kept{};
        name.copy(kept.text, sizeof kept.text - 1);
        groups_.push_back(kept);
        out_ << "/OC /G" << groups_.size() << " BDC\n";
    }
    void set_ink(const glm::vec4& ink) {
        if (glm::vec3(ink) == glm::vec3(ink_)) return;
        ink_ = ink;
        for (const char* operation : {" rg\n", " RG\n"}) {
            out_ << static_cast<double>(ink.x) << ' ' << static_cast<double>(ink.y) << ' '
                 << static_cast<double>(ink.z);
            out_ << operation;
        }
    }
    void set_opacity(double opacity) {
        const auto alpha = static_cast<int>(std::clamp(opacity, 0.0, 1.0) * 255.0 + 0.5);
        if (alpha == alpha_) return;
        alpha_ = alpha;
        alphas_.set(static_cast<std::size_t>(alpha));
        out_ << "/A" << std::int64_t{alpha} << " gs\n";
    }
    void set_line(double width, Cap cap) {
        if (width != width_) out_ << width << " w\n";
        width_ = width;
        const int number = cap == Cap::round ? 1 : 0;
        if (number != cap_) out_ << std::int64_t{number} << " J\n";
        cap_ = number;
    }
    void place(const dvec2& p) { out_ << p.x << ' ' << p.y; }

    struct Name {
        char text[PageGroup::most];
    };

    PageInfo page_;
    glm::vec4 ink_{-1.0F}; // the ink that was set last in the file
    double width_ = -1.0;
    int cap_ = -1, alpha_ = -1;
    bool fills_ = false;
    std::bitset<256> alphas_; // the alphas that the file uses
    base::Array<Name> groups_;
    base::Array<std::int64_t> offsets_; // the byte offset of each object in the file, from object 1 on
    std::int64_t content_ = 0;          // the byte offset of the content stream
};

// ---- HPGL and G-code

// HPGL and G-code use a pen, and a grid of whole units with y up from the page's lower left corner. The pen is raised,
// moved and lowered only when needed.

constexpr double hpgl_units = 40.0; // units per millimetre
constexpr double gcode_units = 1000.0;
// The largest number of places in an HPGL instruction. It is small because old plotters have small buffers.
constexpr int most_pairs = 64;
constexpr char end_of_label = '\x03';    // the default terminator of labels; the instruction DT could change it
constexpr double letter_of_height = 0.7; // the width of an HPGL letter, as a share of its height
constexpr double farthest_unit = 1e15;   // the largest number of units that a double represents exactly

struct Unit {
    std::int64_t x, y;
    [[nodiscard]] bool operator==(const Unit& other) const noexcept { return x == other.x && y == other.y; }
};

std::int64_t whole_units(double number) noexcept {
    return static_cast<std::int64_t>(std::floor(std::clamp(number, -farthest_unit, farthest_unit) + 0.5));
}

class PlotterWriter final : public PageSink {
public:
    PlotterWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const PageSettings& settings,
                  PageCounts& counts)
        : gcode_(settings.format == PageFormat::gcode), units_(gcode_ ? gcode_units : hpgl_units), out_(writer),
          height_(page.height), shapes_(settings.shapes),
          down_(settings.plot.pen_down != nullptr ? settings.plot.pen_down : "G1 Z0"),
          up_(settings.plot.pen_up != nullptr ? settings.plot.pen_up : "G0 Z5"),
          feed_(60.0 * settings.plot.speeds.draw), counts_(counts), lines_(memory), curves_(memory),
          is_straight_(!gcode_ || shapes_.curves == Curves::lines),
          track_(counts, settings.plot.speeds, {0.0, page.height}, settings.plot.longest) {
        if (!gcode_) {
            out_ << "IN;\n";
            return;
        }
        if (page.title != nullptr && *page.title != '\0') {
            out_ << '(';
            ascii(page.title);
            out_ << ")\n";
        }
        out_ << "(hrbfnpr " << page.program << ")\n(" << page.width << " x " << page.height
             << " mm, y up from the lower left corner; texts are left out)\nG21\nG90\nG1 F" << feed_ << '\n';
        write_lines(up_);
    }

    void begin_view(const PageView&) override {}
    void begin_group(const PageGroup& group) override {
        raise();
        ++counts_.groups;
        pen_width_ = group.pen_width > 0.0 ? group.pen_width : plotter_pen;
        if (gcode_) {
            if (pen_ != group.pen && pen_ != 0) out_ << "M0 ";
            out_ << "(pen " << std::int64_t{group.pen} << ": ";
            ascii(group.name);
            out_ << ", ";
            number(in_thousandths(pen_width_));
            out_ << " mm)\n";
        } else if (pen_ != group.pen) {
            out_ << "SP" << std::int64_t{group.pen} << ";\n";
        }
        pen_ = group.pen;
    }
    void path(const PagePath& path) override {
        ++counts_.paths;
        if (track_.is_too_long(length_of(path.points))) raise();
        if (is_straight_)
            draw(lines_.line(path, shapes_.tolerance));
        else
            draw(lines_.places(path), path.closed);
    }
    void dot(const PageDot& dot) override {
        ++counts_.dots;
        const std::span<const dvec2> line = lines_.line(dot, pen_width_, shapes_, track_.place());
        if (is_straight_)
            draw(line);
        else
            draw(line, line.size() > 2 && line.front() == line.back());
    }
    void text(const PageText& text) override {
        if (gcode_) {
            out_ << "(text left out: ";
            ascii(text.text);
            out_ << ")\n";
            return;
        }
        raise();
        travel(unit_of({text.x, text.y}));
        is_known_ = false; // writing a label moves the pen to an unknown place
        // SI sets the width and height of capitals, in centimetres.
        out_ << "SI";
        number(in_thousandths(0.1 * letter_of_height * text.height));
        out_ << ',';
        number(in_thousandths(0.1 * text.height));
        out_ << ";LB";
        ascii(text.text);
        out_ << end_of_label << '\n';
    }
    void end_group() override {}
    void end_view() override {}
    void finish() override {
        raise();
        out_ << (gcode_ ? "M2\n" : "PU;SP0;\n");
        out_.flush();
        counts_.bytes = out_.bytes();
    }

private:
    [[nodiscard]] Unit unit_of(const dvec2& p) const noexcept {
        return {whole_units(units_ * p.x), whole_units(units_ * (height_ - p.y))};
    }
    [[nodiscard]] dvec2 on_page(const Unit& p) const noexcept {
        return {static_cast<double>(p.x) / units_, height_ - static_cast<double>(p.y) / units_};
    }

    void raise() {
        if (is_down_ && gcode_) write_lines(up_);
        if (is_down_ && !gcode_) out_ << ";\nPU;\n";
        is_down_ = false;
        track_.raise();
    }
    void travel(const Unit& to) {
        if (is_known_ && to == at_) return;
        if (is_down_ && gcode_) write_lines(up_);
        if (is_down_ && !gcode_) out_ << ";\n";
        out_ << (gcode_ ? "G0" : "PU");
        write_place(to);
        out_ << (gcode_ ? "\n" : ";\n");
        track_.travel(on_page(to));
        at_ = to;
        is_known_ = true;
        is_down_ = false;
    }
    void draw(std::span<const dvec2> line) {
        HRBFNPR_ASSERT(!line.empty());
        lower_at(line[0]);
        for (const dvec2& p : line.subspan(1)) line_to(p);
    }
    // Draws curves through the points.
    void draw(std::span<const dvec2> points, bool closed) {
        const CurveLine line = shapes_.curves == Curves::arcs
                                   ? curves_.fit_arcs(points, shapes_.tolerance, closed)
                                   : curves_.fit(points, shapes_.tolerance, closed, shapes_.curves);
        lower_at(line.start);
        for (const CurvePiece& piece : line.pieces) switch (piece.kind) {
            case CurvePiece::Kind::line: line_to(piece.end); break;
            case CurvePiece::Kind::arc:
                for_parts(piece, arc_tuning.most_sweep_by_centre, [&](const CurvePiece& part) { arc_to(part); });
                break;
            case CurvePiece::Kind::cubic: cubic_to(piece); break;
            }
    }
    void lower_at(const dvec2& place) {
        travel(unit_of(place));
        if (!is_down_) { // the feed rate is set later, because the G-code that lowers the pen may change it
            if (gcode_)
                write_lines(down_);
            else
                out_ << "PD";
            drawn_ = 0;
        }
        is_down_ = true;
        track_.draw(on_page(at_));
    }
    void line_to(const dvec2& p) {
        const Unit to = unit_of(p);
        if (to == at_) return;
        if (gcode_) {
            out_ << "G1";
        } else if (drawn_ > 0) {
            out_ << (drawn_ % most_pairs == 0 ? ";\nPD" : ",");
        }
        write_place(to);
        end_move(to, glm::distance(on_page(at_), on_page(to)));
    }
    // Writes an arc of at most half a turn. The centre is relative to the pen. The page's y axis points down, so a
    // positive sweep is clockwise on the paper.
    void arc_to(const CurvePiece& arc) {
        const Unit to = unit_of(arc.end), centre = unit_of(arc.centre);
        const dvec2 from = on_page(at_) - on_page(centre), out = on_page(to) - on_page(centre);
        const double radius = glm::length(from);
        // An arc that is so short or flat that rounding decides about it is a line.
        const double turn = std::atan2(from.x * out.y - from.y * out.x, glm::dot(from, out));
        if (units_ * radius * (1.0 - std::cos(0.5 * arc.sweep)) < straight ||
            std::abs(turn) < 0.5 * std::abs(arc.sweep)) {
            line_to(arc.end);
            return;
        }
        out_ << (arc.sweep > 0.0 ? "G2" : "G3");
        write_place(to);
        word('I', centre.x - at_.x);
        word('J', centre.y - at_.y);
        end_move(to, radius * std::abs(turn));
    }
    // Writes a cubic. The first handle is relative to the pen, and the second one to the end.
    void cubic_to(const CurvePiece& cubic) {
        const Unit to = unit_of(cubic.end), first = unit_of(cubic.control_1), second = unit_of(cubic.control_2);
        const std::array<Place, 2> handles{Place{first.x, first.y}, Place{second.x, second.y}};
        if (is_straight({at_.x, at_.y}, handles, {to.x, to.y})) {
            line_to(cubic.end);
            return;
        }
        out_ << "G5";
        write_place(to);
        word('I', first.x - at_.x);
        word('J', first.y - at_.y);
        word('P', second.x - to.x);
        word('Q', second.y - to.y);
        const geometry::Cubic written{on_page(first), on_page(second), on_page(to)};
        double length = 0.0;
        constexpr int chords = 16;
        for (int i = 0; i < chords; ++i)
            length += glm::distance(geometry::point_on_cubic(on_page(at_), written, i / double{chords}),
                                    geometry::point_on_cubic(on_page(at_), written, (i + 1) / double{chords}));
        end_move(to, length);
    }
    void end_move(const Unit& to, double length) {
        if (gcode_ && drawn_ == 0) out_ << " F" << feed_;
        if (gcode_) out_ << '\n';
        ++drawn_;
        track_.draw(on_page(to), length);
        at_ = to;
        ++counts_.segments;
    }

    void word(char letter, std::int64_t thousandths) {
        out_ << ' ' << letter;
        number(thousandths);
    }
    void write_place(const Unit& p) {
        if (gcode_) {
            word('X', p.x);
            word('Y', p.y);
        } else {
            out_ << p.x << ',' << p.y;
        }
    }
    // Writes thousandths with a zero before the decimal point, because old plotters need this zero.
    void number(std::int64_t thousandths) {
        if (thousandths < 0) out_ << '-';
        if (thousandths != 0 && std::abs(thousandths) < 1000) out_ << '0';
        out_.thousandths(std::abs(thousandths));
    }
    // Writes '?' for each control character, for each character outside ASCII, and for each parenthesis in a G-code
    // comment.
    void ascii(std::string_view text) {
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte >= 0x80 && byte < 0xC0) continue; // a continuation byte of UTF-8
            const bool printed = byte >= 0x20 && byte < 0x7F;
            const bool closes = gcode_ && (c == '(' || c == ')');
            out_ << (!printed || closes ? '?' : c);
        }
    }
    void write_lines(std::string_view text) {
        out_ << text;
        if (!text.ends_with('\n')) out_ << '\n';
    }

    bool gcode_;
    double units_;
    TextOut out_;
    double height_; // the page's height, in mm
    ShapeSettings shapes_;
    std::string_view down_, up_; // lines of G-code that lower and raise the pen
    double feed_;                // in mm per minute
    PageCounts& counts_;
    PenLines lines_;
    CurvePieces curves_;
    bool is_straight_; // whether all moves are straight
    PenTrack track_;
    double pen_width_ = plotter_pen;
    std::uint32_t pen_ = 0; // 0: no pen was selected yet
    Unit at_{0, 0};         // the pen's position
    bool is_known_ = false; // whether at_ is the pen's position
    bool is_down_ = false;
    std::int64_t drawn_ = 0; // the number of places since the pen was lowered
};

} // namespace

std::unique_ptr<PageSink> make_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                      const PageSettings& settings, PageCounts& counts) {
    if (settings.for_plotter()) return std::make_unique<PlotterWriter>(memory, writer, page, settings, counts);
    if (settings.format == PageFormat::dxf) return make_dxf_writer(memory, writer, page, settings, counts);
    if (settings.format == PageFormat::pdf) {
        ShapeSettings shapes = settings.shapes;
        if (shapes.curves == Curves::arcs) shapes.curves = Curves::splines;
        return std::make_unique<PdfWriter>(memory, writer, page, shapes, counts);
    }
    return std::make_unique<SvgWriter>(memory, writer, page, settings.shapes, counts);
}

} // namespace hrbfnpr::output
