// SPDX-License-Identifier: MIT
// G-code [ISO 6983-1] for plotters: G0 to travel, G1 to draw, millimetres.
#pragma once

#include "output/vector/plot_writer.h"

namespace hrbfnpr::output {

class GcodeWriter final : public PlotWriter {
public:
    GcodeWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const PlotFormat& format,
                PageCounts& counts);

    void text(const PageText& text) override;

private:
    void write_pen(const PageGroup& group, bool is_first, bool is_other) override;
    void write_raise() override { lines(up_); }
    void write_travel(const Place& to, bool is_down) override;
    void write_lower() override;
    void write_draw(const Place& to) override;
    void write_end() override { out_ << "M2\n"; }
    void lines(std::string_view text);
    void place(const char* command, const Place& to);

    std::string_view down_, up_;
    double feed_;           // mm a minute
    bool says_feed_ = true; // the next G1 does: those that lower the pen may have one of their own
};

} // namespace hrbfnpr::output
