#include "frame/scene/scene.h"

#include "geometry/unit.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t chunk_size = 4096;
constexpr std::int64_t most_marks = 0x7FFFFFFF; // an order key holds a mark and one bit in 32

// Inverse transpose, scaled to fit into floats: only the direction of its products counts.
glm::mat3 normal_matrix(const glm::dmat4& m) {
    const glm::dmat3 inverse = glm::inverseTranspose(glm::dmat3(m));
    double largest = 0.0;
    for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(inverse[i / 3][i % 3]));
    return glm::mat3(inverse / largest);
}

void check_transform(const glm::dmat4& m, std::int64_t index) {
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(m[i / 4][i % 4]))
            fail(Status::invalid_argument, "items[%lld].transform[%d] is %g; all 16 elements must be finite",
                 static_cast<long long>(index), i, m[i / 4][i % 4]);
    }
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0)
        fail(Status::invalid_argument,
             "items[%lld].transform is not affine; its last row (elements 3, 7, 11, 15) must be 0 0 0 1",
             static_cast<long long>(index));
    if (!(mean_scale(m) > 0.0))
        fail(Status::invalid_argument, "items[%lld].transform is singular; it must be invertible",
             static_cast<long long>(index));
}

// How far from the eye the items reach, in its space.
double reach_of(std::span<const Item> items, const Camera& camera) noexcept {
    double farthest = 0.0;
    for (const Item& item : items) {
        if (item.set->bounds.empty()) continue;
        const glm::dmat4 to_eye = camera.view * item.transform;
        const double middle = glm::length(glm::dvec3(to_eye * glm::dvec4(item.set->bounds.centre(), 1.0)));
        farthest = std::max(farthest, middle + 0.5 * mean_scale(to_eye) * item.set->bounds.diagonal());
    }
    return farthest;
}

// The same camera, whose eye space is measured in that unit.  Projections give the same pixels for any factor.
Camera in_unit(Camera camera, double unit) noexcept {
    if (unit == 1.0) return camera;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) camera.view[column][row] /= unit;
    for (int column = 0; column < 3; ++column) camera.projection[column] *= unit;
    double largest = 0.0; // of what w is made of
    for (int column = 0; column < 4; ++column) largest = std::max(largest, std::abs(camera.projection[column][3]));
    camera.projection /= geometry::unit_for(largest);
    return camera;
}

ItemView view_of(const Item& item, const Camera& camera) {
    ItemView view;
    view.style = item.style;
    view.model = item.model;
    view.origin = item.set->origin;
    view.unit = item.set->unit;
    if (!item.set->bounds.empty()) {
        view.centre = glm::vec3((item.set->bounds.centre() - item.set->origin) / view.unit);
        view.radius = static_cast<float>(0.5 * item.set->bounds.diagonal() / view.unit * 1.0001);
    }
    // Far from the world's origin the large numbers cancel here, in double.
    view.to_world = item.transform;
    for (int axis = 0; axis < 3; ++axis) view.to_world[axis] *= view.unit;
    view.to_world[3] = item.transform * glm::dvec4(item.set->origin, 1.0);
    const glm::dmat4 to_eye = camera.view * view.to_world;
    view.to_eye = glm::mat3(glm::dmat3(to_eye));
    view.eye_offset = glm::vec3(glm::dvec3(to_eye[3]));
    view.normal_to_eye = normal_matrix(to_eye);
    view.normal_to_world = normal_matrix(view.to_world);
    view.normal_to_light = item.style.light_space == LightSpace::camera ? view.normal_to_eye : view.normal_to_world;
    const double length = glm::length(item.style.light);
    if (length > 0.0) view.light = glm::vec3(item.style.light / length);
    return view;
}

// The place of a kind in Style::group.
std::size_t style_of(marks::Kind kind) noexcept {
    return kind == marks::Kind::principal ? 1U : kind == marks::Kind::combing ? 2U : 0U;
}

bool draws_contours(const Style& style, const marks::Layer& layer) noexcept {
    return (style.silhouette_groups >> style_of(layer.kind) & 1U) != 0;
}

bool is_used(const Style& style, const marks::Layer& layer) noexcept {
    return layer.count() > 0 && (style.group[style_of(layer.kind)].shown || draws_contours(style, layer));
}

// Which layer's marks paint the paper of an item.  Stipples are spread the most evenly, so they do
// unless they are few.
const marks::Layer* cover_layer(const marks::PointSet& set, const Style& style) {
    const marks::Layer* largest = nullptr;
    const marks::Layer* stipples = nullptr; // the largest of them
    for (const marks::Layer& layer : set.layers) {
        if (!is_used(style, layer)) continue;
        if (largest == nullptr || layer.count() > largest->count()) largest = &layer;
        if (!layer.has_strokes() && (stipples == nullptr || layer.count() > stipples->count())) stipples = &layer;
    }
    return stipples != nullptr && 4 * stipples->count() >= largest->count() ? stipples : largest;
}

// The size of a mark's piece of surface: known for the largest layer, in others by their number.
double spacing_of(const marks::PointSet& set, const marks::Layer& layer) {
    const double ratio = static_cast<double>(set.largest()) / static_cast<double>(layer.count());
    return set.spacing * std::sqrt(ratio);
}

