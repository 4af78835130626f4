// How even the marks are: PAPER, white noise and BLUE_NOISE at every prefix; tones, directions, spacing of strokes.
// --bunny=FILE: an OBJ mesh; --head=FILE: a PLY of points with normals, for the time of the order (else a generated
// one).
#include "analytic.h"
#include "bumpy.h"
#include "evenness.h"
#include "read_models.h"
#include "scenes/handles.h"
#include "scenes/shapes.h"
#include "timing.h"
#include "tone_ramp.h"

#include <cstdio>
#include <cstring>
#include <exception>
#include <numeric>
#include <string>

namespace {

using bench::Evenness;
using bench::Mark;
using bench::plane;
using bench::Samples;
using bench::sphere;
using bench::torus;
using bench::tube;
using bench::Vec3;
using bench::operator-;

constexpr double pi = 3.14159265358979323846;

scenes::Model custom(hrbfnpr_context* context, hrbfnpr_implicit_fn function, const Vec3& half) {
    scenes::Check check;
    hrbfnpr_custom_desc desc;
    check(hrbfnpr_custom_desc_init(&desc, sizeof desc));
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_THREAD_SAFE;
    desc.function = function;
    for (std::size_t c = 0; c < 3; ++c) {
        desc.bounds_min[c] = -half[c];
        desc.bounds_max[c] = half[c];
    }
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_custom(context, &desc, &model, check.error()));
    return scenes::Model(model);
}

scenes::Model fit(hrbfnpr_context* context, const std::vector<double>& points, const std::vector<double>& normals) {
    scenes::Check check;
    hrbfnpr_fit_desc desc;
    check(hrbfnpr_fit_desc_init(&desc, sizeof desc));
    const auto view = [](const std::vector<double>& numbers) {
        return hrbfnpr_array{numbers.data(), static_cast<std::int64_t>(numbers.size() / 3), 0, HRBFNPR_SCALAR_FLOAT64,
                             3};
    };
    desc.points = view(points);
    desc.normals = view(normals);
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context, &desc, nullptr, &model, check.error()));
    return scenes::Model(model);
}

struct Surface {
    const char* name;
    scenes::Model model;
    double area; // 0: as the library estimates it
    bool flat = false;
};

hrbfnpr_generate_desc marks_of(std::uint32_t group, std::int64_t budget) {
    scenes::Check check;
    hrbfnpr_generate_desc desc;
    check(hrbfnpr_generate_desc_init(&desc, sizeof desc));
    desc.groups = 1U << group;
    desc.group[group].budget = budget;
    return desc;
}

scenes::PointSet generate(hrbfnpr_context* context, const hrbfnpr_model* model, const hrbfnpr_generate_desc& desc) {
    scenes::Check check;
    hrbfnpr_point_set* set = nullptr;
    check(hrbfnpr_point_set_generate(context, model, &desc, nullptr, &set, check.error()));
    return scenes::PointSet(set);
}

template <class T>
const T* attribute(const hrbfnpr_point_set* set, std::uint32_t group, std::uint32_t which, std::int64_t& count) {
    scenes::Check check;
    hrbfnpr_array array{};
    check(hrbfnpr_point_set_view(set, group, which, &array, check.error()));
    count = array.count;
    return static_cast<const T*>(array.data);
}

hrbfnpr_point_set_info info_of(const hrbfnpr_point_set* set) {
    scenes::Check check;
    hrbfnpr_point_set_info info;
    check(hrbfnpr_point_set_info_init(&info, sizeof info));
    check(hrbfnpr_point_set_get_info(set, &info, check.error()));
    return info;
}

// By falling rank.
std::vector<Mark> ordered(const hrbfnpr_point_set* set, std::uint32_t group) {
    std::int64_t count = 0;
    const float* position = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_POSITION, count);
    const float* normal = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_NORMAL, count);
    const float* rank = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_RANK, count);
    const hrbfnpr_point_set_info info = info_of(set);
    std::vector<std::size_t> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank[a] > rank[b]; });
    std::vector<Mark> marks;
    for (const std::size_t i : order) {
        Mark mark{};
        for (std::size_t c = 0; c < 3; ++c) {
            mark.position[c] = info.origin[c] + double{position[3 * i + c]};
            mark.normal[c] = normal[3 * i + c];
        }
        marks.push_back(mark);
    }
    return marks;
}

struct Worst {
    Evenness evenness{1e9, 1e9, 0.0};
    double power = 0.0; // flat only

