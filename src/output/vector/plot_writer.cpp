// SPDX-License-Identifier: MIT
#include "output/vector/plot_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

constexpr double farthest = 1e15; // units that a double tells apart

std::int64_t rounded(double number) noexcept {
    return static_cast<std::int64_t>(std::floor(std::clamp(number, -farthest, farthest) + 0.5));
}

} // namespace

PlotWriter::PlotWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, double per_mm,
                       const PlotFormat& format, PageCounts& counts)
    : out_(writer), per_mm_(per_mm), height_(page.height), format_(format), counts_(counts), lines_(memory),
      track_(counts, format.speeds, {0.0, page.height}) {}

PlotWriter::Place PlotWriter::on_grid(const dvec2& p) const noexcept {
    return {rounded(per_mm_ * p.x), rounded(per_mm_ * (height_ - p.y))};
}

dvec2 PlotWriter::on_page(const Place& p) const noexcept {
    return {static_cast<double>(p.x) / per_mm_, height_ - static_cast<double>(p.y) / per_mm_};
}

void PlotWriter::begin_group(const PageGroup& group) {
    raise();
    ++counts_.groups;
    group_ = group;
    if (!(group_.pen_width > 0.0)) group_.pen_width = plotter_pen;
    write_pen(group_, pen_ == 0, pen_ != group.pen);
    pen_ = group.pen;
}

void PlotWriter::path(const PagePath& path) {
    ++counts_.paths;
    draw(lines_.line(path, format_.shapes.tolerance));
}

void PlotWriter::dot(const PageDot& dot) {
    ++counts_.dots;
    draw(lines_.line(dot, group_.pen_width, format_.shapes, track_.place()));
}

void PlotWriter::go_to(double x, double y) {
    raise();
    travel(on_grid({x, y}));
    is_known_ = false;
}

void PlotWriter::thousandths(std::int64_t value) {
    if (value < 0) out_ << '-';
    if (value != 0 && std::abs(value) < 1000) out_ << '0';
    out_.thousandths(std::abs(value));
}

void PlotWriter::raise() {
    if (is_down_) write_raise();
    is_down_ = false;
    track_.raise();
}

void PlotWriter::travel(const Place& to) {
    if (is_known_ && to.x == place_.x && to.y == place_.y) return;
    write_travel(to, is_down_);
    track_.travel(on_page(to));
    place_ = to;
    is_known_ = true;
    is_down_ = false;
}

void PlotWriter::draw(std::span<const dvec2> line) {
    travel(on_grid(line[0]));
    if (!is_down_) write_lower();
    is_down_ = true;
    track_.draw(on_page(place_));
    for (const dvec2& p : line.subspan(1)) {
        const Place to = on_grid(p);
        if (to.x == place_.x && to.y == place_.y) continue;
        write_draw(to);
        track_.draw(on_page(to));
        place_ = to;
        ++counts_.segments;
    }
}

void PlotWriter::ascii(std::string_view text, bool in_parentheses) {
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 && byte < 0xC0) continue; // of a character that has begun
        const bool printed = byte >= 0x20 && byte < 0x7F;
        const bool closes = in_parentheses && (c == '(' || c == ')');
        out_ << (!printed || closes ? '?' : c);
    }
}

void PlotWriter::finish() {
    raise();
    write_end();
    out_.flush();
    counts_.bytes = out_.bytes();
}

} // namespace hrbfnpr::output
