// SPDX-License-Identifier: MIT
// Finds the camera of a picture. Sums of products are added in a fixed order and without fused operations. So the
// cameras on two machines differ at most by the rounding of sines and cosines.
#include "picture/look.h"

#include "base/assert.h"
#include "picture/tuning_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

namespace hrbfnpr::picture {
namespace {

constexpr double radians_of_degree = std::numbers::pi / 180.0;
constexpr double degrees_of_radian = 180.0 / std::numbers::pi;

double dot_in_order(const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return 0.0 + a.x * b.x + a.y * b.y + a.z * b.z;
}

double length_in_order(const glm::dvec3& v) noexcept { return std::sqrt(dot_in_order(v, v)); }

glm::dvec3 unit_in_order(const glm::dvec3& v) noexcept { return v / length_in_order(v); }

// A matrix in column-major order, as in a camera.
using CameraMatrix = std::array<double, 16>;

CameraMatrix matrix_of(const double (&numbers)[16]) noexcept {
    CameraMatrix matrix{};
    std::copy(std::begin(numbers), std::end(numbers), matrix.begin());
    return matrix;
}

CameraMatrix identity_matrix() noexcept { return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }

double& matrix_entry(CameraMatrix& matrix, int row, int column) noexcept {
    HRBFNPR_ASSERT(row >= 0 && row < 4 && column >= 0 && column < 4);
    return matrix[static_cast<std::size_t>(4 * column + row)];
}

double matrix_entry(const CameraMatrix& matrix, int row, int column) noexcept {
    HRBFNPR_ASSERT(row >= 0 && row < 4 && column >= 0 && column < 4);
    return matrix[static_cast<std::size_t>(4 * column + row)];
}

CameraMatrix matrix_product(const CameraMatrix& a, const CameraMatrix& b) noexcept {
    CameraMatrix product{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            double sum = 0.0;
            for (int k = 0; k < 4; ++k) sum += matrix_entry(a, row, k) * matrix_entry(b, k, column);
            matrix_entry(product, row, column) = sum;
        }
    }
    return product;
}

glm::dvec4 matrix_product(const CameraMatrix& a, const glm::dvec3& place) noexcept {
    glm::dvec4 product(0.0);
    for (int row = 0; row < 4; ++row)
        product[row] = 0.0 + matrix_entry(a, row, 0) * place.x + matrix_entry(a, row, 1) * place.y +
                       matrix_entry(a, row, 2) * place.z + matrix_entry(a, row, 3);
    return product;
}

glm::dvec3 upper_left_times(const CameraMatrix& a, const glm::dvec3& v) noexcept {
    glm::dvec3 product(0.0);
    for (int row = 0; row < 3; ++row)
        product[row] =
            0.0 + matrix_entry(a, row, 0) * v.x + matrix_entry(a, row, 1) * v.y + matrix_entry(a, row, 2) * v.z;
    return product;
}

// Returns the angle modulo 360, from 0 to 360 degrees.
double within_a_turn(double degrees) noexcept {
    const double rest = std::fmod(degrees, 360.0);
    if (rest == 0.0) return 0.0;
    return rest < 0.0 ? rest + 360.0 : rest;
}

// Rounds an angle to whole degrees, from 0 to 359.
double whole_degrees(double degrees) noexcept { return within_a_turn(std::nearbyint(degrees)); }

// Unit vectors that point up, to the front, and to the right.
struct LookAxes {
    glm::dvec3 up;
    glm::dvec3 front;
    glm::dvec3 right;
};

LookAxes axes_of_view(const glm::dvec3& up) noexcept {
    const glm::dvec3 upward = unit_in_order(up);
    glm::dvec3 front =
        std::abs(upward.z) < look_tuning.upright ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, -1.0, 0.0);
    front = unit_in_order(front - dot_in_order(front, upward) * upward);
    return {upward, front, glm::cross(upward, front)};
}

// ---- Positions and normals of marks

