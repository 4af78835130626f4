// SPDX-License-Identifier: MIT
// How often the curves of a view are whole and their visibility is consistent, and how long that takes.
#pragma once

#include "line_models.h"
#include "timing.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {

// Sums over all cameras around one surface or several.
struct Views {
    std::int64_t views = 0, valid = 0;
    std::int64_t curves = 0, cusps = 0, crossings = 0;
    std::int64_t refined = 0, settled = 0, broken = 0, contradictions = 0;
    std::vector<double> ms;
    std::vector<std::string> bad; // descriptions of views that are not valid

    void add(const Views& other) {
        views += other.views;
        valid += other.valid;
        curves += other.curves;
        cusps += other.cusps;
        crossings += other.crossings;
        refined += other.refined;
        settled += other.settled;
        broken += other.broken;
        contradictions += other.contradictions;
        ms.insert(ms.end(), other.ms.begin(), other.ms.end());
        bad.insert(bad.end(), other.bad.begin(), other.bad.end());
    }
};

// Returns the value that the given share of all values do not exceed.
[[nodiscard]] inline double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(share * last + 0.5)];
}

[[nodiscard]] inline double line_ms(const hrbfnpr_drawing_info& info) {
    return 1e-6 * static_cast<double>(info.nanoseconds_lines);
}

[[nodiscard]] inline bool is_valid(const hrbfnpr_drawing_info& info) {
    return info.line_settled == 0 && info.line_broken == 0 && info.line_contradictions == 0;
}

inline void count(Views& all, const hrbfnpr_drawing_info& info, const std::string& name) {
    ++all.views;
    all.curves += info.line_curves;
    all.cusps += info.line_cusps;
    all.crossings += info.line_crossings;
    all.refined += info.line_refined;
    all.settled += info.line_settled;
    all.broken += info.line_broken;
    all.contradictions += info.line_contradictions;
    all.ms.push_back(line_ms(info));
    if (is_valid(info)) {
        ++all.valid;
        return;
    }
    all.bad.push_back(name + ": settled " + std::to_string(info.line_settled) + ", broken " +
                      std::to_string(info.line_broken) + ", contradictions " +
                      std::to_string(info.line_contradictions));
}

// Describes a view in messages.
[[nodiscard]] inline std::string view_name(const std::string& model, const glm::dvec3& direction) {
    char text[128];
    std::snprintf(text, sizeof text, "%s, along (%.3g %.3g %.3g)", model.c_str(), direction.x, direction.y,
                  direction.z);
    return text;
}

// Draws from the corners, edges and faces of a cube, with cameras of 0.5 radians; each view starts with a new renderer.
// Calls `look` with each painter that has drawn, and its camera.
template <class Look>
[[nodiscard]] Views draw_views(hrbfnpr_context* context, const LineModel& model, Look&& look) {
    const hrbfnpr_model_info info = info_of(model.model.get());
    LinePainter painter(context, model.marks.get(), model.lines.get());
    Views all;
    for (const glm::dvec3& direction : cube_directions()) {
        const hrbfnpr_camera camera = camera_of(info.bounds_min, info.bounds_max, direction, 0.5);
        painter.begin_anew();
        painter.draw(camera);
        count(all, painter.info(), view_name(model.name, direction));
        look(painter, camera);
    }
    return all;
}

inline void print_head() {
    std::printf("%-24s %8s %9s %9s %7s %7s %9s %8s %8s %7s %14s %8s %8s\n", "model", "centres", "triangles", "valid",
                "curves", "cusps", "crossings", "refined", "settled", "broken", "contradictions", "ms", "p90 ms");
}

inline void print(const std::string& name, std::int64_t centres, std::int64_t triangles, const Views& v) {
    const auto number = [](std::int64_t n) { return static_cast<long long>(n); };
    std::printf("%-24s %8lld %9lld %4lld of %2lld %6lld %7lld %9lld %8lld %8lld %7lld %14lld %8.1f %8.1f\n",
                name.c_str(), number(centres), number(triangles), number(v.valid), number(v.views), number(v.curves),
                number(v.cusps), number(v.crossings), number(v.refined), number(v.settled), number(v.broken),
                number(v.contradictions), quantile(v.ms, 0.5), quantile(v.ms, 0.9));
    std::fflush(stdout);
}

} // namespace bench