Pen pen_of(const Style& style, std::size_t group, double spacing, double eye_per_object, const Lens& lens) {
    Pen pen;
    pen.spacing = static_cast<float>(spacing * eye_per_object);
    if (style.zoom_reference > 0.0)
        pen.zoom_per_ppe = static_cast<float>(static_cast<double>(lens.eye_per_world) / style.zoom_reference);
    pen.zoom_exponent = static_cast<float>(style.zoom_exponent);
    pen.ink_radius = style.group[group].radius;
    pen.ink_zoom = style.group[group].radius_zoom;
    pen.silhouette_radius = style.silhouette_radius;
    pen.silhouette_zoom = style.silhouette_radius_zoom;
    pen.cover_radius = style.cover_radius;
    pen.halo = style.halo_width;
    pen.layers = style.cover_layers;
    pen.lambda_front = static_cast<float>(style.attenuation_front);
    pen.lambda_back = static_cast<float>(style.attenuation_back);
    pen.largest_cover = lens.diagonal;
    return pen;
}

void add_runs(Scene& scene, const Item& item, std::int64_t item_index, std::int64_t& ids) {
    const Style& style = item.style;
    const marks::Layer* const cover = cover_layer(*item.set, style);
    const double eye_per_object = mean_scale(item.transform) * static_cast<double>(scene.lens.eye_per_world);
    float earlier = 0.0F;
    for (const marks::Layer& layer : item.set->layers) {
        const std::int64_t first_id = ids + 1;
        ids += layer.count();
        if (!is_used(style, layer)) continue;
        const std::size_t g = style_of(layer.kind);
        Run run;
        run.marks = &layer;
        run.item = static_cast<std::int32_t>(item_index);
        run.group = static_cast<std::int32_t>(g);
        run.first = scene.runs.empty() ? 0 : scene.runs.back().first + scene.runs.back().count;
        run.count = layer.count();
        run.first_place = scene.place_count();
        run.first_id = static_cast<std::uint32_t>(first_id);
        // A mark of no stroke belongs to no set of directions.
        run.sets = g == 0 || !layer.has_strokes() ? 3U : style.group[g].sets;
        run.draws_front = style.group[g].shown && style.group[g].share > 0.0F && run.sets != 0;
        run.draws_silhouettes = draws_contours(style, layer);
        // With layers, one evenly spread layer of marks is as opaque as all; as published, every mark counts.
        const bool covers = &layer == cover || !(style.cover_layers > 0.0F);
        run.paints_paper = style.hidden_lines == HiddenLines::attenuate && covers;
        run.occludes = style.hidden_lines == HiddenLines::hide && &layer == cover;
        run.spread_evenly = layer.progressive;
        if (run.spread_evenly && layer.has_strokes())
            run.separation = static_cast<float>(layer.report.step * eye_per_object);
        run.covers = style.hidden_lines != HiddenLines::show && &layer == cover;
        run.pen = pen_of(style, g, spacing_of(*item.set, layer), eye_per_object, scene.lens);
        run.earlier_contours = earlier;
        if (run.draws_silhouettes) earlier += 1.0F / (run.pen.spacing * run.pen.spacing);
        scene.runs.push_back(run);
    }
    if (ids > most_marks)
        fail(Status::invalid_argument, "items[%lld].point_set brings the frame to %lld marks; the most are %lld",
             static_cast<long long>(item_index), static_cast<long long>(ids), static_cast<long long>(most_marks));
}

} // namespace

void Marks::resize(std::int64_t count) {
    x.resize(count);
    y.resize(count);
    window_depth.resize(count);
    depth.resize(count);
    ppe.resize(count);
    nu.resize(count);
    tau.resize(count);
    tau_depth.resize(count);
    mark_class.resize(count);
    role.resize(count);
}

std::int64_t Marks::bytes() const noexcept {
    return x.bytes() + y.bytes() + window_depth.bytes() + depth.bytes() + ppe.bytes() + nu.bytes() + tau.bytes() +
           tau_depth.bytes() + mark_class.bytes() + role.bytes();
}

std::int64_t Scene::bytes() const noexcept { return items.bytes() + runs.bytes() + chunks.bytes() + marks.bytes(); }

void set_up(Scene& scene, std::span<const Item> items, const Camera& given) {
    check(given);
    const Camera camera = in_unit(given, geometry::unit_for(reach_of(items, given)));
    scene.lens = make_lens(camera);
    scene.items.clear();
    scene.runs.clear();
    std::int64_t ids = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        check_transform(items[i].transform, index);
        if (items[i].style.paper != items[0].style.paper)
            fail(Status::invalid_argument,
                 "items[%lld].style.paper differs from that of items[0]; all styles of a frame need the same paper",
                 static_cast<long long>(index));
        if (items[i].style.visibility != items[0].style.visibility)
            fail(Status::invalid_argument,
                 "items[%lld].style.visibility differs from that of items[0]; all styles of a frame need the same",
                 static_cast<long long>(index));
        scene.items.push_back(view_of(items[i], camera));
        add_runs(scene, items[i], index, ids);
    }
}

void add_chunks(Scene& scene) {
    scene.chunks.clear();
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        for (std::int64_t begin = 0; begin < run.count; begin += chunk_size) {
            const std::int64_t end = std::min(run.count, begin + chunk_size);
            scene.chunks.push_back({static_cast<std::int32_t>(r), run.first + begin, run.first + end});
        }
    }
    scene.marks.resize(scene.mark_count());
}

} // namespace hrbfnpr::frame
