// SPDX-License-Identifier: MIT
#include "frame/scene/scene.h"

#include "frame/scene/pose.h"
#include "frame/scene/turn.h"
#include "geometry/unit.h"

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

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
    view.both_sides = item.both_sides;
    view.model = item.model;
    view.lines = item.lines;
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

// Whether the layer is spread over the surface. Strokes of the caller's may be few and anywhere: they tell neither
// where the surface is nor where its contours are, and make no tone.
bool is_surface(const marks::Layer& layer) noexcept { return !(layer.kind == marks::Kind::own && layer.has_strokes()); }

bool is_used(const LayerStyle& style) noexcept { return style.shown || style.contours; }

bool is_drawn(const marks::Layer& layer, const Style& style) noexcept {
    return layer.count() > 0 && is_used(style.of(layer));
}

bool has_surface(const marks::PointSet& set, const Style& style) noexcept {
    return std::any_of(set.layers.begin(), set.layers.end(),
                       [&](const marks::Layer& layer) { return is_drawn(layer, style) && is_surface(layer); });
}

// Which layer's marks are the splats of an item; -1: none's.  Stipples are spread the most evenly, so theirs are
// unless they are few.
std::int64_t splat_layer(const marks::PointSet& set, const Style& style) {
    const bool any_surface = has_surface(set, style);
    std::int64_t largest = -1;
    std::int64_t stipples = -1;
    for (std::int64_t i = 0; i < set.layers.size(); ++i) {
        const marks::Layer& layer = set.layers[i];
        if (!is_drawn(layer, style) || is_surface(layer) != any_surface) continue;
        if (largest < 0 || layer.count() > set.layers[largest].count()) largest = i;
        if (layer.kind == marks::Kind::stipples && (stipples < 0 || layer.count() > set.layers[stipples].count()))
            stipples = i;
    }
    const bool enough = stipples >= 0 && 4 * set.layers[stipples].count() >= set.layers[largest].count();
    return enough ? stipples : largest;
}

// The size of a mark's piece of surface: known for the largest layer, in others by their number.
double spacing_of(const marks::PointSet& set, const marks::Layer& layer) {
    const double ratio = static_cast<double>(set.largest()) / static_cast<double>(layer.count());
    return set.spacing * std::sqrt(ratio);
}

Pen pen_of(const Style& style, const LayerStyle& layer, double spacing, double eye_per_object, const Lens& lens) {
    Pen pen;
    pen.spacing = static_cast<float>(spacing * eye_per_object);
    if (style.zoom_reference > 0.0)
        pen.zoom_at_one = static_cast<float>(static_cast<double>(lens.eye_per_world) / style.zoom_reference);
    pen.zoom_exponent = static_cast<float>(style.zoom_exponent);
    pen.ink_radius = layer.radius;
    pen.ink_zoom = layer.radius_zoom;
    pen.silhouette_radius = style.silhouette_radius;
    pen.silhouette_zoom = style.silhouette_radius_zoom;
    pen.splat_radius = style.splat_radius;
    pen.halo = style.halo_width;
    pen.overlap = style.splat_overlap;
    pen.lambda_front = static_cast<float>(style.attenuation_front);
    pen.lambda_back = static_cast<float>(style.attenuation_back);
    pen.largest_splat = lens.diagonal;
    return pen;
}

glm::vec4 color(const float* c) noexcept { return {c[0], c[1], c[2], c[3]}; }

// The runs of one item, which is the last of the scene's, and what the drawing knows of its layers.
class RunMaker {
public:
    RunMaker(Scene& scene, const Item& item, std::int32_t number, drawing::Drawing& drawing) noexcept
        : scene_(scene), item_(item), style_(item.style), place_(static_cast<std::int32_t>(scene.items.size() - 1)),
          number_(number), drawing_(drawing), splats_(splat_layer(*item.set, item.style)),
          any_surface_(has_surface(*item.set, item.style)),
          eye_per_object_(mean_scale(item.transform) * static_cast<double>(scene.lens.eye_per_world)) {}

    void operator()() {
        for (std::int64_t i = 0; i < item_.set->layers.size(); ++i) {
            const marks::Layer& layer = item_.set->layers[i];
            note(i, layer);
            if (is_drawn(layer, style_)) add(made(i, layer, style_.of(layer), drawing_.runs.back().first_id));
        }
    }

