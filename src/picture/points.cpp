// SPDX-License-Identifier: MIT
#include "picture/points.h"

#include "api/handles.h"
#include "base/assert.h"
#include "orient/cloud.h"
#include "picture/ends.h"
#include "picture/nearness.h"
#include "picture/normals.h"
#include "picture/statistics.h"
#include "picture/strays.h"
#include "picture/tuning_points.h"
#include "picture/up.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>

namespace hrbfnpr::picture {
namespace {

constexpr std::uint32_t candidates_stream = 3; // A separate stream of random numbers, independent of other uses.

bool is_finite_place(const glm::dvec3& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

long long as_printed(std::size_t count) noexcept { return static_cast<long long>(count); }

bool keeps_outliers(const Call& call) noexcept {
    const std::optional<double> given = call.options.changes.number("fit.outliers");
    return given && *given == double{HRBFNPR_REPAIR_KEEP};
}

void tell_left_out_strays(const Call& call, std::int64_t count) {
    call.report.note(HRBFNPR_NOTE_STRAYS, {static_cast<double>(count)},
                     count_of(count, "point", call.pool) +=
                     " far from all others left out ({outliers=keep} keeps them)");
}

// Keeps the elements with the indices in `chosen`, in the order of `chosen`.
void choose_elements(Points& points, const Vector<std::int64_t>& chosen, Pool& pool) {
    Points some(&pool);
    some.reserve(chosen.size());
    for (const std::int64_t i : chosen) some.push_back(points[static_cast<std::size_t>(i)]);
    points = std::move(some);
}

// Returns indices of points in farthest-first order: each point is the farthest from all points before it.
Vector<std::int64_t> farthest_points(const Call& call, Stage& stage, const Points& points, std::size_t count) {
    HRBFNPR_ASSERT(count >= 1 && count <= points.size());
    Vector<std::int64_t> chosen(count, 0, &call.pool);
    const hrbfnpr_array from = view_of(points);
    const hrbfnpr_array_out to{chosen.data(), static_cast<std::int64_t>(count), 0, HRBFNPR_SCALAR_INT64, 1};
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_farthest_points(&call.context, &from, &to, nullptr, stage.operation(), error);
    });
    return chosen;
}

// ---- Points without normals

ViewingHints viewing_hints(const Call& call, const Shape& shape) noexcept {
    const Options& options = call.options;
    ViewingHints seen{shape.up, shape.viewpoint};
    if (options.has_up()) seen.up = glm::dvec3(options.desc.up[0], options.desc.up[1], options.desc.up[2]);
    if (options.viewpoint()) seen.viewpoint = options.viewpoint();
    return seen;
}

void leave_out_not_finite(Points& points) {
    points.erase(std::remove_if(points.begin(), points.end(), [](const glm::dvec3& p) { return !is_finite_place(p); }),
                 points.end());
}

// Leaves out strays, before points are chosen: an even choice would prefer them. Returns whether it found any.
bool leave_out_strays(const Call& call, Shape& shape) {
    PointMask kept = find_strays(shape.points, call.context.runtime.parallel, call.pool);
    const auto count = static_cast<std::int64_t>(std::count(kept.begin(), kept.end(), std::uint8_t{1}));
    if (count == 0) return false;
    for (std::uint8_t& each : kept) each = each == 0 ? 1 : 0;
    keep_points(shape, kept, call.pool);
    tell_left_out_strays(call, count);
    return true;
}

// Finds normals for points that have none. Of very many points, only some are kept.
void give_normals(const Call& call, Shape& shape) {
    const std::size_t all = shape.points.size();
    Points points = std::move(shape.points);
    leave_out_not_finite(points);
    Stage stage(call.report, HRBFNPR_STAGE_ORIENT);
    if (points.size() > points_tuning.most_oriented) {
        choose_elements(points, farthest_points(call, stage, points, points_tuning.most_oriented), call.pool);
        call.report.note(HRBFNPR_NOTE_SOME_ORIENTED, {static_cast<double>(all), static_cast<double>(points.size())},
                         formatted(call.pool, "%lld of %lld points are used, and get normals",
                                   as_printed(points.size()), as_printed(all)));
    }
    MadeNormals made =
        make_normals(call, stage, points, Points(&call.pool), HRBFNPR_NORMALS_NONE, viewing_hints(call, shape));
    stage.says(made_in_words(made.info, points.size(), call.pool));
    call.report.note(HRBFNPR_NOTE_NORMALS_MADE, {static_cast<double>(points.size())},
                     formatted(call.pool, "the points have no normals: %lld are computed%s", as_printed(points.size()),
                               made.info.outward_by == HRBFNPR_OUTWARD_VIEWPOINT ? ", facing the scanner" : ""));
    tell_unsure_normals(call, made.info);
    shape.points = std::move(points);
    shape.normals = std::move(made.normals);
}

// ---- The image of a depth camera

bool is_depth_image(const Shape& shape) noexcept { return shape.columns > 0 && shape.rows > 0; }

// Smooths the depth image of the shape. Returns the radius up to which gaps between its points are closed.
double use_depth_image(const Call& call, Shape& shape) {
    Pool& pool = call.pool;
    const std::int64_t columns = shape.columns;
    const std::int64_t rows = shape.rows;
    hrbfnpr_depth_image_info info;
    {
        Stage stage(call.report, HRBFNPR_STAGE_SMOOTH);
        info = smooth_depth_image(call, stage, shape);
        stage.says(formatted(pool, "%lld points in %lld x %lld pixels, smoothed over %.1f pixels at depth %.3g",
                             static_cast<long long>(info.seen), static_cast<long long>(columns),
                             static_cast<long long>(rows), info.radius, info.depth));
    }
    if (info.left_out != 0)
        call.report.note(HRBFNPR_NOTE_PIXELS_LEFT_OUT, {static_cast<double>(info.left_out)},
                         count_of(info.left_out, "pixel", pool) +=
                         " left out: they lie between a near and a far surface");
    const double noise = depth_noise_of(info);
    call.report.note(HRBFNPR_NOTE_DEPTH_NOISE, {noise, info.depth},
                     formatted(pool, "the depth image has noise of %.2g at depth %.3g: %s", noise, info.depth,
                               call.options.desc.depth_smoothing == 0.0
                                   ? "it is kept"
                                   : "it is smoothed ({depth_smoothing=0} keeps it)"),
                     {.detail = "{depth_smoothing=F} smooths over F times the usual width."});
    return points_tuning.hole_pixels * info.depth / info.focal_length;
}

// ---- Samples

struct Samples {
    Points points;
    Points normals;
};

// Returns those finite points that have a normal, with unit normals.
Samples usable_samples(const Call& call, const Shape& shape) {
    HRBFNPR_ASSERT(shape.normals.size() == shape.points.size());
    Samples samples{Points(&call.pool), Points(&call.pool)};
    samples.points.reserve(shape.points.size());
    samples.normals.reserve(shape.points.size());
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const double length = glm::length(shape.normals[i]);
        if (!is_finite_place(shape.points[i]) || !std::isfinite(length) || !(length > 0.0)) continue;
        samples.points.push_back(shape.points[i]);
        const glm::dvec3& normal = shape.normals[i];
        samples.normals.emplace_back(normal.x / length, normal.y / length, normal.z / length);
    }
    if (samples.points.empty()) call.report.refuse("no point has both a finite position and a normal that is not zero");
    return samples;
}