// Appends the values of an attribute for all marks. Each value has three 32-bit numbers, and `origin` is added to each
// value.
void append_attribute(Points& to, const PointSet& marks, std::uint32_t attribute, const glm::dvec3& origin) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    to.reserve(to.size() + static_cast<std::size_t>(info.marks));
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        hrbfnpr_array view{};
        call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_view(marks.get(), layer, attribute, &view, error); });
        if (view.count == 0) continue;
        HRBFNPR_ASSERT(view.scalar == HRBFNPR_SCALAR_FLOAT32 && view.components == 3);
        std::array<float, 3> v{};
        const std::int64_t stride = view.stride != 0 ? view.stride : std::int64_t{sizeof v};
        const auto* at = static_cast<const unsigned char*>(view.data);
        for (std::int64_t i = 0; i < view.count; ++i) {
            std::memcpy(v.data(), at + i * stride, sizeof v);
            to.push_back(glm::dvec3(v[0], v[1], v[2]) + origin);
        }
    }
}

// Returns the mean of the normals. It is computed in single precision, in which the normals are stored.
glm::dvec3 mean_of_normals(const PointSet& marks, Pool& pool) {
    const Points normals = normals_of(marks, pool);
    if (normals.empty()) return glm::dvec3(0.0);
    glm::vec3 sum(0.0F);
    for (const glm::dvec3& n : normals) sum += glm::vec3(n);
    return glm::dvec3(sum / static_cast<float>(normals.size()));
}

// ---- The frame of the picture

// The bounding box of places in a picture, in coordinates from -1 to 1.
struct SeenExtent {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};
    bool is_finite = true;

    void add(const glm::dvec4& clip) noexcept {
        const glm::dvec2 place = glm::dvec2(clip) / clip.w;
        is_finite = is_finite && std::isfinite(place.x) && std::isfinite(place.y);
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
};

std::int32_t side_of_picture(double pixels, std::int32_t longer) noexcept {
    return std::max({static_cast<std::int32_t>(std::nearbyint(pixels)), longer / look_tuning.slimmest, 1});
}

// Returns the camera with its picture cropped to the places. The eye does not move. each_place(visit) calls
// visit(place) for each place.
template <class EachPlace>
hrbfnpr_camera framed_camera(const hrbfnpr_camera& camera, const View& view, EachPlace&& each_place) {
    const CameraMatrix projection = matrix_of(camera.projection);
    const CameraMatrix both = matrix_product(projection, matrix_of(camera.view));
    SeenExtent seen;
    each_place([&](const glm::dvec3& place) { seen.add(matrix_product(both, place)); });
    if (!seen.is_finite || !(seen.low.x <= seen.high.x))
        fail(Status::invalid_argument, "the camera sees nothing: there are no places, or some are not finite");
    const glm::dvec2 old(camera.viewport[2], camera.viewport[3]);
    // The width and height of `seen`, in pixels of the picture before cropping.
    const glm::dvec2 extent = glm::max((seen.high - seen.low) / 2.0 * old, look_tuning.least_extent);
    std::int32_t width = view.width;
    std::int32_t height = view.height;
    if (width <= 0) {
        const double size = view.size;
        const glm::dvec2 sides = size * extent / std::max(extent.x, extent.y);
        width = side_of_picture(sides.x, view.size);
        height = side_of_picture(sides.y, view.size);
    }
    const glm::dvec2 now(width, height);
    const glm::dvec2 scales = (1.0 - 2.0 * view.margin) * now / extent;
    const double scale = std::min(scales.x, scales.y);
    CameraMatrix cut = identity_matrix();
    for (int axis = 0; axis < 2; ++axis) {
        const double factor = scale * old[axis] / now[axis];
        matrix_entry(cut, axis, axis) = factor;
        matrix_entry(cut, axis, 3) = -factor * (seen.low[axis] + seen.high[axis]) / 2.0;
    }
    auto result = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    std::copy(std::begin(camera.view), std::end(camera.view), result.view);
    const CameraMatrix cut_projection = matrix_product(cut, projection);
    std::copy(cut_projection.begin(), cut_projection.end(), result.projection);
    result.viewport[2] = now.x;
    result.viewport[3] = now.y;
    return result;
}

