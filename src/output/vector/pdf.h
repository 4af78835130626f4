// SPDX-License-Identifier: MIT
// PDF 1.5: one page, whose groups are optional content.
#pragma once

#include "output/vector/shapes.h"
#include "output/vector/text_out.h"

#include <bitset>

namespace hrbfnpr::output {

class PdfWriter final : public PageSink, private ShapeSink {
public:
    PdfWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
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
    struct Name {
        char text[PageGroup::most];
    };

    void begin_fill(double opacity) override;
    void begin_line(double width, drawing::Cap cap, double opacity) override;
    void move_to(const glm::dvec2& p) override;
    void line_to(const glm::dvec2& p) override;
    void curve_to(const Cubic& cubic) override;
    void close() override;
    void end_shape() override;

    void begin_content(std::string_view name);
    void set_ink(const glm::vec4& ink);
    void set_opacity(double opacity);
    void set_line(double width, drawing::Cap cap);
    void place(const glm::dvec2& p);
    std::int64_t begin_object();
    void end_object();
    void string(std::string_view text);
    void write_catalog(std::int64_t first_group);
    void write_page(std::int64_t first_group);
    void write_information();
    void write_references();

    TextOut out_;
    PageInfo page_;
    ShapeSettings settings_;
    PageCounts& counts_;
    Shapes shapes_;
    PageGroup group_;
    glm::vec4 ink_{-1.0F}; // as set
    glm::vec4 paper_{0.0F};
    double width_ = -1.0;
    int cap_ = -1, alpha_ = -1;
    bool fills_ = false;
    std::bitset<256> alphas_; // that are used
    base::Array<Name> groups_;
    base::Array<std::int64_t> offsets_; // of objects, from the first
    std::int64_t content_ = 0;          // where the stream begins
};

} // namespace hrbfnpr::output