void choose_samples(Samples& samples, const Vector<std::int64_t>& chosen, Pool& pool) {
    choose_elements(samples.points, chosen, pool);
    choose_elements(samples.normals, chosen, pool);
}

// Returns the points in coordinates of the camera's image and the logarithm of depth. Points spread evenly in these
// coordinates are spread like the pixels of the image.
Points places_in_image(const Points& points, Pool& pool) {
    Points places(&pool);
    places.reserve(points.size());
    for (const glm::dvec3& p : points) places.emplace_back(p.x / p.z, p.y / p.z, std::log(std::abs(p.z)));
    return places;
}

// Returns whether the fit itself chooses its centres from all samples.
bool fit_chooses(const Options& options) noexcept {
    return options.desc.tolerance != 0.0 || options.desc.maximum_centres != 0 ||
           options.changes.number("fit.tolerance").value_or(0.0) != 0.0 ||
           options.changes.number("fit.maximum_centres").value_or(0.0) != 0.0;
}

Samples samples_of(const Call& call, const Shape& shape) {
    const std::size_t all = shape.points.size();
    HRBFNPR_ASSERT(call.options.desc.samples >= 0);
    auto wanted = static_cast<std::size_t>(call.options.desc.samples); // The value 0 asks for all samples.
    if (wanted == 0 && !fit_chooses(call.options) && all > points_tuning.most_samples) {
        wanted = points_tuning.most_samples;
        call.report.note(HRBFNPR_NOTE_SAMPLES_CHOSEN, {static_cast<double>(all), static_cast<double>(wanted)},
                         formatted(call.pool, "%lld of %lld points are used ({samples=N} changes this)",
                                   as_printed(wanted), as_printed(all)));
    }
    Stage stage(call.report, HRBFNPR_STAGE_SAMPLE);
    Samples samples = usable_samples(call, shape);
    const std::size_t usable = samples.points.size();
    const std::size_t candidates = points_tuning.candidates_a_sample * wanted;
    if (wanted != 0 && !shape.is_photo && candidates < usable)
        choose_samples(samples,
                       random_subset(usable, candidates, call.options.desc.random_seed, candidates_stream, call.pool),
                       call.pool);
    if (wanted != 0 && wanted < usable) {
        const Vector<std::int64_t> chosen =
            shape.is_photo ? farthest_points(call, stage, places_in_image(samples.points, call.pool), wanted)
                           : farthest_points(call, stage, samples.points, wanted);
        choose_samples(samples, chosen, call.pool);
    }
    stage.says(formatted(call.pool, "%lld samples", as_printed(samples.points.size())));
    if (wanted == 0 && samples.points.size() < all) {
        const std::size_t left_out = all - samples.points.size();
        call.report.note(HRBFNPR_NOTE_POINTS_NOT_USABLE, {static_cast<double>(left_out)},
                         count_of(static_cast<std::int64_t>(left_out), "point", call.pool) +=
                         " left out: without a usable position or normal");
    }
    return samples;
}