    void take(const Evenness& e, double p) {
        evenness.relative_radius = std::min(evenness.relative_radius, e.relative_radius);
        evenness.mean_nearest = std::min(evenness.mean_nearest, e.mean_nearest);
        evenness.low_frequency = std::max(evenness.low_frequency, e.low_frequency);
        power = std::max(power, p);
    }
};

// At every twentieth of the marks.
Worst measure(const char* surface, const char* scheme, const std::vector<Mark>& marks, double area, bool flat,
              const std::vector<Mark>& places) {
    Worst worst;
    for (std::size_t k = 1; k <= 20; ++k) {
        const std::size_t count = marks.size() * k / 20;
        const bench::Window window{flat};
        double density = static_cast<double>(count) / area;
        if (flat) {
            const auto inside = std::count_if(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(count),
                                              [&](const Mark& m) { return window.holds(m.position, 0.0); });
            density = static_cast<double>(inside) / 4.0;
        }
        Evenness evenness;
        bench::measure_distances(marks, count, density, window, evenness);
        bench::measure_low_frequencies(marks, count, density, places, window, evenness);
        const double power = flat ? bench::windowed_power(marks, count, density) : 0.0;
        worst.take(evenness, power);
        if (k != 1 && k != 5 && k != 10 && k != 20) continue;
        std::printf("%-8s %-12s %4zu %% %9zu %9.3f %9.3f %9.3f", surface, scheme, 5 * k, count,
                    evenness.relative_radius, evenness.mean_nearest, evenness.low_frequency);
        std::printf(flat ? " %9.3f\n" : "\n", power);
    }
    std::printf("%-8s %-12s  worst           %9.3f %9.3f %9.3f", surface, scheme, worst.evenness.relative_radius,
                worst.evenness.mean_nearest, worst.evenness.low_frequency);
    std::printf(flat ? " %9.3f\n" : "\n", worst.power);
    std::fflush(stdout);
    return worst;
}

constexpr std::int64_t measured_marks = 20000;

struct Sets {
    std::vector<Mark> blue, white, paper;
};

Sets sets_on(hrbfnpr_context* context, const Surface& surface, double& area) {
    Sets sets;
    const scenes::PointSet blue =
        generate(context, surface.model.get(), marks_of(HRBFNPR_GROUP_STIPPLE, measured_marks));
    sets.blue = ordered(blue.get(), HRBFNPR_GROUP_STIPPLE);
    const double spacing = info_of(blue.get()).spacing;
    if (area <= 0.0) area = spacing * spacing * static_cast<double>(sets.blue.size());
    // A random sixteenth of far denser marks is independent on all scales that matter.
    const scenes::PointSet dense =
        generate(context, surface.model.get(), marks_of(HRBFNPR_GROUP_STIPPLE, 16 * measured_marks));
    sets.white = ordered(dense.get(), HRBFNPR_GROUP_STIPPLE);
    std::mt19937_64 random(1);
    std::shuffle(sets.white.begin(), sets.white.end(), random);
    sets.white.resize(static_cast<std::size_t>(measured_marks));
    hrbfnpr_generate_desc desc = marks_of(HRBFNPR_GROUP_STIPPLE, 0);
    desc.distribution = HRBFNPR_DISTRIBUTION_PAPER;
    desc.seed_source = HRBFNPR_SEED_BOX;
    desc.box_resolution = 8;
    desc.group[HRBFNPR_GROUP_STIPPLE].levels = 3;
    desc.group[HRBFNPR_GROUP_STIPPLE].budget = measured_marks;
    sets.paper = ordered(generate(context, surface.model.get(), desc).get(), HRBFNPR_GROUP_STIPPLE);
    return sets;
}

struct Totals {
    double radius = 1e9, nearest = 1e9, low = 0.0;
};

void run_surface(hrbfnpr_context* context, const Surface& surface, Totals& totals) {
    double area = surface.area;
    const Sets sets = sets_on(context, surface, area);
    std::vector<Mark> places;
    for (std::size_t i = 0; i < sets.white.size(); i += 2) places.push_back(sets.white[i]);
    measure(surface.name, "PAPER", sets.paper, area, surface.flat, places);
    measure(surface.name, "white noise", std::vector<Mark>(sets.white.begin(), sets.white.end()), area, surface.flat,
            {places.rbegin(), places.rend()});
    const Worst worst = measure(surface.name, "BLUE_NOISE", sets.blue, area, surface.flat, places);
    totals.radius = std::min(totals.radius, worst.evenness.relative_radius);
    totals.nearest = std::min(totals.nearest, worst.evenness.mean_nearest);
    totals.low = std::max({totals.low, worst.evenness.low_frequency, worst.power});
}

// ---- Tone ----------------------------------------------------------------------------------

