// SPDX-License-Identifier: MIT
// SVG 1.1, with Inkscape's layers.
#pragma once

#include "output/vector/shapes.h"
#include "output/vector/text_out.h"

namespace hrbfnpr::output {

class SvgWriter final : public PageSink, private ShapeSink {
public:
    SvgWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
              PageCounts& counts);

    void begin_view(const PageView& view) override;
    void begin_group(const PageGroup& group) override;
    void path(const PagePath& path) override;
    void dot(const PageDot& dot) override;
    void text(const PageText& text) override;
    void end_group() override;
    void end_view() override;
    void finish() override;

private:
    void begin_fill(double opacity) override;
    void begin_line(double width, drawing::Cap cap, double opacity) override;
    void move_to(const glm::dvec2& p) override;
    void line_to(const glm::dvec2& p) override;
    void curve_to(const Cubic& cubic) override;
    void close() override;
    void end_shape() override;

    void header(const PageInfo& page);
    void rect(const Frame& frame);
    void id(std::string_view name);
    void begin_layer(std::string_view name);
    void opacity(const char* property, double value);
    void color(const char* property, const glm::vec4& color);
    void pair(std::int64_t x, std::int64_t y);
    void command(char letter);

    TextOut out_;
    ShapeSettings settings_;
    PageCounts& counts_;
    Shapes shapes_;
    PageGroup group_;
    glm::vec4 paper_{0.0F}; // of the view
    std::int64_t views_ = 0, groups_ = 0;
    std::int64_t x_ = 0, y_ = 0; // where the pen stands, thousandths
    char letter_ = ' ';          // the last command
};

} // namespace hrbfnpr::output
