// SPDX-License-Identifier: MIT
// Lines of hatching: how evenly they lie, where they end and turn.
// --models=DIR: points to fit as well; --named=TEXT: only models with TEXT in the name; --only=PART,...: any of
// surface, tone, screen, ends, sizes, pops, flecks, frame; --head=FILE: a PLY of points with normals for the times of
// frames (default: a generated surface); --meshes=DIR: OBJ and PLY meshes whose flecks are counted as well.
#include "calls.h"
#include "fleck_pictures.h"
#include "hatch_frame_time.h"
#include "hatch_frames.h"
#include "hatch_tone.h"
#include "hatch_ways.h"
#include "line_models.h"
#include "line_singularities.h"
#include "line_views.h"
#include "read_meshes.h"
#include "stroke_spacing.h"
#include "timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using bench::attribute;
using bench::generate;
using bench::one_layer;
using bench::operator-;
using bench::Vec3;

// The arrays of a set's only layer.
struct Strokes {
    explicit Strokes(const hrbfnpr_point_set* set)
        : position(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count)),
          normal(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count)),
          direction(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION, count)),
          stroke(attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE, count)) {}
    [[nodiscard]] bool goes_on(std::size_t i) const { return i > 0 && stroke[2 * i] == stroke[2 * i - 2]; }
    [[nodiscard]] static Vec3 vec(const float* a, std::size_t i) { return {a[3 * i], a[3 * i + 1], a[3 * i + 2]}; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(count); }

    std::int64_t count = 0;
    const float *position, *normal, *direction;
    const std::uint32_t* stroke;
};

struct Found {
    double mean = 0.0, variation = 0.0, alone = 0.0; // sideways distances, in separations
    double ends = 0.0;                               // per length of 1000 separations
    double kinks = 0.0; // turns by more than 30 degrees within two separations, per length as ends
    double singularities = 0.0, fewest = 0.0; // `fewest`: the least number that the sum of indices allows
    double seconds = 0.0;
};

// Returns whether a mark is within three separations of a singular point, where lines turn.
bool is_singular(const Strokes& strokes, std::size_t i, const std::vector<bench::Singularity>& points,
                 double separation) {
    return std::any_of(points.begin(), points.end(), [&](const bench::Singularity& point) {
        const Vec3 way = Strokes::vec(strokes.position, i) - point.position;
        return bench::dot(way, way) < 9.0 * separation * separation;
    });
}

// Returns by how much a stroke turns within its tangent planes from mark i - 1 to i. The direction at i - 1 is carried
// along by the shortest rotation, so that the curvature of the surface does not count.
double turn_at(const Strokes& strokes, std::size_t i) {
    const Vec3 n = Strokes::vec(strokes.normal, i);
    const Vec3 before = Strokes::vec(strokes.normal, i - 1);
    const Vec3 d = Strokes::vec(strokes.direction, i - 1);
    const Vec3 axis = bench::cross(before, n);
    const Vec3 turned = bench::cross(axis, d);
    const double cosine = bench::dot(before, n);
    const double along = bench::dot(axis, d) / (1.0 + cosine);
    Vec3 carried{};
    for (std::size_t c = 0; c < 3; ++c) carried[c] = cosine * d[c] + turned[c] + along * axis[c];
    const Vec3 now = Strokes::vec(strokes.direction, i);
    return std::atan2(bench::dot(bench::cross(carried, now), n), bench::dot(carried, now));
}

// Returns whether a part of two separations that ends at mark i turns by more than 30 degrees, away from singular
// points.
bool is_kink(const Strokes& strokes, std::size_t i, const std::vector<bench::Singularity>& points, double separation) {
    constexpr double most_turn = 30.0 * std::numbers::pi / 180.0;
    double way = 0.0;
    double turn = 0.0;
    for (std::size_t k = i; strokes.goes_on(k) && way < 2.0 * separation; --k) {
        const Vec3 step = Strokes::vec(strokes.position, k) - Strokes::vec(strokes.position, k - 1);
        way += std::sqrt(bench::dot(step, step));
        turn += turn_at(strokes, k);
        if (is_singular(strokes, k, points, separation) || is_singular(strokes, k - 1, points, separation))
            return false;
        if (std::abs(turn) > most_turn) return true;
    }
    return false;
}

