// SPDX-License-Identifier: MIT
// A sink that records its calls, and pages made by hand.
#pragma once

#include "base/random.h"
#include "output/vector/shapes.h"

#include <string>
#include <vector>

namespace hrbfnpr::testing {

using Line = std::vector<output::PagePoint>;

struct KeptPath {
    Line points;
    drawing::Cap begin, end;
    bool closed;
    double opacity;
};

struct Record {
    std::string calls;
    std::vector<KeptPath> paths;
    std::vector<output::PageDot> dots;
    double pen_width = 0.0;
};

class Recorder final : public output::PageSink {
public:
    void begin_view(const output::PageView&) override { kept.calls += "view{"; }
    void begin_group(const output::PageGroup& group) override {
        kept.calls += std::string(group.name) + "{";
        kept.pen_width = group.pen_width;
    }
    void path(const output::PagePath& path) override {
        kept.calls += 'p';
        kept.paths.push_back(
            {{path.points.begin(), path.points.end()}, path.begin, path.end, path.closed, path.opacity});
    }
    void dot(const output::PageDot& dot) override {
        kept.calls += 'd';
        kept.dots.push_back(dot);
    }
    void text(const output::PageText& text) override { kept.calls += std::string("'") + text.text + "'"; }
    void end_group() override { kept.calls += '}'; }
    void end_view() override { kept.calls += '}'; }
    void finish() override { kept.calls += '.'; }

    Record kept;
};

// The result of a group.
struct Sorted {
    Record out;
    output::PageCounts counts;
};

inline output::PagePath path_of(const Line& line, bool closed = false) {
    output::PagePath path;
    path.points = line;
    path.closed = closed;
    return path;
}

struct GroupInput {
    std::vector<KeptPath> paths;
    std::vector<output::PageDot> dots;
    output::PageGroup group;

    void add(const Line& line, bool closed = false, double opacity = 1.0) {
        paths.push_back({line, drawing::Cap::round, drawing::Cap::round, closed, opacity});
    }
    void hand_to(output::PageSink& sink) const {
        sink.begin_group(group);
        for (const KeptPath& kept : paths) {
            output::PagePath path = path_of(kept.points, kept.closed);
            path.begin = kept.begin;
            path.end = kept.end;
            path.opacity = kept.opacity;
            sink.path(path);
        }
        for (const output::PageDot& dot : dots) sink.dot(dot);
        sink.end_group();
    }
};

inline output::PageSettings plotter_settings() {
    output::PageSettings settings;
    settings.format = output::PageFormat::hpgl;
    settings.width = 200.0;
    settings.height = 100.0;
    return settings;
}

inline Sorted sorted(const GroupInput& input, const output::PageSettings& settings = plotter_settings()) {
    base::Memory memory;
    Sorted result;
    Recorder out;
    output::PenTrack track(result.counts, {}, {0.0, settings.height});
    const base::Progress progress;
    const auto order = output::plot_order(memory, out, settings, result.counts, &track, progress);
    input.hand_to(*order);
    order->finish();
    result.out = out.kept;
    return result;
}

// Random numbers from 0 to 1 that are the same on every machine.
class Random {
public:
    explicit Random(std::uint64_t seed) : seed_(seed) {}
    double operator()() { return base::uniform4(seed_, count_++, base::Purpose::candidate)[0]; }

private:
    std::uint64_t seed_, count_ = 0;
};

// Curves of this length, anywhere on the page of plotter_settings, as thin lines.
inline GroupInput random_lines(std::uint64_t seed, int count, double length, int points = 8) {
    Random random(seed);
    GroupInput input;
    for (int i = 0; i < count; ++i) {
        double x = 10.0 + 180.0 * random(), y = 10.0 + 80.0 * random(), angle = 6.283185307179586 * random();
        const double bend = 4.0 / points * (random() - 0.5);
        Line line;
        for (int k = 0; k < points; ++k, angle += bend) {
            line.push_back({x, y, 0.1});
            x += length / (points - 1) * std::cos(angle);
            y += length / (points - 1) * std::sin(angle);
        }
        input.add(line);
    }
    return input;
}

inline double between(const output::PagePoint& a, const output::PagePoint& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

inline double length_of(const Line& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += between(line[i - 1], line[i]);
    return sum;
}

// Returns the pen's travel from the page's lower left corner to all paths in order.
inline double travel_of(const std::vector<KeptPath>& paths, output::PagePoint from = {0.0, 100.0, 0.0}) {
    double sum = 0.0;
    for (const KeptPath& path : paths) {
        sum += between(from, path.points.front());
        from = path.points.back();
    }
    return sum;
}

} // namespace hrbfnpr::testing