// Returns a camera that looks from the eye at the target, or at the middle of the box if there is no target.
hrbfnpr_camera camera_at_eye(const View& view, const geometry::Bounds& bounds, double angle) {
    const glm::dvec3 eye = *view.eye;
    const glm::dvec3 target = view.target.value_or((bounds.min + bounds.max) / 2.0);
    const double distance = length_in_order(target - eye);
    const double radius = length_in_order(bounds.max - bounds.min);
    const double width = view.width > 0 ? view.width : view.size;
    const double height = view.width > 0 ? view.height : view.size;
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_camera_look_at(&camera, &eye.x, &target.x, &view.up.x, error); });
    call([&](hrbfnpr_error* error) {
        if (angle == 0.0)
            return hrbfnpr_camera_orthographic(&camera, radius, width, height, -distance - radius, distance + radius,
                                               error);
        return hrbfnpr_camera_perspective(&camera, angle, width, height,
                                          std::max(distance - 2.0 * radius, distance / 1000.0), distance + 2.0 * radius,
                                          error);
    });
    return camera;
}

template <class EachPlace>
hrbfnpr_camera camera_that_sees(const View& view, const geometry::Bounds& bounds, bool is_find,
                                EachPlace&& each_place) {
    HRBFNPR_ASSERT((view.width > 0 && view.height > 0) || view.size > 0 || view.camera);
    if (view.camera) return *view.camera;
    const double angle = view.fov.value_or(is_find ? 0.0 : look_tuning.field_of_view) * radians_of_degree;
    if (view.eye) return camera_at_eye(view, bounds, angle);
    const glm::dvec3 direction = view.direction ? *view.direction
                                                : direction_of_view(view.up, view.azimuth.value_or(look_tuning.azimuth),
                                                                    view.elevation.value_or(look_tuning.elevation));
    // The picture is cropped later, so its size does not matter here.
    constexpr double side = 800.0;
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_camera_fit_bounds(&camera, &bounds.min.x, &bounds.max.x, &direction.x, &view.up.x, angle, side,
                                         side, view.margin, error);
    });
    return framed_camera(camera, view, each_place);
}

// ---- Orbits

// Returns the rotation about an axis through a centre.
CameraMatrix rotation_about(const glm::dvec3& axis, const glm::dvec3& centre, double degrees) noexcept {
    const glm::dvec3 unit = unit_in_order(axis);
    const double angle = degrees * radians_of_degree;
    CameraMatrix cross{}; // the matrix of the cross product with the axis
    matrix_entry(cross, 0, 1) = -unit.z;
    matrix_entry(cross, 0, 2) = unit.y;
    matrix_entry(cross, 1, 0) = unit.z;
    matrix_entry(cross, 1, 2) = -unit.x;
    matrix_entry(cross, 2, 0) = -unit.y;
    matrix_entry(cross, 2, 1) = unit.x;
    const double sine = std::sin(angle);
    const double versine = 1.0 - std::cos(angle);
    CameraMatrix result = identity_matrix();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            double square = 0.0;
            for (int k = 0; k < 3; ++k)
                square += versine * matrix_entry(cross, row, k) * matrix_entry(cross, k, column);
            matrix_entry(result, row, column) += sine * matrix_entry(cross, row, column) + square;
        }
    }
    const glm::dvec3 moved = centre - upper_left_times(result, centre);
    for (int row = 0; row < 3; ++row) matrix_entry(result, row, 3) = moved[row];
    return result;
}

} // namespace

// ---- Positions and normals of marks

Probe probe(const Call& call, const Model& model) {
    auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    layer.budget = look_tuning.probe_marks;
    auto desc = defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
    desc.layers = &layer;
    desc.layer_count = 1;
    Probe made(call.pool);
    made.marks = make<PointSet>([&](hrbfnpr_point_set** out, hrbfnpr_error* error) {
        return hrbfnpr_point_set_generate(&call.context, model.get(), &desc, nullptr, out, error);
    });
    made.places = positions_of(made.marks, call.pool);
    made.area = area_of(made.marks);
    made.mean_normal = mean_of_normals(made.marks, call.pool);
    return made;
}

double area_of(const PointSet& marks) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    return info.spacing * info.spacing * static_cast<double>(info.marks);
}

Points positions_of(const PointSet& marks, Pool& pool) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    Points places(&pool);
    append_attribute(places, marks, HRBFNPR_MARK_ATTRIBUTE_POSITION, {info.origin[0], info.origin[1], info.origin[2]});
    return places;
}

Points normals_of(const PointSet& marks, Pool& pool) {
    Points normals(&pool);
    append_attribute(normals, marks, HRBFNPR_MARK_ATTRIBUTE_NORMAL, glm::dvec3(0.0));
    return normals;
}

