// SPDX-License-Identifier: MIT
// The base of the writers that write curves: SVG, PDF and DXF.
#pragma once

#include "output/vector/shapes.h"
#include "output/vector/text_out.h"

namespace hrbfnpr::output {

// Decodes the UTF-8 character at text[at] and advances `at` to the next one.
inline std::uint32_t next_character(std::string_view text, std::size_t& at) noexcept {
    const auto lead = static_cast<std::uint8_t>(text[at++]);
    const std::uint32_t more = lead < 0xC0 ? 0U : lead < 0xE0 ? 1U : lead < 0xF0 ? 2U : 3U;
    std::uint32_t code = more == 0 ? lead : lead & (0x3FU >> more);
    for (std::uint32_t i = 0; i < more && at < text.size(); ++i)
        code = code << 6U | (static_cast<std::uint8_t>(text[at++]) & 0x3FU);
    return code;
}

class CurveWriter : public PageSink, protected ShapeSink {
public:
    void path(const PagePath& path) override {
        ++counts_.paths;
        shapes_.shape(path, group_, *this);
    }

protected:
    CurveWriter(base::Memory& memory, io::Writer& writer, const ShapeSettings& settings, PageCounts& counts)
        : out_(writer), settings_(settings), counts_(counts), shapes_(memory, settings) {}

    TextOut out_;
    ShapeSettings settings_;
    PageCounts& counts_;
    Shapes shapes_;
    PageGroup group_;
    glm::vec4 paper_{0.0F}; // the colour of the view's paper
};

// Makes the writer of DXF.
[[nodiscard]] std::unique_ptr<PageSink> make_dxf_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                                        const PageSettings& settings, PageCounts& counts);

} // namespace hrbfnpr::output
