// SPDX-License-Identifier: MIT
// Contours as lines: how close they are to the truth, how often they are whole and their visibility is right, times,
// and flicker. --models=DIR: a folder of PLY files of points with normals, in addition to generated surfaces;
// --named=TEXT: only models with TEXT in the name; --only=PART,...: any of truth, views, warm, features, times,
// flicker, raster; --places=N: the number of places on lines whose visibility is checked; --cameras=N, at most 3, and
// --rays=N per pixel side: the reference of feature lines.
#include "line_features.h"
#include "line_flicker.h"
#include "line_raster.h"
#include "line_times.h"
#include "line_truth.h"
#include "line_views.h"
#include "line_visibility.h"
#include "line_warm.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using bench::LineModel;
using bench::Views;

struct Settings {
    std::string models;
    std::string only;
    std::int64_t places;
    std::string named;
    int cameras = 3;
    int rays = 1;

    [[nodiscard]] bool wants(const char* part) const { return only.empty() || only.find(part) != std::string::npos; }
};

// Returns generated models and those of the folder.
std::vector<bench::Source> chosen_sources(const Settings& settings) {
    std::vector<bench::Source> all = bench::generated_sources();
    if (!settings.models.empty())
        for (bench::Source& source : bench::sources_of(settings.models)) all.push_back(std::move(source));
    std::vector<bench::Source> chosen;
    for (bench::Source& source : all)
        if (source.name.find(settings.named) != std::string::npos) chosen.push_back(std::move(source));
    if (chosen.empty()) throw std::runtime_error("no model is called so: " + settings.named);
    return chosen;
}

// Returns the samples for the times: the head if a folder is given, else a generated surface.
bench::Samples orbit_samples(const Settings& settings) {
    return settings.models.empty() ? bench::bumpy(4096) : bench::read_ply(settings.models + "/head_4096.ply");
}

struct Results {
    std::vector<std::pair<std::string, double>> pairs;

    void add(const char* name, double value) { pairs.emplace_back(std::string("lines.").append(name), value); }
};

// ---- Known surfaces -------------------------------------------------------------------------

// The drawn lines against the true contours, both ways.
struct Truth {
    bench::Nearness drawn, wanted;
    Views views;

    void add(const Truth& other) {
        drawn.add(other.drawn);
        wanted.add(other.wanted);
        views.add(other.views);
    }
    [[nodiscard]] double precision() const { return drawn.near / drawn.length; }
    [[nodiscard]] double recall() const { return wanted.near / wanted.length; }
    [[nodiscard]] double error() const { return drawn.moment / drawn.length; }
};

Truth compare_views(hrbfnpr_context* context, const LineModel& model, const bench::Exact& exact, double angle) {
    const glm::dvec3 low = -exact.shape->half;
    const glm::dvec3 high = exact.shape->half;
    bench::LinePainter painter(context, model.marks.get(), model.lines.get());
    Truth truth;
    for (const glm::dvec3& direction : bench::turned_directions()) {
        const hrbfnpr_camera camera = bench::camera_of(glm::value_ptr(low), glm::value_ptr(high), direction, angle);
        painter.draw(camera);
        const std::string name = bench::view_name(model.name, direction);
        bench::count(truth.views, painter.info(), name);
        const bench::ImageLines drawn = bench::image_lines(painter.polylines());
        const bench::ImageLines wanted = exact.contours->of(bench::Sight(camera));
        const bench::Nearness of_drawn = bench::nearness(drawn, wanted);
        const bench::Nearness of_wanted = bench::nearness(wanted, drawn);
        for (const auto& [what, near] : {std::pair("drawn beside", of_drawn), std::pair("not drawn", of_wanted)})
            if (near.longest > 1.0)
                std::printf("%s: %.1f of %.0f px %s, %.1f at most\n", name.c_str(), near.length - near.near,
                            near.length, what, near.longest);
        truth.drawn.add(of_drawn);
        truth.wanted.add(of_wanted);
    }
    return truth;
}