geometry::Bounds bounds_of(const Model& model) {
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_info(model.get(), &info, error); });
    return {{info.bounds_min[0], info.bounds_min[1], info.bounds_min[2]},
            {info.bounds_max[0], info.bounds_max[1], info.bounds_max[2]}};
}

geometry::Bounds bounds_of(const PointSet& marks) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    return {{info.bounds_min[0], info.bounds_min[1], info.bounds_min[2]},
            {info.bounds_max[0], info.bounds_max[1], info.bounds_max[2]}};
}

geometry::Bounds bounds_of(std::span<const Model> models) {
    geometry::Bounds all;
    for (const Model& model : models) {
        const geometry::Bounds box = bounds_of(model);
        all.min = glm::min(all.min, box.min);
        all.max = glm::max(all.max, box.max);
    }
    return all;
}

// ---- Cameras

View view_of(const Options& options, const glm::dvec3& up) {
    const hrbfnpr_picture_desc& desc = options.desc;
    const auto number = [](double given) { return std::isnan(given) ? std::optional<double>() : given; };
    const auto vector = [](const double(&v)[3]) { return glm::dvec3(v[0], v[1], v[2]); };
    View view;
    view.camera = options.camera;
    view.azimuth = number(desc.azimuth);
    view.elevation = number(desc.elevation);
    if (options.has_direction()) view.direction = vector(desc.direction);
    if (options.has_eye()) view.eye = vector(desc.eye);
    if (options.has_target()) view.target = vector(desc.target);
    view.fov = number(desc.fov);
    view.margin = number(desc.margin).value_or(look_tuning.margin);
    view.up = up;
    if (desc.width > 0 && desc.height > 0) {
        view.width = desc.width;
        view.height = desc.height;
    }
    view.size = desc.size > 0 ? desc.size : look_tuning.long_side;
    return view;
}

hrbfnpr_camera camera_for(const View& view, const geometry::Bounds& bounds, const Points& places, bool is_find) {
    return camera_that_sees(view, bounds, is_find, [&](auto&& visit) {
        for (const glm::dvec3& place : places) visit(place);
    });
}

hrbfnpr_camera with_depth_of(const hrbfnpr_camera& camera, const Points& places) noexcept {
    HRBFNPR_ASSERT(camera.depth_convention == HRBFNPR_DEPTH_NEGATIVE_ONE_TO_ONE);
    const CameraMatrix view = matrix_of(camera.view);
    hrbfnpr_camera result = camera;
    const double a = camera.projection[10];
    const double b = camera.projection[14];
    const bool is_perspective = camera.projection[11] != 0.0;
    double nearest = is_perspective ? b / (a - 1.0) : (b + 1.0) / a;
    double farthest = is_perspective ? b / (a + 1.0) : (b - 1.0) / a;
    const double least = look_tuning.nearest_plane * nearest;
    for (const glm::dvec3& place : places) {
        const double depth = -matrix_product(view, place).z;
        nearest = std::min(nearest, is_perspective ? std::max(depth, least) : depth);
        farthest = std::max(farthest, depth);
    }
    const double range = farthest - nearest;
    result.projection[10] = is_perspective ? -(farthest + nearest) / range : -2.0 / range;
    result.projection[14] = is_perspective ? -2.0 * farthest * nearest / range : -(farthest + nearest) / range;
    return result;
}

glm::dvec3 direction_of_view(const glm::dvec3& up, double azimuth, double elevation) noexcept {
    const LookAxes axes = axes_of_view(up);
    const double around = azimuth * radians_of_degree;
    const double above = elevation * radians_of_degree;
    return -(std::cos(above) * (std::cos(around) * axes.front + std::sin(around) * axes.right) +
             std::sin(above) * axes.up);
}

double azimuth_of(const glm::dvec3& up, const glm::dvec3& direction) noexcept {
    const LookAxes axes = axes_of_view(up);
    return within_a_turn(std::atan2(dot_in_order(direction, axes.right), dot_in_order(direction, axes.front)) *
                         degrees_of_radian);
}