void turn(Points& normals) noexcept {
    for (glm::dvec3& normal : normals) normal = -normal;
}

// Turns the given normals outward. With the flag FLIP, it turns all of them around instead.
void turn_outward(const Call& call, const Shape& shape, Samples& samples) {
    Pool& pool = call.pool;
    Report& report = call.report;
    const SharedPlaces places = merge_shared_places(samples.points, samples.normals, pool);
    if (places.joined != 0)
        report.note(HRBFNPR_NOTE_NORMALS_JOINED, {static_cast<double>(places.joined)},
                    count_of(places.joined, "place", pool) +=
                    " with several normals, as on a sharp edge: their mean is used");
    if (places.left_out != 0)
        report.warn(HRBFNPR_NOTE_NORMALS_OPPOSITE, {static_cast<double>(places.left_out)},
                    count_of(places.left_out, "place", pool) += " with opposite normals left out");
    if (samples.points.empty()) report.refuse("all points come in pairs with opposite normals");
    if (call.options.has(HRBFNPR_PICTURE_FLIP)) {
        turn(samples.normals);
        return;
    }
    const std::uint32_t mode = call.options.desc.normals;
    Stage stage(report, HRBFNPR_STAGE_ORIENT);
    stage.says(settle_normals(call, stage, samples.points, samples.normals, mode, viewing_hints(call, shape)));
    const char axis = mode != HRBFNPR_NORMALS_GIVEN ? hangs_along(samples.points, samples.normals) : char{0};
    if (axis == 0) return;
    turn(samples.normals);
    stage.says("terrain that faced down: normals turned");
    report.note(
        HRBFNPR_NOTE_TERRAIN_TURNED, {static_cast<double>(axis - 'x')},
        formatted(pool, "the terrain faced down along %c: its normals are turned ({normals=keep} leaves them)", axis));
}

// ---- The fit

// Returns whether the caller, not the settings, changed a field of the fit.
bool changes_fit_field(const Changes& changes, std::string_view path) noexcept {
    const auto& list = changes.list();
    const auto first = list.begin() + static_cast<std::ptrdiff_t>(changes.from_settings());
    return std::any_of(first, list.end(), [&](const Change& each) { return each.path == path; });
}

hrbfnpr_fit_desc fit_desc_of(const Call& call, bool of_points, bool has_dust) {
    const Options& options = call.options;
    auto desc = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    // Samples of a mesh are exact, but scans have noise.
    if (of_points && !options.gives_fit("regularization")) desc.regularization_mode = HRBFNPR_REGULARIZATION_AUTO;
    if (has_dust) desc.outliers = HRBFNPR_REPAIR_DROP;
    options.changes.apply("fit", desc);
    // An option of the descriptor overrides the settings. A change of a single field overrides the option.
    if (options.desc.tolerance != 0.0 && !changes_fit_field(options.changes, "fit.tolerance"))
        desc.tolerance = options.desc.tolerance;
    if (options.desc.maximum_centres != 0 && !changes_fit_field(options.changes, "fit.maximum_centres"))
        desc.maximum_centres = options.desc.maximum_centres;
    desc.normal_mode = HRBFNPR_NORMALS_GIVEN;
    desc.trim = HRBFNPR_TRIM_NEVER;
    return desc;
}

