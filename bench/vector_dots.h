// SPDX-License-Identifier: MIT
// The travel of a pen between stipples: in the set's order, sorted, sorted by vpype, and a lower bound.
#pragma once

#include "painter.h"
#include "timing.h"
#include "vector_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <unistd.h>
#include <vector>

namespace bench {

constexpr int dots_size = 2000; // pixels
constexpr std::int64_t dots_wanted = 50'000;

// Stipples of a surface that hides its back, all with the same radius.
[[nodiscard]] inline Style dots_style() {
    Style style(HRBFNPR_PRESET_STIPPLE);
    style.tone = HRBFNPR_TONE_NONE;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
    for (hrbfnpr_layer_style& layer : style.layer) layer.contours = 0;
    return style;
}

// Returns the dots in the order of the set, in mm.
[[nodiscard]] inline std::vector<PageLine> in_the_sets_order(std::vector<Disc> discs, double scale) {
    std::sort(discs.begin(), discs.end(), [](const Disc& a, const Disc& b) { return a.id < b.id; });
    std::vector<PageLine> lines;
    for (const Disc& disc : discs)
        lines.push_back({{scale * static_cast<double>(disc.window[0]), scale * static_cast<double>(disc.window[1])}});
    return lines;
}

// Half the sum of the two nearest distances of all dots: no closed tour is shorter.
class NearestTwo {
public:
    explicit NearestTwo(const std::vector<PageLine>& dots)
        : dots_(dots), cells_(std::max(1, static_cast<int>(std::sqrt(0.5 * static_cast<double>(dots.size()))))),
          inside_(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_)) {
        for (std::size_t i = 0; i < dots.size(); ++i) inside_[at(cell(place(i).x), cell(place(i).y))].push_back(i);
    }
    [[nodiscard]] double bound() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < dots_.size(); ++i) sum += 0.5 * nearest_two(i);
        return sum;
    }

private:
    [[nodiscard]] const PagePlace& place(std::size_t i) const { return dots_[i].front(); }
    [[nodiscard]] int cell(double at) const {
        return std::clamp(static_cast<int>(at / page_side * cells_), 0, cells_ - 1);
    }
    [[nodiscard]] std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * cells_ + x); }

    // Searches rings of cells, until the next ring is farther than the second nearest dot.
    [[nodiscard]] double nearest_two(std::size_t i) const {
        std::array<double, 2> least{1e300, 1e300};
        const int x = cell(place(i).x), y = cell(place(i).y);
        for (int ring = 0; ring < cells_ && (ring - 1) * page_side / cells_ <= least[1]; ++ring)
            for (int v = std::max(y - ring, 0); v <= std::min(y + ring, cells_ - 1); ++v)
                for (int u = std::max(x - ring, 0); u <= std::min(x + ring, cells_ - 1); ++u)
                    if (std::max(std::abs(u - x), std::abs(v - y)) == ring) look(i, inside_[at(u, v)], least);
        return least[0] + least[1];
    }
    void look(std::size_t i, const std::vector<std::size_t>& others, std::array<double, 2>& least) const {
        for (const std::size_t other : others) {
            if (other == i) continue;
            const double far = std::hypot(place(other).x - place(i).x, place(other).y - place(i).y);
            if (far >= least[1]) continue;
            least[1] = std::max(least[0], far);
            least[0] = std::min(least[0], far);
        }
    }

    const std::vector<PageLine>& dots_;
    int cells_;
    std::vector<std::vector<std::size_t>> inside_;
};

// Writes dots as lines of a micrometre, because vpype drops lines without length.
inline void write_for_vpype(const std::vector<PageLine>& dots, const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (file == nullptr) return;
    std::fprintf(file,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%gmm\" height=\"%gmm\" viewBox=\"0 0 %g %g\">\n",
                 page_side, page_side, page_side, page_side);
    for (const PageLine& dot : dots)
        std::fprintf(file, "<line x1=\"%.4f\" y1=\"%.4f\" x2=\"%.4f\" y2=\"%.4f\" stroke=\"black\"/>\n", dot[0].x,
                     dot[0].y, dot[0].x + 0.001, dot[0].y);
    std::fputs("</svg>\n", file);
    std::fclose(file);
}