constexpr double darkest = 0.60; // coverage of all marks

std::int32_t ramp_tone(void*, std::int64_t count, const float* positions, const float*, float* tau) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = (double{positions[3 * i]} + 2.0) / 4.0 * bench::ramp_width;
        tau[i] = static_cast<float>(1.0 - std::clamp(bench::asked(x), 0.0, darkest) / darkest);
    }
    return 0;
}

// Discs of 1.5 pixels, drawn by the library.
std::vector<double> drawn(hrbfnpr_context* context, const hrbfnpr_point_set* set) {
    scenes::Check check;
    hrbfnpr_style style;
    check(hrbfnpr_style_init_preset(&style, sizeof style, HRBFNPR_STYLE_STIPPLE, nullptr, check.error()));
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    style.tone = HRBFNPR_TONE_CALLBACK;
    style.tone_function = ramp_tone;
    hrbfnpr_group_style& ink = style.group[HRBFNPR_GROUP_STIPPLE];
    ink.radius = 1.5F;
    ink.radius_zoom = 0.0F;
    for (std::size_t c = 0; c < 4; ++c) {
        ink.ink[c] = c == 3 ? 1.0F : 0.0F;
        style.paper[c] = 1.0F;
    }
    hrbfnpr_camera camera;
    check(hrbfnpr_camera_init(&camera, sizeof camera));
    const Vec3 eye{0.0, 0.0, 5.0};
    const Vec3 target{0.0, 0.0, 0.0};
    const Vec3 up{0.0, 1.0, 0.0};
    check(hrbfnpr_camera_look_at(&camera, eye.data(), target.data(), up.data(), check.error()));
    check(hrbfnpr_camera_orthographic(&camera, 2.0, bench::ramp_width, bench::ramp_height, 1.0, 10.0, check.error()));
    hrbfnpr_item item;
    check(hrbfnpr_item_init(&item, sizeof item));
    item.point_set = set;
    item.style = &style;
    hrbfnpr_renderer* raw = nullptr;
    check(hrbfnpr_renderer_create(context, &raw, check.error()));
    const scenes::Renderer renderer(raw);
    check(hrbfnpr_renderer_prepare(raw, &item, 1, 0, &camera, nullptr, check.error()));
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * bench::ramp_width * bench::ramp_height));
    hrbfnpr_image image;
    check(hrbfnpr_image_init(&image, sizeof image));
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = bench::ramp_width;
    image.height = bench::ramp_height;
    image.pixels = pixels.data();
    check(hrbfnpr_renderer_draw_image(raw, &image, nullptr, check.error()));
    std::vector<double> ink_of(pixels.size() / 4);
    for (std::size_t i = 0; i < ink_of.size(); ++i) ink_of[i] = 1.0 - pixels[4 * i] / 255.0;
    return ink_of;
}

bench::ToneError run_tone(hrbfnpr_context* context) {
    // As many marks as cover `darkest` without overlap, on the picture and as much of the plane as lies around it.
    const Vec3 half{2.2, 1.2, 0.4};
    const scenes::Model model = custom(context, plane, half);
    const double pixel = 4.0 / bench::ramp_width;
    constexpr std::int64_t few = 4000;
    const double wide =
        info_of(generate(context, model.get(), marks_of(HRBFNPR_GROUP_STIPPLE, few)).get()).spacing / pixel;
    const auto budget = static_cast<std::int64_t>(darkest / (pi * 2.25) * wide * wide * few);
    hrbfnpr_generate_desc desc = marks_of(HRBFNPR_GROUP_STIPPLE, budget);
    const scenes::PointSet blue = generate(context, model.get(), desc);
    const double spacing = info_of(blue.get()).spacing / pixel;
    std::printf("\ntone ramp 0.05 to 0.55, %lld marks of 1.5 px, coverage of all %.3f\n",
                static_cast<long long>(budget), pi * 2.25 / (spacing * spacing));
    const bench::ToneError error = bench::tone_error(drawn(context, blue.get()));
    std::printf("%-12s psnr %.2f dB, bias %+.4f\n", "BLUE_NOISE", error.psnr, error.bias);
    desc.distribution = HRBFNPR_DISTRIBUTION_PAPER;
    desc.seed_source = HRBFNPR_SEED_BOX;
    desc.group[0].levels = 5;
    const bench::ToneError paper = bench::tone_error(drawn(context, generate(context, model.get(), desc).get()));
    std::printf("%-12s psnr %.2f dB, bias %+.4f\n", "PAPER", paper.psnr, paper.bias);
    return error;
}

// ---- Strokes -------------------------------------------------------------------------------