void measure_lines(const Strokes& strokes, double separation, const std::vector<bench::Singularity>& points,
                   Found& found) {
    double length = 0.0;
    double ends = 0.0;
    double kinks = 0.0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!strokes.goes_on(i)) {
            ends += 2.0;
            continue;
        }
        const Vec3 leg = Strokes::vec(strokes.position, i) - Strokes::vec(strokes.position, i - 1);
        length += std::sqrt(bench::dot(leg, leg));
        if (is_kink(strokes, i, points, separation)) kinks += 1.0;
    }
    found.ends = 1000.0 * ends * separation / length;
    found.kinks = 1000.0 * kinks * separation / length;
}

void measure_field(const Strokes& strokes, double separation, Found& found) {
    std::vector<bench::Mark> marks;
    std::vector<Vec3> direction;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        marks.push_back({Strokes::vec(strokes.position, i), Strokes::vec(strokes.normal, i)});
        direction.push_back(Strokes::vec(strokes.direction, i));
    }
    const std::vector<bench::Singularity> points = bench::singularities(marks, direction, separation);
    int halves = 0;
    for (const bench::Singularity& point : points) halves += point.halves;
    found.singularities = static_cast<double>(points.size());
    found.fewest = std::abs(static_cast<double>(halves));
    measure_lines(strokes, separation, points, found);
}

Found measure(hrbfnpr_context* context, const hrbfnpr_model* model, double separation) {
    auto desc = one_layer(HRBFNPR_LAYER_KIND_HATCH, 0);
    desc.layer[0].separation = separation;
    Found found;
    const auto begin = std::chrono::steady_clock::now();
    const scenes::PointSet set = generate(context, model, desc);
    found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const Strokes strokes(set.get());
    const bench::Spacing spacing = bench::run_spacing(set.get(), {separation, 0.25, 12});
    found.mean = spacing.mean;
    found.variation = spacing.variation;
    found.alone = spacing.alone;
    measure_field(strokes, separation, found);
    return found;
}

void print(const std::string& name, const Found& f) {
    std::printf("%-24s %8.3f %10.3f %8.2f%% %12.2f %12.2f %9.0f %6.0f %8.2f\n", name.c_str(), f.mean, f.variation,
                100.0 * f.alone, f.ends, f.kinks, f.singularities, f.fewest, f.seconds);
    std::fflush(stdout);
}

struct Results {
    std::vector<std::pair<std::string, double>> pairs;

    void add(const char* name, double value) { pairs.emplace_back(std::string("strokes.") + name, value); }
};

struct Settings {
    std::string models, meshes, named, only;

    // No part's name is contained in another's.
    [[nodiscard]] bool wants(const char* part) const { return only.empty() || only.find(part) != std::string::npos; }
};

[[nodiscard]] std::vector<bench::Source> chosen_sources(const Settings& settings) {
    std::vector<bench::Source> sources = bench::generated_sources();
    if (!settings.models.empty())
        for (bench::Source& source : bench::sources_of(settings.models)) sources.push_back(std::move(source));
    std::erase_if(sources, [&](const bench::Source& source) {
        return !settings.named.empty() && source.name.find(settings.named) == std::string::npos;
    });
    if (sources.empty()) throw std::runtime_error("no model has that in its name");
    return sources;
}

// ---- On the surface ------------------------------------------------------------------------

void run_surface(hrbfnpr_context* context, const Settings& settings, Results& results) {
    std::printf("%-24s %8s %10s %9s %12s %12s %9s %6s %8s\n", "model", "spacing", "variation", "alone", "ends / 1000",
                "kinks / 1000", "singular", "least", "s");
    std::vector<double> variation, ends, kinks, singular;
    for (const bench::Source& source : chosen_sources(settings)) {
        const scenes::Model model = bench::fit_centres(context, source.samples(), source.centres);
        const hrbfnpr_model_info info = bench::info_of(model.get());
        double squared = 0.0;
        for (int c = 0; c < 3; ++c) squared += std::pow(info.bounds_max[c] - info.bounds_min[c], 2.0);
        const double separation = 0.006 * std::sqrt(squared);
        const Found hatch = measure(context, model.get(), separation);
        print(source.name, hatch);
        variation.push_back(hatch.variation);
        ends.push_back(hatch.ends);
        kinks.push_back(hatch.kinks);
        singular.push_back(hatch.singularities);
    }
    results.add("spacing_variation", bench::quantile(variation, 0.5));
    results.add("spacing_variation_max", *std::max_element(variation.begin(), variation.end()));
    results.add("ends_per_1000", bench::quantile(ends, 0.5));
    results.add("singularities", bench::quantile(singular, 0.5));
    results.add("kinks_per_1000", bench::quantile(kinks, 0.5));
}

// ---- In the picture ------------------------------------------------------------------------

[[nodiscard]] scenes::Model fitted(hrbfnpr_context* context, const bench::Source& source) {
    return bench::fit_centres(context, source.samples(), source.centres);
}

