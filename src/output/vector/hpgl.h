// SPDX-License-Identifier: MIT
// HPGL, as HP's 7400 series of plotters reads it: 40 units a millimetre.
#pragma once

#include "output/vector/plot_writer.h"

namespace hrbfnpr::output {

class HpglWriter final : public PlotWriter {
public:
    HpglWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const PlotFormat& format,
               PageCounts& counts);

    void text(const PageText& text) override;

private:
    void write_pen(const PageGroup& group, bool is_first, bool is_other) override;
    void write_raise() override;
    void write_travel(const Place& to, bool is_down) override;
    void write_lower() override;
    void write_draw(const Place& to) override;
    void write_end() override;
    void pair(const Place& place);

    int pairs_ = 0; // in the instruction that is open
};

} // namespace hrbfnpr::output