struct Directions {
    double mean, most; // degrees; of 95 %
};

// DIRECTION against the nearer of a torus's meridian and parallel.
Directions run_directions(const hrbfnpr_point_set* set) {
    std::int64_t count = 0;
    const float* position = attribute<float>(set, HRBFNPR_GROUP_CURVATURE, HRBFNPR_ATTRIBUTE_POSITION, count);
    const float* direction = attribute<float>(set, HRBFNPR_GROUP_CURVATURE, HRBFNPR_ATTRIBUTE_DIRECTION, count);
    const hrbfnpr_point_set_info info = info_of(set);
    std::vector<double> errors;
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = info.origin[0] + double{position[3 * i]};
        const double y = info.origin[1] + double{position[3 * i + 1]};
        const double ring = std::hypot(x, y);
        const double along = std::abs((-y * double{direction[3 * i]} + x * double{direction[3 * i + 1]}) / ring);
        const double angle = std::acos(std::min(1.0, along)) * 180.0 / pi;
        errors.push_back(std::min(angle, 90.0 - angle));
    }
    std::sort(errors.begin(), errors.end());
    return {std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()),
            errors[errors.size() * 95 / 100]};
}

struct Spacing {
    double mean, variation, alone;
};

// Sideways from each mark to the next stroke that runs parallel (within 45 degrees), in separations.
Spacing run_spacing(const hrbfnpr_point_set* set, double separation) {
    constexpr std::uint32_t group = HRBFNPR_GROUP_CURVATURE;
    std::int64_t count = 0;
    const float* position = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_POSITION, count);
    const float* normal = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_NORMAL, count);
    const float* direction = attribute<float>(set, group, HRBFNPR_ATTRIBUTE_DIRECTION, count);
    const std::uint32_t* stroke = attribute<std::uint32_t>(set, group, HRBFNPR_ATTRIBUTE_STROKE, count);
    const auto vec = [](const float* a, std::size_t i) { return Vec3{a[3 * i], a[3 * i + 1], a[3 * i + 2]}; };
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        marks.push_back({vec(position, i), vec(normal, i)});
    const double farthest = 2.5 * separation;
    const bench::Grid grid(marks, marks.size(), farthest);
    std::vector<double> gaps;
    double alone = 0.0;
    for (std::size_t i = 0; i < marks.size(); i += 7) {
        const Vec3 d = vec(direction, i);
        const Vec3 side = bench::cross(marks[i].normal, d);
        double nearest[2] = {farthest, farthest};
        grid.around(marks[i].position, [&](std::size_t other) {
            if (stroke[2 * other] == stroke[2 * i] || bench::dot(marks[i].normal, marks[other].normal) < 0.0) return;
            if (std::abs(bench::dot(d, vec(direction, other))) < 0.7071) return;
            const Vec3 between = marks[other].position - marks[i].position;
            const double across = bench::dot(between, side);
            if (std::abs(bench::dot(between, d)) > 0.15 * separation) return;
            double& gap = nearest[across > 0.0 ? 1 : 0];
            gap = std::min(gap, std::abs(across));
        });
        for (const double gap : nearest)
            if (gap < farthest)
                gaps.push_back(gap / separation);
            else
                alone += 1.0;
    }
    const auto n = static_cast<double>(gaps.size());
    const double mean = std::accumulate(gaps.begin(), gaps.end(), 0.0) / n;
    double squares = 0.0;
    for (const double gap : gaps) squares += (gap - mean) * (gap - mean);
    return {mean, std::sqrt(squares / n) / mean, alone / (alone + n)};
}

struct StrokeTotals {
    Directions directions{};
    double variation = 0.0;
};

StrokeTotals run_strokes(hrbfnpr_context* context, const std::vector<Surface>& surfaces) {
    StrokeTotals totals;
    std::printf("\nstrokes of 100 000 marks: sideways distance to the next parallel one\n");
    std::printf("%-12s %10s %10s %10s\n", "surface", "mean", "variation", "alone");
    const scenes::Samples samples = scenes::torus(4096);
    const scenes::Model fitted = fit(context, samples.points, samples.normals);
    const auto row = [&](const char* name, const hrbfnpr_model* model) {
        const scenes::PointSet set = generate(context, model, marks_of(HRBFNPR_GROUP_CURVATURE, 100000));
        const Spacing s = run_spacing(set.get(), info_of(set.get()).group[HRBFNPR_GROUP_CURVATURE].step);
        std::printf("%-12s %10.3f %10.3f %9.2f%%\n", name, s.mean, s.variation, 100.0 * s.alone);
        totals.variation = std::max(totals.variation, s.variation);
        return run_directions(set.get());
    };
    totals.directions = row("fitted torus", fitted.get());
    for (const Surface& surface : surfaces)
        if (!surface.flat) row(surface.name, surface.model.get());
    std::printf("directions on the fitted torus: mean error %.4f degrees, 95 %% below %.4f\n", totals.directions.mean,
                totals.directions.most);
    return totals;
}