void run_tone(hrbfnpr_context* context, Results& results) {
    const bench::ToneFigures worst = bench::hatch_tones(context);
    results.add("tone_psnr_db", worst.psnr);
    results.add("tone_bias", std::abs(worst.bias));
}

void run_screen(hrbfnpr_context* context, const Settings& settings, Results& results) {
    std::printf("\nlines of an even tone, across them, from three sides\n%-24s %10s %10s %10s %10s\n", "model",
                "spacing px", "in parts", "whole", "alone");
    std::vector<double> variation, whole;
    for (const bench::Source& source : chosen_sources(settings)) {
        const scenes::Model model = fitted(context, source);
        const scenes::PointSet set = bench::hatch_set(context, model.get(), HRBFNPR_PRESET_ENGRAVING);
        const bench::MarkTable marks(set.get());
        for (const glm::dvec3& direction : bench::frame_directions()) {
            const bench::ScreenSpacing found = bench::screen_spacing(context, model.get(), direction, set.get(), marks);
            const bench::Spread spread = bench::spread_of(found.gaps);
            std::printf("%-24s %10.2f %10.3f %10.3f %9.2f%%\n", source.name.c_str(), spread.mean,
                        found.variation_of_parts(), spread.variation, 100.0 * found.alone_share());
            std::fflush(stdout);
            variation.push_back(found.variation_of_parts());
            whole.push_back(spread.variation);
        }
    }
    results.add("screen_variation", bench::quantile(variation, 0.5));
    results.add("screen_variation_max", *std::max_element(variation.begin(), variation.end()));
    results.add("screen_variation_whole", bench::quantile(whole, 0.5));
}

void print_ends(const std::string& name, const std::string& kind, const bench::StrokeEnds& e) {
    std::printf("%-24s %-22s %12.0f %12.2f %12.2f\n", name.c_str(), kind.c_str(), e.length, e.ends_per_1000(),
                e.shorts_per_1000());
    std::fflush(stdout);
}

void run_ends(hrbfnpr_context* context, const Settings& settings, Results& results) {
    std::printf("\nstrokes of pictures from three sides\n%-24s %-22s %12s %12s %12s\n", "model", "strokes", "length px",
                "ends / 1000", "short / 1000");
    std::vector<double> ends, shorts, forced;
    for (const bench::Source& source : chosen_sources(settings)) {
        const scenes::Model model = fitted(context, source);
        for (const std::uint32_t preset : {HRBFNPR_PRESET_ENGRAVING, HRBFNPR_PRESET_ETCHING}) {
            const std::string kind = hrbfnpr_preset_name(preset);
            const bench::StrokeEnds found = bench::ends_of_hatching(context, model.get(), preset, false);
            print_ends(source.name, kind, found);
            ends.push_back(found.ends_per_1000());
            shorts.push_back(found.shorts_per_1000());
            const bench::StrokeEnds all = bench::ends_of_hatching(context, model.get(), preset, true);
            print_ends(source.name, kind + ", every line", all);
            forced.push_back(all.ends_per_1000());
        }
    }
    results.add("ends_per_1000_px", bench::quantile(ends, 0.5));
    results.add("every_line_ends_per_1000_px", bench::quantile(forced, 0.5));
    results.add("short_intervals", bench::quantile(shorts, 0.5));
}

// Pictures of 3200 pixels take long, so surfaces of all kinds are measured, but with at most 1000 samples each.
void run_sizes(hrbfnpr_context* context, const Settings& settings, Results& results) {
    constexpr std::int64_t most_centres = 1000;
    std::printf("\nthe share of a picture's strokes that one of another size has\n");
    bench::SameAtSizes worst;
    for (const bench::Source& source : chosen_sources(settings)) {
        if (source.centres > most_centres) {
            std::printf("%s is left out: more than %lld samples\n", source.name.c_str(),
                        static_cast<long long>(most_centres));
            continue;
        }
        const scenes::Model model = fitted(context, source);
        std::printf("%s\n", source.name.c_str());
        const bench::SameAtSizes same = bench::same_at_sizes(context, model.get(), HRBFNPR_PRESET_ETCHING);
        worst.kept = std::min(worst.kept, same.kept);
        worst.added = std::min(worst.added, same.added);
    }
    results.add("same_at_sizes", worst.kept);
    results.add("same_at_sizes_back", worst.added);
}

