// SPDX-License-Identifier: MIT
// Vector output: pen travel before and after sorting, speed and memory of writing, curves against lines, likeness.
// --model=FILE: a PLY of points with normals to draw as well.  --only=dots,large,curves,lines; match: see
// vector_match.py.
#include "hatch_pictures.h"
#include "read_models.h"
#include "scenes/shapes.h"
#include "timing.h"
#include "vector_curves.h"
#include "vector_dots.h"
#include "vector_large.h"
#include "vector_page.h"

#include <algorithm>
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
using bench::Page;
using bench::PageLine;
using bench::PagePlace;
using bench::travel;
using scenes::made;

void print(const std::string& name, const Page& page, const std::vector<PageLine>& before,
           const hrbfnpr_page_info& after, const bench::Comparison& time) {
    const double unsorted = travel(before);
    std::printf(
        "%s: %zu lines, %lld joined, %lld lines and %lld dots dropped: %lld lines of %.2f m, travel %.2f m, was %.2f "
        "m; %.2f h, were %.2f h; sorted HPGL in %.3f s, SVG in %.3f s\n",
        name.c_str(), before.size(), static_cast<long long>(after.joined), static_cast<long long>(after.dropped_paths),
        static_cast<long long>(after.dropped_dots), static_cast<long long>(after.paths), 1e-3 * after.drawn,
        1e-3 * after.travelled, 1e-3 * unsorted, after.seconds / 3600.0,
        bench::plotter_hours(page, after.drawn, unsorted, before.size()), time.seconds, time.seconds * time.ratio);
}

bench::Comparison sorting(hrbfnpr_context* context, Page page, int runs) {
    Page plain = page;
    plain.format = HRBFNPR_PAGE_FORMAT_SVG;
    return bench::compare(
        runs, [&] { plain.write(context); }, [&] { page.write(context); });
}

// Random short curves, scaled so that any number of them fills the page equally.
std::vector<PageLine> random_lines(int count) {
    std::mt19937 engine(1);
    const auto random = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    const double step = 0.1 * bench::page_side / std::sqrt(count);
    std::vector<PageLine> lines;
    for (int i = 0; i < count; ++i) {
        PagePlace p{bench::page_side * (0.05 + 0.9 * random()), bench::page_side * (0.05 + 0.9 * random())};
        double angle = 2.0 * std::numbers::pi * random();
        const double bend = 0.5 * (random() - 0.5);
        PageLine line;
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
        const std::vector<PageLine> lines = random_lines(count);
        std::vector<hrbfnpr_annotation> annotations;
        for (const PageLine& line : lines) {
            annotations.push_back(made(hrbfnpr_annotation_init));
            annotations.back().points = {line.data(), static_cast<std::int64_t>(line.size()), 0, HRBFNPR_SCALAR_FLOAT64,
                                         2};
        }
        Page page;
        page.annotations = annotations.data();
        page.annotation_count = count;
        page.join = page.shortest = 1e-6; // only sort, join nothing
        page.format = HRBFNPR_PAGE_FORMAT_HPGL;
        const hrbfnpr_page_info after = page.write(context);
        const bench::Comparison time = sorting(context, page, 3);
        const std::string name = "random_" + std::to_string(count);
        print(name, page, lines, after, time);
        bench::report((name + "_travel").c_str(), after.travelled / travel(lines));
        // At best, a tour of random dots has 0.7124 times the length of this root; a tour of lines is shorter.
        const double root = std::sqrt(count * 0.9 * bench::page_side * 0.9 * bench::page_side);
        bench::report((name + "_travel_of_root").c_str(), after.travelled / root);
        bench::report((name + "_seconds_of_svg").c_str(), 1.0 / time.ratio);
    }
}

constexpr int size = 1200; // pixels