// ---- Time ----------------------------------------------------------------------------------

struct OrderTime {
    double warm, cold;
};

OrderTime run_time(hrbfnpr_context* context, const Samples& samples) {
    constexpr std::int64_t marks = 512000;
    hrbfnpr_generate_desc paper = marks_of(HRBFNPR_GROUP_STIPPLE, 0);
    paper.distribution = HRBFNPR_DISTRIBUTION_PAPER;
    paper.seed_source = HRBFNPR_SEED_SAMPLES;
    paper.group[0].levels = 3;
    const hrbfnpr_generate_desc blue = marks_of(HRBFNPR_GROUP_STIPPLE, marks);
    const auto first = [&](const hrbfnpr_generate_desc& desc) {
        const scenes::Model model = fit(context, samples.points, samples.normals);
        return bench::seconds([&] { generate(context, model.get(), desc); });
    };
    const double first_paper = first(paper);
    const double first_blue = first(blue);
    const scenes::Model model = fit(context, samples.points, samples.normals);
    const auto run = [&](const hrbfnpr_generate_desc& desc) { return [&] { generate(context, model.get(), desc); }; };
    const bench::Comparison c = bench::compare(5, run(blue), run(paper));
    std::printf("\n%lld marks: first call PAPER %.3f s, BLUE_NOISE %.3f s; later PAPER %.3f s, BLUE_NOISE %.3f s\n",
                static_cast<long long>(marks), first_paper, first_blue, c.seconds, c.seconds * c.ratio);
    return {c.ratio, first_blue / first_paper};
}

std::string option(int argc, char** argv, const char* name) {
    for (int i = 1; i < argc; ++i)
        if (std::strncmp(argv[i], name, std::strlen(name)) == 0) return argv[i] + std::strlen(name);
    return {};
}

void run(const std::string& bunny, const std::string& head, bool only_marks) {
    scenes::Check check;
    hrbfnpr_context* raw = nullptr;
    check(hrbfnpr_context_create(nullptr, &raw, check.error()));
    const scenes::Context context(raw);
    std::vector<Surface> surfaces;
    surfaces.push_back({"flat", custom(raw, plane, {1.1, 1.1, 0.3}), 0.0, true});
    surfaces.push_back({"sphere", custom(raw, sphere, {1.0, 1.0, 1.0}), 4.0 * pi, false});
    surfaces.push_back({"torus", custom(raw, torus, {1.0 + tube, 1.0 + tube, tube}), 4.0 * pi * pi * tube, false});
    const Samples points = bunny.empty() ? bench::bumpy(2500, 0.15) : bench::read_obj(bunny);
    surfaces.push_back({bunny.empty() ? "bumpy" : "bunny", fit(raw, points.points, points.normals), 0.0, false});
    std::printf("%-8s %-12s %6s %9s %9s %9s %9s %9s\n", "surface", "marks", "prefix", "count", "radius", "nearest",
                "low", "power");
    Totals totals;
    for (const Surface& surface : surfaces) run_surface(raw, surface, totals);
    const bench::ToneError tone = run_tone(raw);
    StrokeTotals strokes;
    OrderTime time{};
    if (!only_marks) {
        strokes = run_strokes(raw, surfaces);
        time = run_time(raw, head.empty() ? bench::bumpy(4096, 0.15) : bench::read_ply(head));
    }
    std::printf("\n");
    bench::report("quality.rho_min", totals.radius);
    bench::report("quality.mean_nn_min", totals.nearest);
    bench::report("quality.low_frequency_max", totals.low);
    bench::report("quality.tone_psnr_db", tone.psnr);
    bench::report("quality.tone_bias", tone.bias);
    if (only_marks) return;
    bench::report("quality.direction_mean_deg", strokes.directions.mean);
    bench::report("quality.direction_95_deg", strokes.directions.most);
    bench::report("quality.stroke_variation_max", strokes.variation);
    bench::report("quality.order_time_ratio_first", time.cold);
    bench::report("quality.order_time_ratio", time.warm);
}

} // namespace

int main(int argc, char** argv) try {
    run(option(argc, argv, "--bunny="), option(argc, argv, "--head="),
        std::any_of(argv + 1, argv + argc, [](const char* a) { return std::strcmp(a, "--marks") == 0; }));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