    // The same marks seen from the other side; `first_run` of the drawing's is that of its first layer.
    void turned(std::int64_t first_run) {
        for (std::int64_t i = 0; i < item_.set->layers.size(); ++i) {
            const marks::Layer& layer = item_.set->layers[i];
            if (!is_drawn(layer, style_)) continue;
            Run run = made(i, layer, style_.of(layer), drawing_.runs[first_run + i].first_id);
            run.turned = true;
            run.draws_silhouettes = run.paints_paper = run.occludes = run.splats = false; // its front side does
            if (run.draws_front) add(run);
        }
    }

private:
    // Ids count the marks of all layers.
    void note(std::int64_t number, const marks::Layer& layer) {
        const std::int64_t before =
            drawing_.runs.empty() ? 0 : drawing_.runs.back().first_id - 1 + drawing_.runs.back().count;
        if (before + layer.count() > most_marks)
            fail(Status::invalid_argument, "items[%lld].point_set brings the drawing to %lld marks; the most are %lld",
                 static_cast<long long>(number_), static_cast<long long>(before + layer.count()),
                 static_cast<long long>(most_marks));
        drawing::Run run;
        run.item = number_;
        run.layer = static_cast<std::int32_t>(number);
        run.count = layer.count();
        run.first_id = static_cast<std::uint32_t>(before + 1);
        drawing_.runs.push_back(run);
    }

    [[nodiscard]] Run made(std::int64_t number, const marks::Layer& marks, const LayerStyle& style,
                           std::uint32_t first_id) const noexcept {
        Run run;
        run.marks = &marks;
        run.style = &style;
        run.position = marks.position.data();
        run.normal = marks.normal.data();
        run.clusters = &marks.clusters;
        run.item = place_;
        run.source = number_;
        run.layer = static_cast<std::int32_t>(number);
        run.first = scene_.runs.empty() ? 0 : scene_.runs.back().first + scene_.runs.back().count;
        run.count = marks.count();
        run.first_id = first_id;
        run.scattered = !marks.has_strokes();
        // A stipple belongs to no direction.
        run.directions = run.scattered ? 3U : style.directions;
        run.draws_front = style.shown && style.share > 0.0F && run.directions != 0;
        run.draws_silhouettes = style_.visibility == Visibility::published && style.contours && is_surface(marks);
        run.makes_tone = is_surface(marks) || !any_surface_;
        const bool splats = number == splats_;
        // With a given overlap, one evenly spread layer is as opaque as all; as published, every mark counts.
        run.paints_paper = style_.hidden_lines == HiddenLines::attenuate && (splats || !(style_.splat_overlap > 0.0F));
        run.occludes = style_.hidden_lines == HiddenLines::hide && splats;
        run.splats = style_.hidden_lines != HiddenLines::show && splats;
        run.spread_evenly = marks.progressive;
        if (run.spread_evenly && !run.scattered)
            run.separation = static_cast<float>(marks.report.step * eye_per_object_);
        const bool lines = style_.visibility == Visibility::depth_layers && !run.scattered && run.draws_front;
        run.as_strokes = style.shape == Shape::strokes && lines;
        run.as_hatch = style.shape == Shape::hatch && lines;
        run.pen = pen_of(style_, style, spacing_of(*item_.set, marks), eye_per_object_, scene_.lens);
        return run;
    }

    void add(Run run) {
        if (run.as_strokes) run.first_joined = std::exchange(scene_.joined, scene_.joined + run.count);
        scene_.runs.push_back(run);
        add_layer(run, drawing::MarkClass::front, color(run.style->ink));
        add_layer(run, drawing::MarkClass::silhouette, style_.silhouette_ink);
    }

    void add_layer(const Run& run, drawing::MarkClass mark_class, const glm::vec4& ink) {
        drawing::Layer layer;
        layer.item = run.source;
        layer.layer = run.layer;
        layer.mark_class = mark_class;
        layer.as_strokes = (run.as_strokes || run.as_hatch) && mark_class == drawing::MarkClass::front;
        layer.as_hatch = run.as_hatch && layer.as_strokes;
        layer.ink = ink;
        drawing_.layers.push_back(layer);
    }