void run_truth(hrbfnpr_context* context, Results& results) {
    std::printf("\ncontours of known surfaces from 26 sides, hidden ones too, within a pixel\n");
    Truth all;
    std::vector<std::string> rows;
    for (const bench::Exact& exact : bench::exact_shapes())
        for (const double angle : {0.5, 0.0}) {
            const std::string name = exact.name + (angle > 0.0 ? ", perspective" : ", orthographic");
            const LineModel model = bench::line_model(context, name, bench::custom_shape(context, *exact.shape));
            const Truth truth = compare_views(context, model, exact, angle);
            char row[160];
            std::snprintf(row, sizeof row, "%-28s %9.6f %9.6f %9.5f %9.2f %9.2f %6lld %8lld %7lld %8.1f", name.c_str(),
                          truth.precision(), truth.recall(), truth.error(), truth.drawn.longest, truth.wanted.longest,
                          static_cast<long long>(truth.views.valid), static_cast<long long>(truth.views.settled),
                          static_cast<long long>(truth.views.broken), bench::quantile(truth.views.ms, 0.5));
            rows.emplace_back(row);
            all.add(truth);
        }
    std::printf("%-28s %9s %9s %9s %9s %9s %6s %8s %7s %8s\n", "surface", "precision", "recall", "error px",
                "beside px", "gap px", "valid", "settled", "broken", "ms");
    for (const std::string& row : rows) std::printf("%s\n", row.c_str());
    results.add("precision", all.precision());
    results.add("recall", all.recall());
    results.add("mean_error_px", all.error());
    results.add("longest_gap_px", all.wanted.longest);
}

// ---- Fitted surfaces ------------------------------------------------------------------------

void print(const bench::VisibilityCount& c) {
    const auto number = [](std::int64_t n) { return static_cast<long long>(n); };
    std::printf(
        "   visibility: %lld of %lld places wrong (%lld hidden by mistake; %lld are visible), %lld with another "
        "number of layers; %lld off the contour, %lld unsure\n",
        number(c.places - c.right), number(c.places), number(c.hidden_by_mistake), number(c.visible),
        number(c.places - c.layers_right), number(c.astray), number(c.unsure));
}

// Prints possible faults of the mesh that lines are found on.
void print_faults(const LineModel& model) {
    const hrbfnpr_line_set_info info = bench::info_of(model.lines.get());
    if (info.turned == 0 && info.missed_seeds == 0 && info.borders == 0) return;
    std::printf("   mesh: %lld triangles turned, %lld seeds missed, %lld borders, cells of %.4g, spacing %.4g\n",
                static_cast<long long>(info.turned), static_cast<long long>(info.missed_seeds),
                static_cast<long long>(info.borders), info.cell_size, bench::info_of(model.model.get()).spacing);
}

// Measurements of one surface.
struct Measured {
    Views views;
    bench::VisibilityCount visible;

    void add(const Measured& other) {
        views.add(other.views);
        visible.add(other.visible);
    }
};

Measured measure(hrbfnpr_context* context, const bench::Source& source, std::int64_t places) {
    const LineModel model =
        bench::line_model(context, source.name, bench::fit_centres(context, source.samples(), source.centres));
    std::vector<std::pair<hrbfnpr_camera, std::vector<bench::Polyline>>> drawn;
    Measured found;
    found.views = bench::draw_views(context, model, [&](bench::LinePainter& painter, const auto& camera) {
        drawn.emplace_back(camera, painter.polylines());
    });
    bench::print(source.name, bench::info_of(model.model.get()).centres, bench::info_of(model.lines.get()).triangles,
                 found.views);
    print_faults(model);
    // Afterwards, so that rays take no time from lines.
    const bench::VisibilityCheck check(model.model.get());
    const std::vector<glm::dvec3> directions = bench::cube_directions();
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        bench::VisibilityCount its = check(drawn[i].first, drawn[i].second, places);
        for (std::string& wrong : its.wrong)
            wrong = bench::view_name(source.name, directions[i]).append(", ").append(wrong);
        found.visible.add(its);
    }
    print(found.visible);
    return found;
}