std::optional<double> front_azimuth(const glm::dvec3& up, const glm::dvec3& normal) noexcept {
    const glm::dvec3 usual = -direction_of_view(up, look_tuning.azimuth, look_tuning.elevation);
    const glm::dvec3 upward = axes_of_view(up).up;
    const double across_up = length_in_order(normal - dot_in_order(normal, upward) * upward);
    if (!(dot_in_order(normal, usual) < 0.0) || !(across_up >= look_tuning.looks_one_way)) return std::nullopt;
    return whole_degrees(azimuth_of(up, normal) + look_tuning.azimuth);
}

void look_at_front(const Call& call, View& view, const Shape* shape, std::span<const Probe> probes) {
    HRBFNPR_ASSERT(!probes.empty());
    if (view.camera || view.eye || view.direction || view.azimuth) return;
    if (shape != nullptr && shape->is_photo && shape->viewpoint) {
        glm::dvec3 sum(0.0);
        std::size_t count = 0;
        for (const Probe& one : probes) {
            for (const glm::dvec3& place : one.places) sum += place;
            count += one.places.size();
        }
        const glm::dvec3 towards = *shape->viewpoint - sum / static_cast<double>(count);
        view.azimuth = whole_degrees(azimuth_of(view.up, towards));
        view.elevation = view.elevation.value_or(0.0);
        call.report.note(
            HRBFNPR_NOTE_SEEN_FROM_CAMERA, {*view.azimuth},
            formatted(call.pool, "the depth image is drawn from where its camera stood, azimuth %g", *view.azimuth),
            {.detail = "Other sides lack whatever the camera did not see."});
        return;
    }
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const Probe& one : probes) {
        sum += one.mean_normal * one.area;
        area += one.area;
    }
    const std::optional<double> azimuth = front_azimuth(view.up, sum / area);
    if (!azimuth) return;
    view.azimuth = azimuth;
    call.report.note(HRBFNPR_NOTE_SEEN_FROM_FRONT, {*azimuth},
                     formatted(call.pool,
                               "the surface is drawn from its front, azimuth %g ({azimuth=%g} shows its back)",
                               *azimuth, look_tuning.azimuth));
}

glm::dvec4 clip_place(const hrbfnpr_camera& camera, const glm::dvec3& place) noexcept {
    return matrix_product(matrix_product(matrix_of(camera.projection), matrix_of(camera.view)), place);
}

double pixels_per_unit(const hrbfnpr_camera& camera, const glm::dvec3& place) noexcept {
    const double magnified = matrix_entry(matrix_of(camera.projection), 1, 1);
    return camera.viewport[3] / 2.0 * std::abs(magnified) / std::abs(clip_place(camera, place).w);
}

// ---- Orbits

glm::dvec3 orbit_centre(const View& view, const geometry::Bounds& bounds) noexcept {
    return view.eye && view.target ? *view.target : (bounds.min + bounds.max) / 2.0;
}

hrbfnpr_camera first_camera(const View& view, const geometry::Bounds& bounds, const Points& places, double turn,
                            std::int32_t frames, bool is_find) {
    HRBFNPR_ASSERT(frames >= 1);
    const glm::dvec3 centre = orbit_centre(view, bounds);
    const std::int32_t steps = std::min(look_tuning.orbit_steps, frames);
    const auto each_swept = [&](auto&& visit) {
        for (std::int32_t i = 0; i <= steps; ++i) {
            const double degrees = i == steps ? turn : i * (turn / steps);
            const CameraMatrix rotation = rotation_about(view.up, centre, -degrees);
            const glm::dvec3 moved(matrix_entry(rotation, 0, 3), matrix_entry(rotation, 1, 3),
                                   matrix_entry(rotation, 2, 3));
            for (const glm::dvec3& place : places) visit(upper_left_times(rotation, place) + moved);
        }
    };
    geometry::Bounds swept;
    each_swept([&](const glm::dvec3& place) { swept.extend(place); });
    return camera_that_sees(view, swept, is_find, each_swept);
}

hrbfnpr_camera turned(const hrbfnpr_camera& camera, const glm::dvec3& axis, const glm::dvec3& centre,
                      double degrees) noexcept {
    hrbfnpr_camera result = camera;
    const CameraMatrix view = matrix_product(matrix_of(camera.view), rotation_about(axis, centre, -degrees));
    std::copy(view.begin(), view.end(), result.view);
    return result;
}

} // namespace hrbfnpr::picture
