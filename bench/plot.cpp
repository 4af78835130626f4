// SPDX-License-Identifier: MIT
// Pages for plotters: how far a pen travels before and after sorting, and what sorting costs.
// --model=FILE: a PLY of points with normals to draw as well.
#include "hatch_pictures.h"
#include "read_models.h"
#include "scenes/shapes.h"
#include "timing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using bench::DrawnStroke;
using scenes::made;

constexpr double page_width = 180.0, page_height = 180.0; // mm

struct Point {
    double x, y; // mm, y down
};
using Line = std::vector<Point>;

// Without a page.
std::int32_t count_bytes(void* user, const void*, std::uint64_t size) {
    *static_cast<std::uint64_t*>(user) += size;
    return 0;
}

hrbfnpr_page_info write(hrbfnpr_context* context, const hrbfnpr_page_desc& desc) {
    scenes::Check check;
    auto info = made(hrbfnpr_page_info_init);
    std::uint64_t bytes = 0;
    check(hrbfnpr_page_write(context, &desc, count_bytes, &bytes, &info, nullptr, check.error()));
    return info;
}

// Between the lines, from the lower left corner.
double travel(const std::vector<Line>& lines) {
    Point pen{0.0, page_height};
    double sum = 0.0;
    for (const Line& line : lines) {
        sum += std::hypot(line.front().x - pen.x, line.front().y - pen.y);
        pen = line.back();
    }
    return sum;
}

// What a plotter takes at the speeds of a page.
double plotter_hours(const hrbfnpr_page_desc& desc, double drawn, double travelled, std::size_t lifts) {
    return (drawn / desc.draw_speed + travelled / desc.travel_speed +
            2.0 * desc.pen_seconds * static_cast<double>(lifts)) /
           3600.0;
}

void print(const std::string& name, const hrbfnpr_page_desc& desc, const std::vector<Line>& before,
           const hrbfnpr_page_info& after, const bench::Comparison& time) {
    const double unsorted = travel(before);
    std::printf(
        "%s: %zu lines, %lld joined, %lld lines and %lld dots dropped: %lld lines of %.2f m, travel %.2f m, was %.2f "
        "m; %.2f h, were %.2f h; sorted HPGL in %.3f s, SVG in %.3f s\n",
        name.c_str(), before.size(), static_cast<long long>(after.joined), static_cast<long long>(after.dropped_paths),
        static_cast<long long>(after.dropped_dots), static_cast<long long>(after.paths), 1e-3 * after.drawn,
        1e-3 * after.travelled, 1e-3 * unsorted, after.seconds / 3600.0,
        plotter_hours(desc, after.drawn, unsorted, before.size()), time.seconds, time.seconds * time.ratio);
}

bench::Comparison sorting(hrbfnpr_context* context, hrbfnpr_page_desc desc, int runs) {
    return bench::compare(
        runs,
        [&] {
            desc.format = HRBFNPR_PAGE_FORMAT_SVG;
            write(context, desc);
        },
        [&] {
            desc.format = HRBFNPR_PAGE_FORMAT_HPGL;
            write(context, desc);
        });
}

// Short curves anywhere, as many of which fill the page alike.
std::vector<Line> random_lines(int count) {
    std::mt19937 engine(1);
    const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    const double step = 0.1 * page_width / std::sqrt(count);
    std::vector<Line> lines;
    for (int i = 0; i < count; ++i) {
        Point p{page_width * (0.05 + 0.9 * random()), page_height * (0.05 + 0.9 * random())};
        double angle = 2.0 * std::numbers::pi * random();
        const double bend = 0.5 * (random() - 0.5);
        Line line;
        for (int k = 0; k < 8; ++k, angle += bend) {
            line.push_back(p);
            p = {p.x + step * std::cos(angle), p.y + step * std::sin(angle)};
        }
        lines.push_back(line);
    }
    return lines;
}

void sort_random_lines(hrbfnpr_context* context) {
    for (const int count : {1000, 10000, 100000}) {
        const std::vector<Line> lines = random_lines(count);
        std::vector<hrbfnpr_annotation> annotations;
        for (const Line& line : lines) {
            annotations.push_back(made(hrbfnpr_annotation_init));
            annotations.back().points = {line.data(), static_cast<std::int64_t>(line.size()), 0, HRBFNPR_SCALAR_FLOAT64,
                                         2};
        }
        auto desc = made(hrbfnpr_page_desc_init);
        desc.width = page_width;
        desc.height = page_height;
        desc.annotations = annotations.data();
        desc.annotation_count = count;
        desc.join = desc.shortest = 1e-6; // only sorted
        desc.format = HRBFNPR_PAGE_FORMAT_HPGL;
        const hrbfnpr_page_info after = write(context, desc);
        const bench::Comparison time = sorting(context, desc, 3);
        const std::string name = "random_" + std::to_string(count);
        print(name, desc, lines, after, time);
        bench::report((name + "_travel").c_str(), after.travelled / travel(lines));
        // A random tour's length over this root tends to 0.7124 at best for dots; for lines it is less.
        const double root = std::sqrt(count * 0.9 * page_width * 0.9 * page_height);
        bench::report((name + "_travel_of_root").c_str(), after.travelled / root);
        bench::report((name + "_seconds_of_svg").c_str(), 1.0 / time.ratio);
    }
}

void plot_model(hrbfnpr_context* context, const std::string& name, const scenes::Model& model) {
    constexpr int size = 1200;
    const scenes::PointSet set = bench::hatch_set(context, model.get(), HRBFNPR_PRESET_ETCHING);
    bench::StrokePainter painter(context, set.get(), bench::hatch_style(HRBFNPR_PRESET_ETCHING, size));
    const hrbfnpr_point_set_info info = bench::info_of(set.get());
    painter.draw(bench::square_camera(info.bounds_min, info.bounds_max, {-0.3, -0.2, -1.0}, size));
    auto item = made(hrbfnpr_page_item_init);
    item.drawing = painter.drawing();
    item.scale = page_width / size;
    std::vector<Line> lines;
    for (const DrawnStroke& stroke : painter.strokes()) {
        lines.emplace_back();
        for (const bench::StrokePoint& p : stroke)
            lines.back().push_back({item.scale * static_cast<double>(p.x), item.scale * static_cast<double>(p.y)});
    }
    auto desc = made(hrbfnpr_page_desc_init);
    desc.items = &item;
    desc.item_count = 1;
    desc.format = HRBFNPR_PAGE_FORMAT_HPGL;
    const hrbfnpr_page_info after = write(context, desc);
    const bench::Comparison time = sorting(context, desc, 3);
    print(name, desc, lines, after, time);
    bench::report((name + "_travel").c_str(), after.travelled / travel(lines));
    bench::report((name + "_hours").c_str(),
                  after.seconds / 3600.0 / plotter_hours(desc, after.drawn, travel(lines), lines.size()));
    bench::report((name + "_seconds_of_svg").c_str(), 1.0 / time.ratio);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const scenes::Context context = bench::make_context();
        sort_random_lines(context.get());
        const hrbfnpr::test::Samples knot = scenes::trefoil(480);
        plot_model(context.get(), "knot_etching", bench::fit(context.get(), knot.points, knot.normals));
        if (const std::string file = bench::option(argc, argv, "--model="); !file.empty()) {
            const auto samples = bench::read_ply(file);
            plot_model(context.get(), "model_etching", bench::fit(context.get(), samples.points, samples.normals));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
