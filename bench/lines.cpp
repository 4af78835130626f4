// SPDX-License-Identifier: MIT
// Contours as lines: how near to the truth, how often whole, visible where they should be, times, and flicker.
// --models=DIR: a folder of PLY files of points with normals, besides generated surfaces; --only=PART,...: of truth,
// views, times, flicker; --places=N: of lines whose visibility is looked at.
#include "line_times.h"
#include "line_views.h"

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

using bench::LineModel;
using bench::Views;

struct Settings {
    std::string models;
    std::string only;

    [[nodiscard]] bool wants(const char* part) const { return only.empty() || only.find(part) != std::string::npos; }
};

struct Results {
    std::vector<std::pair<std::string, double>> pairs;

    void add(const char* name, double value) { pairs.emplace_back(std::string("lines.").append(name), value); }
};

void run_views(hrbfnpr_context* context, const Settings& settings, Results& results) {
    std::vector<bench::Source> sources = bench::generated_sources();
    if (!settings.models.empty())
        for (bench::Source& source : bench::sources_of(settings.models)) sources.push_back(std::move(source));
    std::printf("\ncontours from 26 sides, 1280 x 720, each view for the first time\n");
    bench::print_head();
    Views all;
    for (const bench::Source& source : sources) {
        const LineModel model =
            bench::line_model(context, source.name, bench::fit_centres(context, source.samples(), source.centres));
        const Views views = bench::draw_views(context, model, [](bench::LinePainter&, const hrbfnpr_camera&) {});
        bench::print(source.name, bench::info_of(model.model.get()).centres,
                     bench::info_of(model.lines.get()).triangles, views);
        all.add(views);
    }
    for (const std::string& bad : all.bad) std::printf("not valid: %s\n", bad.c_str());
    results.add("valid_views", static_cast<double>(all.valid) / static_cast<double>(all.views));
    results.add("median_ms", bench::quantile(all.ms, 0.5));
    results.add("p90_ms", bench::quantile(all.ms, 0.9));
}

[[nodiscard]] LineModel orbit_model(hrbfnpr_context* context, const Settings& settings) {
    const bench::Samples samples =
        settings.models.empty() ? bench::bumpy(4096) : bench::read_ply(settings.models + "/head_4096.ply");
    return bench::line_model(context, "orbit", bench::fit_centres(context, samples, 4096));
}

void run_times(hrbfnpr_context* context, const Settings& settings, Results& results) {
    const LineModel model = orbit_model(context, settings);
    std::printf("\ntimes; other programs' work falls on them too\n");
    const bench::LineOrbit orbit(model.model.get());
    bench::LinePainter painter(context, model.marks.get(), model.lines.get());
    std::vector<double> ms;
    for (int frame = 0; frame < 120; ++frame) {
        painter.draw(orbit.at(0.5 * frame));
        if (frame > 0) ms.push_back(bench::line_ms(painter.info()));
    }
    results.add("warm_ms", bench::quantile(ms, 0.5));
    results.add("vs_marks", bench::lines_over_marks(context, model));
    bench::print_head();
    const double few = bench::median_ms(context, 256);
    results.add("growth", bench::median_ms(context, 16384) / few);
}

} // namespace

int main(int argc, char** argv) {
    try {
        Settings settings{bench::option(argc, argv, "--models="), bench::option(argc, argv, "--only=")};
        const scenes::Context context = bench::make_context();
        Results results;
        if (settings.wants("views")) run_views(context.get(), settings, results);
        if (settings.wants("times")) run_times(context.get(), settings, results);
        std::printf("\n");
        for (const auto& [name, value] : results.pairs) bench::report(name.c_str(), value);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
