// SPDX-License-Identifier: MIT
// Dashes and dots of lines [ISO 128-2].
#pragma once

#include "base/memory.h"
#include "output/vector/page.h"

namespace hrbfnpr::output {

// Same numbers as HRBFNPR_LINE_TYPE_..., which are those of the standard.
enum class LineType : std::uint32_t { as_drawn = 0, continuous = 1, last = 15 };

// Cuts the lines of groups that have a line type into its dashes, and hands all else on.
class LineTypes final : public PageSink {
public:
    LineTypes(base::Memory& memory, PageSink& next) noexcept : next_(next), part_(memory) {}

    void begin_view(const PageView& view) override { next_.begin_view(view); }
    void begin_group(const PageGroup& group) override;
    void path(const PagePath& path) override;
    void dot(const PageDot& dot) override { next_.dot(dot); }
    void text(const PageText& text) override { next_.text(text); }
    void end_group() override { next_.end_group(); }
    void end_view() override { next_.end_view(); }
    void finish() override { next_.finish(); }

private:
    PageSink& next_;
    PageGroup group_;
    base::Array<PagePoint> part_;
};

} // namespace hrbfnpr::output
