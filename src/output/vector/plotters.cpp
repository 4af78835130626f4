// SPDX-License-Identifier: MIT
// Both languages of plotters have a grid of whole units with y up from the page's lower left corner, and a pen that is
// raised, moved and lowered no more often than it must be.
#include "output/vector/pen.h"
#include "output/vector/text_out.h"
#include "output/vector/writers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

// ---- Data of the languages

constexpr double hpgl_units = 40.0; // for each millimetre
constexpr double gcode_units = 1000.0;
// An HPGL instruction has at most this many places, because old plotters have small buffers.
constexpr int most_pairs = 64;
constexpr char end_of_label = '\x03';    // unless DT says otherwise
constexpr double letter_of_height = 0.7; // width of an HPGL letter
constexpr double farthest_unit = 1e15;   // a double tells units apart up to here

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
          feed_(60.0 * settings.plot.speeds.draw), counts_(counts), lines_(memory),
          track_(counts, settings.plot.speeds, {0.0, page.height}) {
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
        draw(lines_.line(path, shapes_.tolerance));
    }
    void dot(const PageDot& dot) override {
        ++counts_.dots;
        draw(lines_.line(dot, pen_width_, shapes_, track_.place()));
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
        is_known_ = false; // a label takes the pen elsewhere
        out_ << "SI";      // width and height of capitals in centimetres
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
        travel(unit_of(line[0]));
        if (!is_down_) { // lines of G-code that lower the pen may have a speed of their own
            if (gcode_)
                write_lines(down_);
            else
                out_ << "PD";
            drawn_ = 0;
        }
        is_down_ = true;
        track_.draw(on_page(at_));
        for (const dvec2& p : line.subspan(1)) {
            const Unit to = unit_of(p);
            if (to == at_) continue;
            if (gcode_) {
                out_ << "G1";
            } else if (drawn_ > 0) {
                out_ << (drawn_ % most_pairs == 0 ? ";\nPD" : ",");
            }
            write_place(to);
            if (gcode_ && drawn_ == 0) out_ << " F" << feed_;
            if (gcode_) out_ << '\n';
            ++drawn_;
            track_.draw(on_page(to));
            at_ = to;
            ++counts_.segments;
        }
    }

    void write_place(const Unit& p) {
        if (gcode_) {
            out_ << " X";
            number(p.x);
            out_ << " Y";
            number(p.y);
        } else {
            out_ << p.x << ',' << p.y;
        }
    }
    // Writes thousandths with a zero before the point, which old plotters want.
    void number(std::int64_t thousandths) {
        if (thousandths < 0) out_ << '-';
        if (thousandths != 0 && std::abs(thousandths) < 1000) out_ << '0';
        out_.thousandths(std::abs(thousandths));
    }
    // Writes '?' for each character that is a control, not ASCII, or ends a comment of G-code.
    void ascii(std::string_view text) {
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte >= 0x80 && byte < 0xC0) continue; // part of a character that has begun
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
    double height_; // the page's height, mm
    ShapeSettings shapes_;
    std::string_view down_, up_; // lines of G-code
    double feed_;                // mm a minute
    PageCounts& counts_;
    PenLines lines_;
    PenTrack track_;
    double pen_width_ = plotter_pen;
    std::uint32_t pen_ = 0; // 0: none was taken up
    Unit at_{0, 0};         // where the pen stands
    bool is_known_ = false; // else it may stand elsewhere
    bool is_down_ = false;
    std::int64_t drawn_ = 0; // places since it was lowered
};

} // namespace

std::unique_ptr<PageSink> plotter_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                         const PageSettings& settings, PageCounts& counts) {
    HRBFNPR_ASSERT(settings.for_plotter());
    return std::make_unique<PlotterWriter>(memory, writer, page, settings, counts);
}

} // namespace hrbfnpr::output