void run_views(hrbfnpr_context* context, const Settings& settings, Results& results) {
    const std::vector<bench::Source> sources = chosen_sources(settings);
    const auto places = std::max<std::int64_t>(1, settings.places / (26 * static_cast<std::int64_t>(sources.size())));
    std::printf("\ncontours from 26 sides, 1280 x 720, each view for the first time\n");
    bench::print_head();
    Measured all;
    for (const bench::Source& source : sources) all.add(measure(context, source, places));
    for (const std::string& bad : all.views.bad) std::printf("not valid: %s\n", bad.c_str());
    for (const std::string& wrong : all.visible.wrong) std::printf("wrong: %s\n", wrong.c_str());
    const auto share = [](std::int64_t part, std::int64_t whole) {
        return static_cast<double>(part) / static_cast<double>(whole);
    };
    results.add("valid_views", share(all.views.valid, all.views.views));
    results.add("visibility_right", share(all.visible.right, all.visible.places));
    results.add("median_ms", bench::quantile(all.views.ms, 0.5));
    results.add("p90_ms", bench::quantile(all.views.ms, 0.9));
}

void run_warm(hrbfnpr_context* context, const Settings& settings, Results& results) {
    std::printf("\nhalf a degree a frame, each from the last\n");
    bench::print_head();
    bench::WarmFrames all;
    for (const bench::Source& source : chosen_sources(settings)) {
        const LineModel model =
            bench::line_model(context, source.name, bench::fit_centres(context, source.samples(), source.centres));
        const bench::WarmFrames found = bench::warm_frames(context, model, 49, 500);
        bench::print(source.name, bench::info_of(model.model.get()).centres,
                     bench::info_of(model.lines.get()).triangles, found.views);
        all.add(found);
    }
    for (const std::string& bad : all.views.bad) std::printf("not valid: %s\n", bad.c_str());
    results.add("warm_valid", static_cast<double>(all.views.valid) / static_cast<double>(all.views.views));
    for (const std::string& wrong : all.visible.wrong) std::printf("wrong: %s\n", wrong.c_str());
    results.add("warm_visibility_right",
                static_cast<double>(all.visible.right) / static_cast<double>(all.visible.places));
    results.add("warm_recall", static_cast<double>(all.same) / static_cast<double>(all.compared));
}

// ---- Feature lines ---------------------------------------------------------------------------

using Matches = std::map<std::string, bench::FeatureMatch>; // by kind

void print(const std::string& model, const std::string& kind, const bench::FeatureMatch& m) {
    std::printf("%-24s %-16s %10.0f %10.0f %9.4f %9.4f %9.4f %9.2f %9.1f %9.1f %9.0f %9.0f\n", model.c_str(),
                kind.c_str(), m.drawn.length, m.wanted.length, m.precision(), m.recall(),
                bench::FeatureMatch::share(m.zeros), m.drawn.length > 0.0 ? m.drawn.moment / m.drawn.length : 0.0,
                m.drawn.longest, m.wanted.longest, m.left_out, m.undecided);
    std::fflush(stdout);
}

bench::FeatureMatch compare(const bench::FeatureGrid& grid, const bench::FeatureReference& reference,
                            const std::vector<bench::Polyline>& polylines) {
    const bench::ImageLines drawn = bench::image_lines(polylines);
    bench::FeatureMatch match;
    match.drawn = bench::nearness_inside(grid, drawn, reference.allowed(), match.left_out);
    double twice = 0.0;
    match.zeros = bench::nearness_inside(grid, drawn, reference.zeros(), twice);
    match.wanted = bench::nearness_inside(grid, reference.wanted(), drawn, match.left_out);
    match.undecided = reference.undecided();
    return match;
}