constexpr const char* name_of_kernel(std::uint32_t kernel) noexcept {
    switch (kernel) {
    case HRBFNPR_KERNEL_TRIHARMONIC: return "triharmonic";
    case HRBFNPR_KERNEL_GAUSSIAN: return "gaussian";
    case HRBFNPR_KERNEL_WENDLAND_C2: return "wendland_c2";
    case HRBFNPR_KERNEL_CSG: return "csg";
    default: return "custom";
    }
}

constexpr const char* name_of_solver(std::uint32_t solver) noexcept {
    switch (solver) {
    case HRBFNPR_SOLVER_DIRECT: return "direct";
    case HRBFNPR_SOLVER_ITERATIVE: return "iterative";
    default: return "auto";
    }
}

// Returns the extents of the samples along their principal axes, in ascending order, up to a common factor.
std::array<double, 3> principal_extents(const Points& points) noexcept {
    const glm::dvec3 mean =
        std::accumulate(points.begin(), points.end(), glm::dvec3(0.0)) / static_cast<double>(points.size());
    orient::Moments moments;
    for (const glm::dvec3& p : points) moments.add(p - mean);
    std::array<double, 3> extents = orient::plane_of(moments).variance;
    for (double& extent : extents) extent = std::sqrt(extent);
    return extents;
}

} // namespace

void leave_out_unusable(const Call& call, Shape& shape) {
    Pool& pool = call.pool;
    if (shape.is_mesh()) {
        const auto is_unusable = [&](const Triangle& face) {
            return !std::all_of(face.begin(), face.end(), [&](std::int64_t corner) {
                HRBFNPR_ASSERT(corner >= 0 && corner < static_cast<std::int64_t>(shape.points.size()));
                return is_finite_place(shape.points[static_cast<std::size_t>(corner)]);
            });
        };
        const auto unusable = std::remove_if(shape.triangles.begin(), shape.triangles.end(), is_unusable);
        const std::int64_t left_out = shape.triangles.end() - unusable;
        if (unusable == shape.triangles.begin()) call.report.refuse("every face has a corner that is not finite");
        shape.triangles.erase(unusable, shape.triangles.end());
        if (left_out != 0)
            call.report.warn(HRBFNPR_NOTE_FACES_NOT_FINITE, {static_cast<double>(left_out)},
                             count_of(left_out, "face", pool) += " left out, as a corner is not finite");
    }
    const NoData no_data = leave_out_no_data(shape, pool);
    if (no_data.points == 0) return;
    const String count = count_of(no_data.points, shape.is_mesh() ? "vertex" : "point", pool);
    call.report.note(HRBFNPR_NOTE_NO_DATA, {static_cast<double>(no_data.points), no_data.value},
                     formatted(pool, "%s left out, as the value %g marks missing data", count.c_str(), no_data.value));
}

bool has_normals(const Shape& shape) noexcept {
    const auto tells = [](double x) { return x != 0.0 && !std::isnan(x); };
    return std::any_of(shape.normals.begin(), shape.normals.end(),
                       [&](const glm::dvec3& n) { return tells(n.x) || tells(n.y) || tells(n.z); });
}

hrbfnpr_depth_image_info smooth_depth_image(const Call& call, Stage& stage, Shape& shape) {
    HRBFNPR_ASSERT(is_depth_image(shape));
    const double factor = call.options.desc.depth_smoothing; // NaN if not given
    auto desc = defaults<hrbfnpr_depth_image_desc>(hrbfnpr_depth_image_desc_init);
    desc.columns = static_cast<std::int32_t>(shape.columns);
    desc.rows = static_cast<std::int32_t>(shape.rows);
    desc.points = view_of(shape.points);
    if (factor == 0.0)
        desc.keep_points = 1;
    else if (!std::isnan(factor))
        desc.smoothing = factor;
    shape.normals.assign(shape.points.size(), glm::dvec3(0.0));
    auto info = defaults<hrbfnpr_depth_image_info>(hrbfnpr_depth_image_info_init);
    const hrbfnpr_array_out to_points = room_in(shape.points);
    const hrbfnpr_array_out to_normals = room_in(shape.normals);
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_smooth_depth_image(&call.context, &desc, stage.operation(), &to_points, &to_normals, &info,
                                          error);
    });
    PointMask kept(shape.points.size(), 0, &call.pool);
    std::transform(shape.points.begin(), shape.points.end(), kept.begin(),
                   [](const glm::dvec3& p) { return static_cast<std::uint8_t>(is_finite_place(p) ? 1 : 0); });
    keep_points(shape, kept, call.pool);
    return info;
}

