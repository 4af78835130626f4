// SPDX-License-Identifier: MIT
#include "output/vector/gcode.h"

namespace hrbfnpr::output {
namespace {

constexpr double units_per_mm = 1000.0;

} // namespace

GcodeWriter::GcodeWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const PlotFormat& format,
                         PageCounts& counts)
    : PlotWriter(memory, writer, page, units_per_mm, format, counts),
      down_(format.pen_down != nullptr ? format.pen_down : "G1 Z0"),
      up_(format.pen_up != nullptr ? format.pen_up : "G0 Z5"), feed_(60.0 * format.speeds.draw) {
    if (page.title != nullptr && *page.title != '\0') {
        out_ << '(';
        ascii(page.title, true);
        out_ << ")\n";
    }
    out_ << "(hrbfnpr " << page.program << ")\n(" << page.width << " x " << page.height
         << " mm, y up from the lower left corner; texts are left out)\nG21\nG90\nG1 F" << feed_ << '\n';
    lines(up_);
}

void GcodeWriter::write_pen(const PageGroup& group, bool is_first, bool is_other) {
    if (is_other && !is_first) out_ << "M0 ";
    out_ << "(pen " << std::int64_t{group.pen} << ": ";
    ascii(group.name, true);
    out_ << ", ";
    number(group.pen_width);
    out_ << " mm)\n";
}

void GcodeWriter::write_travel(const Place& to, bool is_down) {
    if (is_down) lines(up_);
    place("G0", to);
    out_ << '\n';
}

void GcodeWriter::write_lower() {
    lines(down_);
    says_feed_ = true;
}

void GcodeWriter::write_draw(const Place& to) {
    place("G1", to);
    if (says_feed_) out_ << " F" << feed_;
    says_feed_ = false;
    out_ << '\n';
}

void GcodeWriter::text(const PageText& text) {
    out_ << "(text left out: ";
    ascii(text.text, true);
    out_ << ")\n";
}

void GcodeWriter::lines(std::string_view text) {
    out_ << text;
    if (!text.ends_with('\n')) out_ << '\n';
}

void GcodeWriter::place(const char* command, const Place& to) {
    out_ << command << " X";
    thousandths(to.x);
    out_ << " Y";
    thousandths(to.y);
}

} // namespace hrbfnpr::output