Matches compare_features(hrbfnpr_context* context, const bench::Source& source, const Settings& settings) {
    LineModel model{source.name, bench::fit_centres(context, source.samples(), source.centres), {}, {}, 0.0};
    const hrbfnpr_model_info info = bench::info_of(model.model.get());
    std::vector<bench::FeatureAsked> asked = bench::features_asked();
    asked.back().level = 0.5 * (info.bounds_min[2] + info.bounds_max[2]);
    model.lines = bench::make_feature_set(context, model.model.get(), asked);
    model.marks = bench::generate(context, model.model.get(), bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 64));
    const bench::ShapeAt shape_at(model.model.get());
    const double diagonal = glm::distance(glm::make_vec3(info.bounds_min), glm::make_vec3(info.bounds_max));
    const double cell = bench::info_of(model.lines.get()).cell_size;
    Matches matches;
    for (const glm::dvec3& direction : bench::feature_directions(settings.cameras)) {
        const hrbfnpr_camera camera = bench::camera_of(info.bounds_min, info.bounds_max, direction, 0.5);
        const bench::FeatureGrid grid(model.model.get(), shape_at, camera, settings.rays);
        for (const bench::FeatureAsked& one : asked) {
            const bench::FeatureReference reference(grid, shape_at, one, bench::light_of(camera), diagonal, cell);
            bench::LinePainter painter(context, model.marks.get(), model.lines.get(), {bench::feature_style(one)});
            painter.draw(camera);
            matches[one.name].add(compare(grid, reference, painter.polylines()));
        }
    }
    for (const auto& [kind, match] : matches) print(source.name, kind, match);
    return matches;
}

// Times contours with suggestive contours, and contours alone, for the same views.
void time_features(hrbfnpr_context* context, const bench::Samples& samples, Results& results) {
    LineModel model = bench::line_model(context, "", bench::fit_centres(context, samples, 4096));
    model.lines = bench::make_feature_set(context, model.model.get(), {});
    const bench::FeatureAsked suggestive = bench::features_asked().front();
    bench::LinePainter alone(context, model.marks.get(), model.lines.get());
    bench::LinePainter both(context, model.marks.get(), model.lines.get(),
                            {bench::contour_style(), bench::feature_style(suggestive)});
    std::vector<double> contour_ms;
    std::vector<double> suggestive_ms;
    const hrbfnpr_model_info info = bench::info_of(model.model.get());
    for (const glm::dvec3& direction : bench::cube_directions()) {
        const hrbfnpr_camera camera = bench::camera_of(info.bounds_min, info.bounds_max, direction, 0.5);
        for (auto [painter, ms] : {std::pair(&alone, &contour_ms), std::pair(&both, &suggestive_ms)}) {
            painter->begin_anew();
            painter->draw(camera);
            ms->push_back(bench::line_ms(painter->info()));
        }
    }
    results.add("contour_ms", bench::quantile(contour_ms, 0.5));
    results.add("suggestive_ms", bench::quantile(suggestive_ms, 0.5));
    results.add("suggestive_over_contours", bench::quantile(suggestive_ms, 0.5) / bench::quantile(contour_ms, 0.5));
}

void run_features(hrbfnpr_context* context, const Settings& settings, Results& results) {
    const std::vector<bench::Source> sources = chosen_sources(settings);
    std::printf("\nvisible feature lines of %d cameras beside those of a grid of rays, within a pixel of 1280 x 720\n",
                settings.cameras);
    std::printf("%-24s %-16s %10s %10s %9s %9s %9s %9s %9s %9s %9s %9s\n", "model", "kind", "drawn px", "wanted px",
                "precision", "recall", "on zeros", "error px", "beside px", "gap px", "left out", "undecided");
    Matches all;
    for (const bench::Source& source : sources)
        for (auto& [kind, match] : compare_features(context, source, settings)) {
            const auto [found, is_new] = all.try_emplace(kind);
            found->second.add(match);
        }
    for (const auto& [kind, match] : all) {
        print("all", kind, match);
        results.add((kind + "_precision").c_str(), match.precision());
        results.add((kind + "_recall").c_str(), match.recall());
    }
    time_features(context, orbit_samples(settings), results);
}

