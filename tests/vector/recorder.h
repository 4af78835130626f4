// SPDX-License-Identifier: MIT
// A sink that keeps what it is given.
#pragma once

#include "output/vector/page.h"

#include <cmath>
#include <string>
#include <vector>

namespace hrbfnpr::testing {

struct KeptPath {
    std::vector<output::PagePoint> points;
    drawing::Cap begin, end;
    bool closed;
    double opacity;

    [[nodiscard]] double length() const {
        double sum = 0.0;
        for (std::size_t i = 1; i < points.size(); ++i)
            sum += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
        return sum;
    }
};

struct KeptGroup {
    output::PageGroup group;
    std::vector<KeptPath> paths;
    std::vector<output::PageDot> dots;
    std::vector<std::string> texts;
};

class Recorder final : public output::PageSink {
public:
    void begin_view(const output::PageView& view) override { views.push_back(view); }
    void begin_group(const output::PageGroup& group) override { groups.push_back({group, {}, {}, {}}); }
    void path(const output::PagePath& path) override {
        groups.back().paths.push_back(
            {{path.points.begin(), path.points.end()}, path.begin, path.end, path.closed, path.opacity});
    }
    void dot(const output::PageDot& dot) override { groups.back().dots.push_back(dot); }
    void text(const output::PageText& text) override { groups.back().texts.emplace_back(text.text); }
    void end_group() override {}
    void end_view() override {}
    void finish() override { finished = true; }

    std::vector<output::PageView> views;
    std::vector<KeptGroup> groups;
    bool finished = false;
};

} // namespace hrbfnpr::testing