void tell_unused_viewpoint(const Call& call, const Shape& shape) {
    const std::uint32_t mode = call.options.desc.normals;
    const bool keeps = mode == HRBFNPR_NORMALS_AUTO || mode == HRBFNPR_NORMALS_GIVEN;
    if (call.options.viewpoint() && (shape.is_mesh() || (has_normals(shape) && keeps)))
        call.report.warn(HRBFNPR_NOTE_VIEWPOINT_NOT_USED, {},
                         "{viewpoint} is ignored: there are normals already ({normals=none} computes new ones)");
}

Surface fit_points(const Call& call, Shape&& shape, glm::dvec3& up) {
    HRBFNPR_ASSERT(!shape.is_mesh());
    tell_unused_viewpoint(call, shape);
    if (!keeps_outliers(call)) {
        const std::int64_t far = leave_out_far(shape, call.pool);
        if (far != 0) tell_left_out_strays(call, far);
    }
    const bool made = call.options.desc.normals == HRBFNPR_NORMALS_NONE || !has_normals(shape);
    std::optional<double> hole;
    bool has_strays = false;
    if (made && is_depth_image(shape)) {
        if (call.options.viewpoint())
            call.report.warn(HRBFNPR_NOTE_VIEWPOINT_NOT_USED, {},
                             "{viewpoint} is ignored: the camera of the depth image is known");
        hole = use_depth_image(call, shape);
    } else {
        has_strays = !is_depth_image(shape) && !keeps_outliers(call) && leave_out_strays(call, shape);
        if (made) give_normals(call, shape);
    }
    Samples samples = samples_of(call, shape);
    if (!made)
        turn_outward(call, shape, samples);
    else if (call.options.has(HRBFNPR_PICTURE_FLIP))
        turn(samples.normals);
    up = choose_up(call, &shape, samples.points, samples.normals);
    // Points without normals count as a scan, which has dust.
    const Model model = fit_samples(call, samples.points, samples.normals, true, made || has_strays);
    Surface surface;
    surface.model = end_of_points(call, model, shape, hole);
    surface.shape = std::make_shared<const Shape>(std::move(shape));
    return surface;
}

Model fit_samples(const Call& call, const Points& points, const Points& normals, bool of_points, bool has_dust) {
    HRBFNPR_ASSERT(points.size() == normals.size());
    hrbfnpr_fit_desc desc = fit_desc_of(call, of_points, has_dust);
    desc.points = view_of(points);
    desc.normals = view_of(normals);
    Model model;
    hrbfnpr_model_info info;
    {
        Stage stage(call.report, HRBFNPR_STAGE_FIT);
        model = make<Model>([&](hrbfnpr_model** to, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(&call.context, &desc, stage.operation(), to, error);
        });
        info = model_info_of(model);
        stage.says(formatted(call.pool, "%s, %s, %s; %s", count_of(info.centres, "centre", call.pool).c_str(),
                             name_of_kernel(info.kernel), name_of_solver(info.solver),
                             nearness_of_points(info, call.pool).c_str()));
    }
    if (of_points && desc.regularization_mode == HRBFNPR_REGULARIZATION_AUTO && info.regularization > 0.0)
        call.report.note(HRBFNPR_NOTE_SMOOTHED, {},
                         "the samples are noisy: the surface is smoothed ({regularization=0} keeps the noise)");
    tell_repaired_samples(call, info);
    tell_doubted_samples(call, info);
    tell_thin_evidence(call, points);
    return model;
}

void tell_thin_evidence(const Call& call, const Points& points) {
    Report& report = call.report;
    const auto count = static_cast<double>(points.size());
    if (points.size() == 1) {
        report.warn(HRBFNPR_NOTE_FEW_POINTS, {count}, "there is only one point: its plane is drawn");
    } else if (points.size() < points_tuning.few_samples) {
        report.warn(HRBFNPR_NOTE_FEW_POINTS, {count},
                    formatted(call.pool, "there are only %lld points: the surface between them is a guess",
                              as_printed(points.size())));
    } else {
        const std::array<double, 3> extent = principal_extents(points);
        if (extent[1] < points_tuning.thin * extent[2])
            report.warn(HRBFNPR_NOTE_ON_A_LINE, {}, "all points lie on a line: the surface beside it is a guess");
        else if (extent[0] < points_tuning.thin * extent[2])
            report.warn(HRBFNPR_NOTE_IN_A_PLANE, {},
                        "all points lie in a plane: the surface is flat and ends where they do");
    }
}

} // namespace hrbfnpr::picture