    Scene& scene_;
    const Item& item_;
    const Style& style_;
    std::int32_t place_, number_; // of the item: among the scene's, and those of the drawing
    drawing::Drawing& drawing_;
    std::int64_t splats_;
    bool any_surface_;
    double eye_per_object_;
};

void check_common(std::span<const Item> items, std::int64_t index) {
    const Style& style = items[static_cast<std::size_t>(index)].style;
    if (style.paper != items[0].style.paper)
        fail(Status::invalid_argument,
             "items[%lld].style.paper differs from that of items[0]; all styles of a drawing need the same paper",
             static_cast<long long>(index));
    if (style.visibility != items[0].style.visibility)
        fail(Status::invalid_argument,
             "items[%lld].style.visibility differs from that of items[0]; all styles of a drawing need the same",
             static_cast<long long>(index));
}

// Items after all others, with the numbers of their front sides.  Lines are seen from both sides already.
void add_other_sides(Scene& scene, std::span<const Item> items, drawing::Drawing& drawing) {
    std::int64_t first_run = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].both_sides) {
            scene.items.push_back(ItemView(scene.items[static_cast<std::int64_t>(i)]));
            RunMaker(scene, items[i], static_cast<std::int32_t>(i), drawing).turned(first_run);
        }
        first_run += items[i].set->layers.size();
    }
}

} // namespace

glm::vec3 Run::posed_tone_normal(std::int64_t mark) const noexcept {
    if (posed_direction == nullptr) return turned ? -normal_of(mark) : normal_of(mark);
    const glm::vec3 soft = marks::vector_at(marks->tone_normal, mark);
    const glm::vec3 n = marks::vector_at(marks->normal, mark);
    const glm::vec3 d = marks::vector_at(marks->direction, mark);
    const glm::vec3 along(posed_direction[3 * mark], posed_direction[3 * mark + 1], posed_direction[3 * mark + 2]);
    const glm::vec3 now = turned ? -normal_of(mark) : normal_of(mark);
    return glm::dot(soft, n) * now + glm::dot(soft, d) * along +
           glm::dot(soft, glm::cross(n, d)) * glm::cross(now, along);
}

void Marks::resize(std::int64_t count) {
    x.resize(count);
    y.resize(count);
    window_depth.resize(count);
    depth.resize(count);
    pixels_per_unit.resize(count);
    nu.resize(count);
    tau.resize(count);
    tau_depth.resize(count);
    mark_class.resize(count);
    role.resize(count);
}

std::int64_t Marks::bytes() const noexcept {
    return x.bytes() + y.bytes() + window_depth.bytes() + depth.bytes() + pixels_per_unit.bytes() + nu.bytes() +
           tau.bytes() + tau_depth.bytes() + mark_class.bytes() + role.bytes();
}

std::int64_t Scene::bytes() const noexcept {
    return items.bytes() + runs.bytes() + chunks.bytes() + marks.bytes() + turned_normal.bytes();
}

void set_up(Scene& scene, std::span<const Item> items, const Camera& given, drawing::Drawing& drawing) {
    check(given);
    const Camera camera = in_unit(given, geometry::unit_for(reach_of(items, given)));
    scene.lens = make_lens(camera);
    scene.camera = camera;
    scene.items.clear();
    scene.runs.clear();
    scene.joined = 0;
    drawing.clear();
    drawing.window = {given.viewport, given.depth};
    drawing.from_window = glm::inverse(make_optics(camera).window * camera.view);
    drawing.paper = items.empty() ? Style{}.paper : items[0].style.paper;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto index = static_cast<std::int64_t>(i);
        check_transform(items[i].transform, index);
        check_common(items, index);
        scene.items.push_back(view_of(items[i], camera));
        const ItemView& view = scene.items.back();
        drawing.items.push_back({items[i].set, view.unit, view.to_world, view.normal_to_world});
        RunMaker(scene, items[i], static_cast<std::int32_t>(i), drawing)();
    }
    add_other_sides(scene, items, drawing);
    pose(scene, items, drawing);
    turn(scene);
    std::int64_t places = 0;
    for (Run& run : scene.runs) run.first_place = std::exchange(places, places + run.places());
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