// The etching of a model, and its strokes on the page.
class Etching {
public:
    Etching(hrbfnpr_context* context, const hrbfnpr_model* model)
        : set_(bench::hatch_set(context, model, HRBFNPR_PRESET_ETCHING)),
          painter_(context, set_.get(), bench::hatch_style(HRBFNPR_PRESET_ETCHING, size)) {
        const hrbfnpr_point_set_info info = bench::info_of(set_.get());
        painter_.draw(bench::square_camera(info.bounds_min, info.bounds_max, {-0.3, -0.2, -1.0}, size));
        page_ = Page(painter_.drawing(), size);
        for (const DrawnStroke& stroke : painter_.strokes()) {
            lines_.emplace_back();
            for (const bench::StrokePoint& p : stroke)
                lines_.back().push_back(
                    {page_.item.scale * static_cast<double>(p.x), page_.item.scale * static_cast<double>(p.y)});
        }
    }
    [[nodiscard]] const Page& page() const { return page_; }
    [[nodiscard]] const std::vector<PageLine>& lines() const { return lines_; }

private:
    scenes::PointSet set_;
    bench::StrokePainter painter_;
    Page page_;
    std::vector<PageLine> lines_;
};

void plot(hrbfnpr_context* context, const std::string& name, const Etching& etching) {
    Page page = etching.page();
    page.format = HRBFNPR_PAGE_FORMAT_HPGL;
    const std::vector<PageLine>& lines = etching.lines();
    const hrbfnpr_page_info after = page.write(context);
    const bench::Comparison time = sorting(context, page, 3);
    print(name, page, lines, after, time);
    bench::report((name + "_travel").c_str(), after.travelled / travel(lines));
    bench::report((name + "_hours").c_str(),
                  after.seconds / 3600.0 / bench::plotter_hours(page, after.drawn, travel(lines), lines.size()));
    bench::report((name + "_seconds_of_svg").c_str(), 1.0 / time.ratio);
}

// The worst figures of all models.
struct Curves {
    double ratio = 0.0, error = 0.0;
};

void count_curves(hrbfnpr_context* context, const std::string& name, const Etching& etching, Curves& worst) {
    const bench::CurveFigures figures = bench::compare_curves(context, etching.page(), etching.lines());
    const auto points = static_cast<double>(figures.control_points);
    const double ratio = points / static_cast<double>(figures.vertices);
    std::printf("%s: %zu control points for %zu vertices of its lines, %.3f; straight lines within %.2f mm have %zu; "
                "farthest off %.4f mm; %zu paths of no known line\n",
                name.c_str(), figures.control_points, figures.vertices, ratio, etching.page().tolerance,
                figures.straight, figures.error, figures.unknown);
    worst.ratio = std::max(worst.ratio, ratio);
    worst.error = std::max(worst.error, figures.error);
}

bool asked(int argc, char** argv, const char* part) {
    const std::string only = bench::option(argc, argv, "--only=");
    return only.empty() || ("," + only + ",").find(std::string(",") + part + ",") != std::string::npos;
}

void run(int argc, char** argv) {
    const scenes::Context context = bench::make_context();
    const hrbfnpr::test::Samples samples = scenes::trefoil(480);
    const scenes::Model knot = bench::fit(context.get(), samples.points, samples.normals);
    if (asked(argc, argv, "dots")) {
        auto camera = bench::square_camera(bench::info_of(knot.get()).bounds_min, bench::info_of(knot.get()).bounds_max,
                                           {-0.3, -0.2, -1.0}, bench::dots_size);
        bench::sort_dots(context.get(), knot.get(), camera);
    }
    if (asked(argc, argv, "large")) bench::write_large_drawings(context.get());
    if (asked(argc, argv, "lines")) sort_random_lines(context.get());
    if (!asked(argc, argv, "curves") && !asked(argc, argv, "lines")) return;
    Curves worst;
    const auto both = [&](const std::string& name, const hrbfnpr_model* model) {
        const Etching etching(context.get(), model);
        if (asked(argc, argv, "lines")) plot(context.get(), name, etching);
        if (asked(argc, argv, "curves")) count_curves(context.get(), name, etching, worst);
    };
    both("knot_etching", knot.get());
    if (const std::string file = bench::option(argc, argv, "--model="); !file.empty()) {
        const auto points = bench::read_ply(file);
        both("model_etching", bench::fit(context.get(), points.points, points.normals).get());
    }
    if (!asked(argc, argv, "curves")) return;
    bench::report("vector.bezier_ratio", worst.ratio);
    bench::report("vector.bezier_error_mm", worst.error);
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