// Converts the length that vpype's `stat` prints, in pixels of 1/96 inch; negative if it printed none.
[[nodiscard]] inline double vpype_travel(const std::string& command) {
    std::FILE* const said = ::popen(command.c_str(), "r");
    if (said == nullptr) return -1.0;
    double sum = -1.0;
    std::array<char, 256> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), said) != nullptr) {
        double pixels = 0.0;
        if (std::sscanf(line.data(), " Pen-up length: %lf", &pixels) == 1)
            sum = std::max(sum, 0.0) + pixels * 25.4 / 96.0;
    }
    return ::pclose(said) == 0 ? sum : -1.0;
}

inline void compare_with_vpype(const std::vector<PageLine>& dots, double unsorted) {
    if (std::system("command -v vpype >/dev/null 2>&1") != 0) { // NOLINT(cert-env33-c)
        std::puts("dots: vpype is not here, so its linesort is not measured (pipx install vpype)");
        return;
    }
    std::array<char, 32> name{"/tmp/dots_XXXXXX"};
    const int handle = ::mkstemp(name.data());
    if (handle < 0) return;
    ::close(handle);
    const std::string path = name.data();
    write_for_vpype(dots, path);
    double sorted = -1.0;
    const double time = seconds([&] { sorted = vpype_travel("vpype read --no-crop '" + path + "' linesort stat"); });
    std::remove(path.c_str());
    if (sorted < 0.0) {
        std::puts("dots: vpype is here, but did not tell how far its linesort travels");
        return;
    }
    std::printf("dots: vpype linesort travels %.3f m in %.2f s, with its start and its reading\n", 1e-3 * sorted, time);
    report("vector.vpype_travel_ratio", sorted / unsorted);
    report("vector.vpype_seconds", time);
}

// Draws as many visible dots as are wanted, or some more.
inline void sort_dots(hrbfnpr_context* context, const hrbfnpr_model* model, const hrbfnpr_camera& camera) {
    std::int64_t budget = 5 * dots_wanted / 2;
    scenes::PointSet set;
    std::vector<Disc> discs;
    for (; static_cast<std::int64_t>(discs.size()) < dots_wanted; budget += budget / 4) {
        set = generate(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, budget));
        discs = Painter(context, set.get(), dots_style()).discs(camera);
    }
    Painter painter(context, set.get(), dots_style());
    painter.make_drawing(camera);
    Page page(painter.drawing(), dots_size);
    page.dots = HRBFNPR_DOT_SHAPE_LINES;
    page.dot_distance = 1e-6; // drop none
    page.format = HRBFNPR_PAGE_FORMAT_HPGL;
    const std::vector<PageLine> dots = in_the_sets_order(std::move(discs), page.item.scale);
    const double unsorted = travel(dots), bound = NearestTwo(dots).bound();
    std::vector<double> wall, processor;
    hrbfnpr_page_info after{};
    for (int run = 0; run < 3; ++run) {
        const std::clock_t start = std::clock();
        wall.push_back(seconds([&] { after = page.write(context); }));
        processor.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::printf(
        "dots: %zu of a set of %lld in %lld marks on the page; travel in the set's order %.2f m, sorted %.3f m, "
        "at least %.3f m (half the sum of the two nearest distances)\n",
        dots.size(), static_cast<long long>(info_of(set.get()).marks), static_cast<long long>(after.dots),
        1e-3 * unsorted, 1e-3 * after.travelled, 1e-3 * bound);
    compare_with_vpype(dots, unsorted);
    report("vector.pen_travel_ratio", after.travelled / unsorted);
    report("vector.pen_travel_of_bound", after.travelled / bound);
    report("vector.sort_seconds", median(wall));
    report("vector.sort_cpu_seconds", median(processor));
}

} // namespace bench