void run_pops(hrbfnpr_context* context, const Settings& settings, Results& results) {
    constexpr bench::Way around{90, 0.5, 1.0};
    constexpr bench::Way closer{40, 0.0, 1.05};
    std::printf("\nchanges from frame to frame\n%-24s %-10s %10s %8s %10s %10s %10s\n", "model", "way", "shown", "pops",
                "rate", "removals", "rate");
    bench::WidthChanges orbit, zoom;
    for (const bench::Source& source : chosen_sources(settings)) {
        const scenes::Model model = fitted(context, source);
        const scenes::PointSet set = bench::hatch_set(context, model.get(), HRBFNPR_PRESET_ETCHING);
        for (const auto& [name, way, all] :
             {std::tuple("orbit", &around, &orbit), std::tuple("zoom in", &closer, &zoom)}) {
            const bench::WidthChanges c = bench::follow_hatching(context, set.get(), HRBFNPR_PRESET_ETCHING, *way);
            std::printf("%-24s %-10s %10.0f %8.0f %10.6f %10.0f %10.6f\n", source.name.c_str(), name,
                        c.shown / (c.frames - 1.0), c.pops, c.pop_rate(), c.removals, c.removal_rate());
            std::fflush(stdout);
            all->shown += c.shown;
            all->pops += c.pops;
            all->removals += c.removals;
        }
    }
    results.add("pop_rate", orbit.pop_rate());
    results.add("zoom_removals", zoom.removal_rate());
}

[[nodiscard]] std::vector<std::pair<std::string, bench::PictureMesh>> fleck_meshes(const Settings& settings) {
    std::vector<std::pair<std::string, bench::PictureMesh>> meshes;
    meshes.emplace_back("organic", bench::organic(5000));
    meshes.emplace_back("knot", bench::fleck_knot());
    meshes.emplace_back("cad", bench::cad_part());
    if (!settings.meshes.empty())
        for (const auto& [name, triangles] : bench::read_meshes(settings.meshes, ""))
            meshes.emplace_back(name, bench::fleck_mesh(triangles));
    std::erase_if(meshes, [&](const auto& mesh) { return mesh.first.find(settings.named) == std::string::npos; });
    if (meshes.empty()) throw std::runtime_error("no mesh has that in its name");
    return meshes;
}

void run_flecks(hrbfnpr_context* context, const Settings& settings, Results& results) {
    std::printf("\nwhite flecks of engravings of 1000 pixels\n%-24s %8s %12s %14s\n", "mesh", "flecks", "dark px",
                "per 1000 px");
    double flecks = 0.0;
    double dark = 0.0;
    for (const auto& [name, mesh] : fleck_meshes(settings)) {
        const bench::Flecks found = bench::flecks_of(context, mesh);
        const auto count = static_cast<double>(found.fleck.size());
        std::printf("%-24s %8.0f %12.0f %14.3f\n", name.c_str(), count, found.dark, 1000.0 * count / found.dark);
        std::fflush(stdout);
        flecks += count;
        dark += found.dark;
    }
    results.add("flecks_per_1000_px", 1000.0 * flecks / dark);
}

// Times frames on two threads, so that machines can be compared.
void time_frames(const std::string& head, Results& results) {
    const scenes::Context context = bench::make_context(2);
    const bench::Samples samples = head.empty() ? bench::bumpy(4096) : bench::read_ply(head);
    const scenes::Model model = bench::fit(context.get(), samples.points, samples.normals);
    const bench::HatchFrame frame = bench::HatchFrames(context.get(), model.get()).measure(40);
    results.add("frame_ms", frame.hatching);
    results.add("dotted_frame_ms", frame.marks);
    results.add("frame_ratio", frame.ratio);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const Settings settings{bench::option(argc, argv, "--models="), bench::option(argc, argv, "--meshes="),
                                bench::option(argc, argv, "--named="), bench::option(argc, argv, "--only=")};
        const scenes::Context context = bench::make_context();
        Results results;
        if (settings.wants("surface")) run_surface(context.get(), settings, results);
        if (settings.wants("tone")) run_tone(context.get(), results);
        if (settings.wants("screen")) run_screen(context.get(), settings, results);
        if (settings.wants("ends")) run_ends(context.get(), settings, results);
        if (settings.wants("sizes")) run_sizes(context.get(), settings, results);
        if (settings.wants("pops")) run_pops(context.get(), settings, results);
        if (settings.wants("flecks")) run_flecks(context.get(), settings, results);
        if (settings.wants("frame")) time_frames(bench::option(argc, argv, "--head="), results);
        std::printf("\n");
        for (const auto& [name, value] : results.pairs) bench::report(name.c_str(), value);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_strokes: %s\n", error.what());
        return 1;
    }
    return 0;
}