// ---- Camera paths ----------------------------------------------------------------------------

[[nodiscard]] LineModel orbit_model(hrbfnpr_context* context, const Settings& settings) {
    return bench::line_model(context, "orbit", bench::fit_centres(context, orbit_samples(settings), 4096));
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
    results.add("vs_cells", bench::lines_over_cells(context, model));
    bench::print_head();
    const double few = bench::median_ms(context, 256);
    results.add("growth", bench::median_ms(context, 16384) / few);
}

void run_flicker(hrbfnpr_context* context, const Settings& settings, Results& results) {
    const LineModel model = orbit_model(context, settings);
    bench::LinePainter painter(context, model.marks.get(), model.lines.get());
    const bench::Flicker found = bench::flicker_of(painter, bench::LineOrbit(model.model.get()), 120, 0.5);
    std::printf("\n%lld of %lld places of visible contours vanish for a frame or two\n",
                static_cast<long long>(found.gone), static_cast<long long>(found.places));
    results.add("flicker", static_cast<double>(found.gone) / static_cast<double>(found.places));
}

// ---- Raster ----------------------------------------------------------------------------------

// Measures on one thread: the time per pixel of a stroke, and whether it stays the same with more ink.
void run_raster(Results& results) {
    constexpr int runs = 80;
    auto desc = scenes::made(hrbfnpr_context_desc_init);
    desc.thread_count = 1;
    hrbfnpr_context* raw = nullptr;
    scenes::Check check;
    check(hrbfnpr_context_create(&desc, &raw, check.error()));
    const scenes::Context context(raw);
    bench::RasterPictures few_waves(raw, 8);
    bench::RasterPictures many_waves(raw, 128);
    const hrbfnpr_camera camera = bench::raster_camera();
    for (int run = 0; run < runs; ++run)
        for (bench::RasterPictures* const pictures : {&few_waves, &many_waves}) pictures->run(camera);
    const bench::RasterTimes few = few_waves.times();
    const bench::RasterTimes many = many_waves.times();
    std::printf("\nstrokes 2.4 pixels wide, on one core: %.1f ns a pixel of length; discs every half radius: %.1f ns\n",
                many.stroke_ns, many.disc_ns);
    results.add("raster_ns_per_px", many.stroke_ns);
    results.add("raster_vs_discs", many.stroke_ns / many.disc_ns);
    results.add("raster_growth", many.stroke_ns / few.stroke_ns);
}

} // namespace

int main(int argc, char** argv) {
    try {
        Settings settings{bench::option(argc, argv, "--models="), bench::option(argc, argv, "--only="), 100'000,
                          bench::option(argc, argv, "--named=")};
        const std::string places = bench::option(argc, argv, "--places=");
        if (!places.empty()) settings.places = std::stoll(places);
        const std::string cameras = bench::option(argc, argv, "--cameras=");
        if (!cameras.empty()) settings.cameras = std::stoi(cameras);
        const std::string rays = bench::option(argc, argv, "--rays=");
        if (!rays.empty()) settings.rays = std::stoi(rays);
        const scenes::Context context = bench::make_context();
        Results results;
        if (settings.wants("truth")) run_truth(context.get(), results);
        if (settings.wants("views")) run_views(context.get(), settings, results);
        if (settings.wants("warm")) run_warm(context.get(), settings, results);
        if (settings.wants("features")) run_features(context.get(), settings, results);
        if (settings.wants("times")) run_times(context.get(), settings, results);
        if (settings.wants("flicker")) run_flicker(context.get(), settings, results);
        if (settings.wants("raster")) run_raster(results);
        std::printf("\n");
        for (const auto& [name, value] : results.pairs) bench::report(name.c_str(), value);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
