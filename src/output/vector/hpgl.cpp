// SPDX-License-Identifier: MIT
#include "output/vector/hpgl.h"

namespace hrbfnpr::output {
namespace {

constexpr double hpgl_units_per_mm = 40.0;
constexpr int most_pairs = 64;          // of one instruction: old plotters have small buffers
constexpr char end_of_label = '\x03';   // unless DT says otherwise
constexpr double width_of_height = 0.7; // of characters

} // namespace

HpglWriter::HpglWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const PlotFormat& format,
                       PageCounts& counts)
    : PlotWriter(memory, writer, page, hpgl_units_per_mm, format, counts) {
    out_ << "IN;\n";
}

void HpglWriter::write_pen(const PageGroup& group, bool, bool is_other) {
    if (is_other) out_ << "SP" << std::int64_t{group.pen} << ";\n";
}

void HpglWriter::write_raise() { out_ << ";\nPU;\n"; }

void HpglWriter::write_travel(const Place& to, bool is_down) {
    if (is_down) out_ << ";\n";
    out_ << "PU";
    pair(to);
    out_ << ";\n";
}

void HpglWriter::write_lower() {
    out_ << "PD";
    pairs_ = 0;
}

void HpglWriter::write_draw(const Place& to) {
    if (pairs_ == most_pairs) {
        out_ << ";\nPD";
        pairs_ = 0;
    }
    if (pairs_++ > 0) out_ << ',';
    pair(to);
}

// Width and height of capitals in centimetres.
void HpglWriter::text(const PageText& text) {
    go_to(text.x, text.y);
    out_ << "SI";
    number(0.1 * width_of_height * text.height);
    out_ << ',';
    number(0.1 * text.height);
    out_ << ";LB";
    ascii(text.text, false);
    out_ << end_of_label << '\n';
}

void HpglWriter::write_end() { out_ << "PU;SP0;\n"; }

void HpglWriter::pair(const Place& place) { out_ << place.x << ',' << place.y; }

} // namespace hrbfnpr::output
