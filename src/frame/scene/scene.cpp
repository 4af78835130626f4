// SPDX-License-Identifier: MIT
// set_up, step by step:
//
// 1. unit_camera: the camera in a unit in which floats hold the items' squares and cubes
// 2. view_of: the matrices of each item
// 3. note_layers: the ids of the marks of all layers
// 4. add_runs: a run for each layer that takes part, and the drawing's layers of ink; called again for the
//    other sides of surfaces that are drawn on both sides
// 5. read_pose, pose_runs: places and clusters of marks that have moved
// 6. add_turned_runs: normals and clusters of the other sides
#include "frame/scene/scene.h"

#include "frame/scene/angles.h"
#include "frame/scene/still.h"
#include "geometry/unit.h"
#include "marks/point_set.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::frame {
namespace {

using ll = long long; // The type of numbers in messages.

constexpr std::int64_t marks_a_call = 4096;     // The largest number of marks in one call of a tone callback.
constexpr std::int64_t most_marks = 0x7FFFFFFF; // An order key stores the index of a mark and one bit in 32 bits.
// The allowed difference of a pose's unit vectors from the length 1. Floats are rounded.
constexpr double most_off_unit = 1e-2;
constexpr double farthest = 1e33; // The largest number in a pose, because marks are stored as floats.

// ---- Items

void check_item(std::span<const Item> items, std::int64_t index) {
    const Item& item = items[static_cast<std::size_t>(index)];
    const glm::dmat4& m = item.transform;
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4]))
            fail(Status::invalid_argument, "items[%lld].transform[%d] is %g; all 16 elements must be finite", ll{index},
                 i, m[i / 4][i % 4]);
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0)
        fail(Status::invalid_argument,
             "items[%lld].transform is not affine; its last row (elements 3, 7, 11, 15) must be 0 0 0 1", ll{index});
    if (!(mean_scale(m) > 0.0))
        fail(Status::invalid_argument, "items[%lld].transform is singular; it must be invertible", ll{index});
    if (item.style.paper != items[0].style.paper)
        fail(Status::invalid_argument,
             "items[%lld].style.paper differs from that of items[0]; all styles of a drawing need the same paper",
             ll{index});
    if (item.style.visibility != items[0].style.visibility)
        fail(Status::invalid_argument,
             "items[%lld].style.visibility differs from that of items[0]; all styles of a drawing need the same "
             "visibility",
             ll{index});
}

// Refuses marks that were placed for another drawing.
void check_still(const Item& item, const Camera& camera, std::int64_t index) {
    const base::Array<double>& made_for = item.set->still;
    if (made_for.empty()) return;
    const base::Array<double> key =
        still_key(item.set->layers.memory(), {camera, item.style, item.both_sides, item.transform});
    if (key.size() != made_for.size() || !std::equal(key.begin(), key.end(), made_for.begin()))
        fail(Status::invalid_argument,
             "items[%lld].point_set has only the marks that another camera, transform or style needs; make it by "
             "hrbfnpr_point_set_generate, or its picture with HRBFNPR_PICTURE_KEEP_MARKS",
             ll{index});
}

// Returns the camera with its eye space in another unit. The unit suits the largest distance of items from the eye.
// Pixels do not depend on the unit.
struct UnitCamera {
    Camera camera;
    double unit = 1.0; // the unit of its eye space, in the caller's
};
UnitCamera unit_camera(Camera camera, std::span<const Item> items) noexcept {
    double reach = 0.0;
    for (const Item& item : items) {
        if (item.set->bounds.empty()) continue;
        const glm::dmat4 to_eye = camera.view * item.transform;
        const double middle = glm::length(glm::dvec3(to_eye * glm::dvec4(item.set->bounds.centre(), 1.0)));
        reach = std::max(reach, middle + 0.5 * mean_scale(to_eye) * item.set->bounds.diagonal());
    }
    const double unit = geometry::unit_for(reach);
    if (unit == 1.0) return {camera};
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) camera.view[column][row] /= unit;
    for (int column = 0; column < 3; ++column) camera.projection[column] *= unit;
    double largest = 0.0; // the largest coefficient in the row of w
    for (int column = 0; column < 4; ++column) largest = std::max(largest, std::abs(camera.projection[column][3]));
    camera.projection /= geometry::unit_for(largest);
    return {camera, unit};
}

ItemView view_of(const Item& item, const UnitCamera& given) {
    const Camera& camera = given.camera;
    ItemView view;
    view.style = item.style;
    view.both_sides = item.both_sides;
    view.model = item.model;
    view.lines = item.lines;
    view.shading = item.shading;
    view.origin = item.set->origin;
    view.unit = item.set->unit;
    if (!item.set->bounds.empty()) {
        view.centre = glm::vec3((item.set->bounds.centre() - item.set->origin) / view.unit);
        view.radius = static_cast<float>(0.5 * item.set->bounds.diagonal() / view.unit) * scene_tuning.rounding;
    }
    // If items are far from the origin, large numbers cancel here, so it is computed in double.
    view.to_world = item.transform;
    for (int axis = 0; axis < 3; ++axis) view.to_world[axis] *= view.unit;
    view.to_world[3] = item.transform * glm::dvec4(item.set->origin, 1.0);
    const glm::dmat4 to_eye = camera.view * view.to_world;
    view.to_eye = glm::mat3(glm::dmat3(to_eye));
    view.eye_offset = glm::vec3(glm::dvec3(to_eye[3]));
    view.normal_to_eye = normal_matrix(to_eye);
    view.normal_to_world = normal_matrix(view.to_world);
    view.lighting = lighting_of(item.style, {view.to_world, to_eye, camera.view, given.unit, view.origin, view.unit});
    return view;
}

// ---- Layers and runs

// Returns whether the layer is spread over the whole surface. The caller's own strokes may be few and anywhere. They do
// not show where the surface or its contours are, and make no tone.
bool is_surface(const marks::Layer& layer) noexcept { return !(layer.kind == marks::Kind::own && layer.has_strokes()); }

// Returns whether the layer takes part in the drawing. A layer that is not shown may still show where the surface hides
// other ink, unless its style also turns off its contours.
bool takes_part(const marks::Layer& layer, const Style& style) noexcept {
    const LayerStyle& own = style.of(layer);
    return layer.count() > 0 && (own.shown || own.contours);
}

bool has_surface(const marks::PointSet& set, const Style& style) noexcept {
    return std::any_of(set.layers.begin(), set.layers.end(),
                       [&](const marks::Layer& layer) { return takes_part(layer, style) && is_surface(layer); });
}

// Returns the layer whose marks are the splats of an item, or -1. Stipples are preferred, because they are spread most
// evenly.
std::int64_t splat_layer(const marks::PointSet& set, const Style& style) {
    const bool any_surface = has_surface(set, style);
    const auto larger = [&](std::int64_t than, std::int64_t i) {
        return than < 0 || set.layers[i].whole_count() > set.layers[than].whole_count() ? i : than;
    };
    std::int64_t largest = -1;
    std::int64_t stipples = -1;
    for (std::int64_t i = 0; i < set.layers.size(); ++i) {
        const marks::Layer& layer = set.layers[i];
        if (!takes_part(layer, style) || is_surface(layer) != any_surface) continue;
        largest = larger(largest, i);
        if (layer.kind == marks::Kind::stipples) stipples = larger(stipples, i);
    }
    if (stipples < 0) return largest;
    const double enough = scene_tuning.enough_stipples * static_cast<double>(set.layers[largest].whole_count());
    return static_cast<double>(set.layers[stipples].whole_count()) >= enough ? stipples : largest;
}

// Assigns ids to the marks of all layers of all items, whether they are drawn or not.
void note_layers(const marks::PointSet& set, std::int32_t number, drawing::Drawing& drawing) {
    for (std::int64_t i = 0; i < set.layers.size(); ++i) {
        const std::int64_t before =
            drawing.runs.empty() ? 0 : drawing.runs.back().first_id - 1 + drawing.runs.back().count;
        const std::int64_t after = before + set.layers[i].count();
        if (after > most_marks)
            fail(Status::invalid_argument,
                 "items[%lld].point_set brings the drawing to %lld marks; at most %lld are allowed", ll{number},
                 ll{after}, ll{most_marks});
        drawing::Run run;
        run.item = number;
        run.layer = static_cast<std::int32_t>(i);
        run.count = set.layers[i].count();
        run.first_id = static_cast<std::uint32_t>(before + 1);
        drawing.runs.push_back(run);
    }
}

// Makes the run of a layer. The members that refer to the scene are set later. `splats` is true if the layer's marks
// are the splats of the item.
Run run_of(const Item& item, const marks::Layer& layer, bool splats, bool any_surface, const Lens& lens) {
    HRBFNPR_ASSERT(layer.count() > 0);
    const Style& style = item.style;
    const LayerStyle& own = style.of(layer);
    const bool published = style.visibility == Visibility::published;
    Run run;
    run.marks = &layer;
    run.style = &own;
    run.position = layer.position.data();
    run.normal = layer.normal.data();
    run.clusters = &layer.clusters;
    run.count = layer.count();
    // A stipple has no direction, so it belongs to both directions.
    run.directions = run.is_scattered() ? 3U : own.directions;
    run.draws_front = own.shown && own.share > 0.0F && run.directions != 0;
    if (!published && !run.is_scattered() && run.draws_front) run.shape = own.shape;
    run.even_in_picture = run.is_even() && run.is_scattered() && !published && style.evenness == Evenness::picture &&
                          style.tone_rule == ToneRule::share && style.tone_curve == ToneCurve::coverage;
    run.makes_tone = is_surface(layer) || !any_surface;
    run.splats = style.hidden_lines != HiddenLines::show && splats;
    run.draws_silhouettes = published && own.contours && is_surface(layer);
    // If the style gives an overlap, only the layer of the splats paints paper, because one evenly spread layer is as
    // opaque as all layers together. In published drawings all marks paint paper.
    run.paints_paper = style.hidden_lines == HiddenLines::attenuate && (splats || !(style.splat_overlap > 0.0F));
    run.occludes = style.hidden_lines == HiddenLines::hide && splats;
    // The size of a mark's piece of surface is known for the largest layer. For other layers it follows from the ratio
    // of the mark counts.
    const double ratio = static_cast<double>(item.set->largest()) / static_cast<double>(layer.whole_count());
    const double eye_per_object = mean_scale(item.transform) * static_cast<double>(lens.eye_per_world);
    run.discs = {&style, &own, static_cast<float>(item.set->spacing * std::sqrt(ratio) * eye_per_object)};
    if (run.is_even() && !run.is_scattered())
        run.discs.separation = static_cast<float>(layer.report.step * eye_per_object);
    if (style.zoom_reference > 0.0)
        run.discs.zoom_at_one = static_cast<float>(static_cast<double>(lens.eye_per_world) / style.zoom_reference);
    run.discs.largest_splat = lens.diagonal;
    return run;
}

void add_layer(const Run& run, MarkClass mark_class, const float* ink, std::int32_t ink_number,
               drawing::Drawing& drawing) {
    drawing::Layer layer;
    layer.item = run.source;
    layer.layer = run.layer;
    layer.mark_class = mark_class;
    layer.as_strokes = run.shape != Shape::dots && mark_class == MarkClass::front;
    layer.as_hatch = run.shape == Shape::hatch && mark_class == MarkClass::front;
    layer.ink = {ink[0], ink[1], ink[2], ink[3]};
    layer.ink_number = ink_number;
    layer.other_side = run.turned;
    drawing.layers.push_back(layer);
}

// Finds the fields of a run, and adds the drawing's layers of ink for its front marks.
void add_front_layers(Scene& scene, const Item& item, Run& run, drawing::Drawing& drawing) {
    run.first_layer = static_cast<std::uint32_t>(drawing.layers.size());
    add_layer(run, MarkClass::front, run.style->ink, -1, drawing);
    if (item.style.visibility == Visibility::published || !run.draws_front) return;
    run.fields = fields_of(*item.set, run.layer, *run.style, run.source);
    const marks::MarkField* const colors =
        find_field(*item.set, run.layer, run.style->ink_field, "ink_field", marks::FieldKind::colour, run.source);
    if (colors == nullptr) return;
    run.inks = static_cast<std::int32_t>(scene.inks.size());
    scene.inks.add(*run.marks, *colors, item.style.palette, run.style->palette_rule);
    std::int32_t number = 0;
    for (const glm::vec4& ink : item.style.palette) add_layer(run, MarkClass::front, &ink.x, number++, drawing);
    run.layers = static_cast<std::uint32_t>(1 + number);
}

// Adds the runs of the scene's last item, which has the index `number` in the drawing. The runs of the other side of a
// surface have only ink, because the front side already shows where the surface is.
void add_runs(Scene& scene, const Item& item, std::int32_t number, std::int64_t first_of_drawing, bool other_side,
              drawing::Drawing& drawing) {
    const std::int64_t splats = splat_layer(*item.set, item.style);
    const bool any_surface = has_surface(*item.set, item.style);
    for (std::int64_t i = 0; i < item.set->layers.size(); ++i) {
        const marks::Layer& layer = item.set->layers[i];
        if (!takes_part(layer, item.style)) continue;
        Run run = run_of(item, layer, i == splats, any_surface, scene.lens);
        run.turned = other_side;
        if (other_side) run.draws_silhouettes = run.paints_paper = run.occludes = run.splats = false;
        if (other_side && !run.draws_front) continue;
        HRBFNPR_ASSERT(drawing.runs[first_of_drawing + i].count == run.count);
        run.item = static_cast<std::int32_t>(scene.items.size() - 1);
        run.source = number;
        run.layer = static_cast<std::int32_t>(i);
        run.first_id = drawing.runs[first_of_drawing + i].first_id;
        run.first = scene.mark_count();
        add_front_layers(scene, item, run, drawing);
        scene.runs.push_back(run);
        if (item.style.visibility == Visibility::published)
            add_layer(run, MarkClass::silhouette, &item.style.silhouette_ink.x, -1, drawing);
    }
}

// ---- Poses and other sides

// Checks a pose of an item, and copies it to the drawing.
void read_pose(const Item& item, std::int64_t number, std::int64_t pose_number, drawing::Drawing& drawing) {
    const Pose& pose = item.poses[static_cast<std::size_t>(pose_number)];
    const auto refuse = [&](const char* why) {
        fail(Status::invalid_argument, "items[%lld].poses[%lld].layer is %lld, which %s", ll{number}, ll{pose_number},
             ll{pose.layer}, why);
    };
    drawing::Run* const run = std::find_if(drawing.runs.begin(), drawing.runs.end(), [&](const drawing::Run& r) {
        return r.item == number && r.layer == pose.layer;
    });
    if (run == drawing.runs.end()) refuse("is not a layer of the item's point set");
    if (run->posed >= 0) refuse("has a pose already; give one pose for each layer");
    const auto vector = [&](const base::InView& view, std::int64_t i, const char* name) {
        const glm::dvec3 v(view.get(i, 0), view.get(i, 1), view.get(i, 2));
        // For NaN the comparison is false, too.
        if (!(std::abs(v.x) <= farthest && std::abs(v.y) <= farthest && std::abs(v.z) <= farthest))
            fail(Status::invalid_argument,
                 "items[%lld].poses[%lld].%s[%lld] is %g %g %g; numbers must be finite and at most 1e33", ll{number},
                 ll{pose_number}, name, ll{i}, v.x, v.y, v.z);
        return v;
    };
    const auto unit_vector = [&](const base::InView& view, std::int64_t i, const char* name) {
        const glm::dvec3 v = vector(view, i, name);
        const double length = glm::length(v);
        if (!(std::abs(length - 1.0) <= most_off_unit))
            fail(Status::invalid_argument, "items[%lld].poses[%lld].%s[%lld] has the length %g; it must be 1",
                 ll{number}, ll{pose_number}, name, ll{i}, length);
        return v / length;
    };
    const auto add = [](base::Array<float>& array, const glm::dvec3& v) {
        for (int k = 0; k < 3; ++k) array.push_back(static_cast<float>(v[k]));
    };
    run->posed = drawing.posed_position.size() / 3;
    run->poses_directions = !pose.direction.empty();
    for (std::int64_t i = 0; i < run->count; ++i) {
        add(drawing.posed_position, vector(pose.position, i, "position") - item.set->origin);
        add(drawing.posed_normal, unit_vector(pose.normal, i, "normal"));
        add(drawing.posed_direction,
            run->poses_directions ? unit_vector(pose.direction, i, "direction") : glm::dvec3(0.0));
    }
}

// Makes the runs of posed layers refer to the moved marks, and enlarges the bounding balls of items. After this, the
// drawing's arrays of poses must not move.
void pose_runs(Scene& scene, const drawing::Drawing& drawing) {
    for (const drawing::Run& run : drawing.runs) {
        ItemView& view = scene.items[run.item];
        for (std::int64_t i = 0; run.posed >= 0 && i < run.count; ++i) {
            const glm::vec3 place(glm::dvec3(marks::vector_at(drawing.posed_position, run.posed + i)) / view.unit);
            view.radius = std::max(view.radius, scene_tuning.rounding * glm::length(place - view.centre));
        }
    }
    scene.posed.reserve(scene.runs.size());
    std::int64_t number = 0;
    for (Run& run : scene.runs) {
        const drawing::Run& source = *drawing.run_of(run.first_id);
        if (source.posed < 0) continue;
        run.position = drawing.posed_position.data() + 3 * source.posed;
        run.normal = drawing.posed_normal.data() + 3 * source.posed;
        if (source.poses_directions) run.posed_direction = drawing.posed_direction.data() + 3 * source.posed;
        if (number == scene.posed.size()) scene.posed.add(scene.items.memory());
        marks::MarkClusters& moved = scene.posed[number++];
        marks::move_clusters(*run.marks, run.position, run.normal, scene.items[run.item].unit, moved);
        run.clusters = &moved;
    }
}

// Gives the runs of the other sides opposite normals. The marks may have been moved by poses.
void add_turned_runs(Scene& scene) {
    std::int64_t marks = 0;
    for (const Run& run : scene.runs) marks += run.turned ? run.count : 0;
    // Runs point to the elements of this list, so it must not move.
    if (marks > 0) scene.turned.reserve(scene.runs.size());
    scene.turned_normal.resize_for_overwrite(3 * marks);
    float* to = scene.turned_normal.data();
    std::int64_t number = 0;
    for (Run& run : scene.runs) {
        if (!run.turned) continue;
        const float* const normal = std::exchange(run.normal, to);
        to = std::transform(normal, normal + 3 * run.count, to, std::negate<>());
        if (number == scene.turned.size()) scene.turned.add(scene.items.memory());
        marks::MarkClusters& turned = scene.turned[number++];
        marks::turn_clusters(*run.clusters, turned);
        run.clusters = &turned;
        scene.items[run.item].radius = scene.items[run.source].radius;
    }
    HRBFNPR_ASSERT(to == scene.turned_normal.data() + scene.turned_normal.size());
}

} // namespace

void set_up(Scene& scene, std::span<const Item> items, const Camera& given, drawing::Drawing& drawing) {
    check(given);
    const UnitCamera own = unit_camera(given, items);
    const Camera& camera = own.camera;
    scene.lens = make_lens(camera);
    scene.camera = camera;
    scene.items.clear();
    scene.runs.clear();
    scene.inks.clear();
    drawing.clear();
    drawing.window = {given.viewport, given.depth};
    drawing.from_window = glm::inverse(make_optics(camera).window * camera.view);
    drawing.paper = items.empty() ? Style{}.paper : items[0].style.paper;
    std::int32_t number = 0;
    for (const Item& item : items) {
        check_item(items, number);
        check_still(item, given, number);
        scene.items.push_back(view_of(item, own));
        const ItemView& view = scene.items.back();
        drawing.items.push_back({item.set, view.unit, view.to_world, view.normal_to_world});
        const std::int64_t first = drawing.runs.size();
        note_layers(*item.set, number, drawing);
        add_runs(scene, item, number++, first, false, drawing);
    }
    // The other sides come last. They have the same indices in the drawing as their front sides.
    std::int64_t first = 0;
    number = 0;
    for (const Item& item : items) {
        if (item.both_sides) {
            scene.items.push_back(ItemView(scene.items[number]));
            add_runs(scene, item, number, first, true, drawing);
        }
        first += item.set->layers.size();
        ++number;
    }
    std::int64_t posed = 0;
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t p = 0; p < items[i].poses.size(); ++p, ++posed)
            read_pose(items[i], static_cast<std::int64_t>(i), static_cast<std::int64_t>(p), drawing);
    if (posed > 0) pose_runs(scene, drawing);
    add_turned_runs(scene);
    std::int64_t places = 0;
    for (Run& run : scene.runs) run.first_place = std::exchange(places, places + run.places());
}

SingleView see(const Item& item, const Camera& camera) {
    check(camera);
    check_item({&item, 1}, 0);
    const UnitCamera own = unit_camera(camera, {&item, 1});
    return {make_lens(own.camera), view_of(item, own)};
}

glm::vec3 Run::posed_tone_normal_of(std::int64_t mark) const noexcept {
    if (!has_tone_normals() || posed_direction == nullptr) return normal_of(mark);
    const glm::vec3 soft = marks::vector_at(marks->tone_normal, mark);
    const float side = turned ? -1.0F : 1.0F;
    const glm::vec3 n = marks::vector_at(marks->normal, mark);
    const glm::vec3 d = marks::vector_at(marks->direction, mark);
    const glm::vec3 along = vector_of(posed_direction, mark);
    const glm::vec3 now = side * normal_of(mark);
    return side * (glm::dot(soft, n) * now + glm::dot(soft, d) * along +
                   glm::dot(soft, glm::cross(n, d)) * glm::cross(now, along));
}

FieldBounds Run::field_bounds_of(const marks::StrokePiece& piece) const noexcept {
    if (!fields.any()) return {};
    FieldRows rows;
    return fields.effects_on(
        piece.count, [&](std::int64_t i) { return marks->mark_of(piece.first + i); }, rows);
}

void ToneCalls::begin(const ItemView& item, float* out, std::int64_t stride) noexcept {
    HRBFNPR_ASSERT(item.style.tone_function != nullptr && stride > 0);
    places_.clear(); // If the last frame failed, its places may still be in the list.
    positions_.clear();
    normals_.clear();
    item_ = &item;
    out_ = out;
    stride_ = stride;
}

void ToneCalls::add(const glm::vec3& own_position, const glm::vec3& own_normal, std::int64_t place) {
    HRBFNPR_ASSERT(item_ != nullptr && place >= 0);
    const glm::vec3 position(item_->to_world * glm::dvec4(own_position, 1.0));
    const glm::vec3 normal = glm::normalize(item_->normal_to_world * own_normal);
    places_.push_back(place);
    for (int k = 0; k < 3; ++k) {
        positions_.push_back(position[k]);
        normals_.push_back(normal[k]);
    }
    if (places_.size() == marks_a_call) end();
}

void ToneCalls::end() {
    const std::int64_t count = places_.size();
    if (count == 0) return;
    tau_.clear();
    tau_.resize(count);
    const std::int32_t result =
        item_->style.tone_function(item_->style.tone_user, count, positions_.data(), normals_.data(), tau_.data());
    if (result != 0)
        fail(Status::callback, "tone_function returned %d; it must return 0 unless it failed",
             static_cast<int>(result));
    for (std::int64_t i = 0; i < count; ++i) {
        if (std::isnan(tau_[i]))
            fail(Status::callback, "tone_function left NaN in tau[%lld]; it must set every element to a number", ll{i});
        out_[stride_ * places_[i]] = std::clamp(tau_[i], 0.0F, 1.0F);
    }
    begin(*item_, out_, stride_);
}

// ---- Items seen from their own space, and clusters

namespace {

constexpr float infinite_distance = std::numeric_limits<float>::infinity();

[[nodiscard]] glm::vec3 vector(const std::array<float, 3>& a) noexcept { return {a[0], a[1], a[2]}; }

void set_rows(float (&to)[3][3], const glm::mat3& from) noexcept {
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) to[r][c] = from[c][r];
}

ViewTransform view_transform_of(const ItemView& item, const Lens& lens) noexcept {
    ViewTransform view_transform{};
    glm::mat4 to_eye(item.to_eye);
    to_eye[3] = glm::vec4(item.eye_offset, 1.0F);
    const glm::mat4 to_clip(glm::dmat4(lens.window) * glm::dmat4(to_eye));
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            view_transform.clip[r][c] = to_clip[c][r];
            if (r < 3) view_transform.eye[r][c] = to_eye[c][r];
        }
    set_rows(view_transform.normal, item.normal_to_eye);
    for (int k = 0; k < 3; ++k) view_transform.centre[k] = lens.centre[k];
    view_transform.parallel = lens.centre.w == 0.0F;
    view_transform.pixels = lens.pixels;
    return view_transform;
}

// The position of a ball relative to the picture. The distance of the ball from the picture, outside one of its sides,
// is certainly more than `beyond`, in pixels times w. `beyond` is infinite if the ball is outside the range of depths.
struct FrustumSides {
    float beyond = -infinite_distance;
    bool inside = true; // True if the ball is certainly in the picture.
};

[[nodiscard]] FrustumSides frustum_sides_of(const glm::vec4& eye, float radius, const Frustum& frustum) noexcept {
    FrustumSides sides;
    for (std::size_t k = 0; k < frustum.plane.size(); ++k) {
        const float distance = glm::dot(frustum.plane[k], eye);
        const float slack = radius * frustum.norm[k];
        const float outside = -slack - distance;
        sides.beyond = std::max(sides.beyond, k < 4            ? outside
                                              : outside > 0.0F ? infinite_distance
                                                               : -infinite_distance);
        sides.inside = sides.inside && distance > slack;
    }
    return sides;
}

} // namespace

ItemSight sight_of(const ItemView& item, const Lens& lens, const Frustum& frustum) noexcept {
    ItemSight sight{view_transform_of(item, lens)};
    sight.lighting = item.lighting;
    const glm::mat3 square = glm::transpose(item.to_eye) * item.to_eye;
    const float mean = (square[0][0] + square[1][1] + square[2][2]) / 3.0F;
    float largest = 0.0F;
    float off = 0.0F;
    for (int r = 0; r < 3; ++r) {
        largest = std::max(largest, std::abs(square[0][r]) + std::abs(square[1][r]) + std::abs(square[2][r]));
        for (int c = 0; c < 3; ++c) off = std::max(off, std::abs(square[c][r] - (c == r ? mean : 0.0F)));
    }
    sight.scale = std::sqrt(largest);
    const glm::vec4 middle(item.to_eye * item.centre + item.eye_offset, 1.0F);
    sight.inside = frustum_sides_of(middle, item.radius * sight.scale * scene_tuning.rounding, frustum).inside;
    const glm::dmat3 back = glm::inverse(glm::dmat3(item.to_eye));
    const glm::dvec3 centre(lens.centre);
    sight.eye = sight.view_transform.parallel ? glm::vec3(glm::normalize(back * centre))
                                              : glm::vec3(back * (centre - glm::dvec3(item.eye_offset)));
    if (!(off <= scene_tuning.angle_tolerance * mean)) return sight;
    set_rows(sight.view_transform.normal,
             item.normal_to_eye / std::cbrt(std::abs(glm::determinant(item.normal_to_eye))));
    sight.lighting = own_lighting(item.lighting);
    sight.view_transform.rigid = true;
    return sight;
}

Frustum frustum_of(const Lens& lens) noexcept {
    const glm::vec4 x = glm::row(lens.window, 0);
    const glm::vec4 y = glm::row(lens.window, 1);
    const glm::vec4 depth = glm::row(lens.window, 2);
    const glm::vec4 w = glm::row(lens.window, 3);
    const glm::vec4& v = lens.viewport;
    Frustum frustum;
    frustum.plane = {x - v.x * w, (v.x + v.z) * w - x, y - v.y * w, (v.y + v.w) * w - y, depth, w - depth};
    for (std::size_t k = 0; k < frustum.plane.size(); ++k) frustum.norm[k] = glm::length(glm::vec3(frustum.plane[k]));
    frustum.w_norm = glm::length(glm::vec3(w));
    return frustum;
}

ClusterView view_cluster(const marks::Extent& extent, const ItemSight& sight, const Lens& lens,
                         const Frustum& frustum) noexcept {
    HRBFNPR_ASSERT(extent.radius >= 0.0F);
    ClusterView view;
    const glm::vec3 own = vector(extent.centre);
    const ViewTransform& view_transform = sight.view_transform;
    const auto dot_row = [&](const float(&r)[4]) { return r[0] * own.x + r[1] * own.y + r[2] * own.z + r[3]; };
    const glm::vec4 eye(dot_row(view_transform.eye[0]), dot_row(view_transform.eye[1]), dot_row(view_transform.eye[2]),
                        1.0F);
    const float radius = extent.radius * sight.scale * scene_tuning.rounding;
    const float w = dot_row(view_transform.clip[3]);
    const float w_most = w + radius * frustum.w_norm;
    if (w_most > 0.0F) view.pixels_per_unit = lens.pixels / (w > 0.0F ? w : w_most);
    if (!(w - radius * frustum.w_norm > 0.0F)) return view; // Some marks may not be in front of the camera.
    view.nearest = w - radius * frustum.w_norm;
    const FrustumSides sides = sight.inside ? FrustumSides{} : frustum_sides_of(eye, radius, frustum);
    view.beyond = sides.beyond / w_most;
    view.inside = sides.inside;
    if (!view_transform.rigid) return view;
    const glm::vec3 axis = vector(extent.cone.axis);
    const Angle cone{extent.cone.cosine, extent.cone.sine};
    Angle spread = cone;
    glm::vec3 sight_line = sight.eye;
    if (!view_transform.parallel) {
        sight_line = own - sight.eye;
        const float distance = glm::length(sight_line);
        if (!(distance > extent.radius)) return view;
        const float sine = extent.radius / distance;
        spread = sum(cone, {std::sqrt(1.0F - sine * sine), sine});
        sight_line /= distance;
    }
    const Range nu = cosines(glm::dot(axis, sight_line), spread);
    view.nu_min = nu.least;
    view.nu_max = nu.most;
    return view;
}

// Returns whether all marks face away. For a place v relative to the eye, a normal n in the cone has n . v >= |v| cos(a
// + c). Here a is the angle between v and the axis, and c that of the cone. Elsewhere in the ball, n . v is less by at
// most the radius of the ball. The test avoids square roots.
bool faces_away(const marks::Extent& extent, const ItemSight& sight) noexcept {
    HRBFNPR_ASSERT(extent.radius >= 0.0F);
    if (!sight.view_transform.rigid || !(extent.cone.cosine > 0.0F)) return false;
    const glm::vec3 v = sight.view_transform.parallel ? sight.eye : vector(extent.centre) - sight.eye;
    const float radius = sight.view_transform.parallel ? 0.0F : extent.radius;
    const float along = glm::dot(vector(extent.cone.axis), v);
    const float least = along * extent.cone.cosine - radius;
    const float across = glm::dot(v, v) - along * along;
    return along > 0.0F && least > 0.0F &&
           least * least > 1.001F * std::max(across, 0.0F) * extent.cone.sine * extent.cone.sine;
}

float least_tau(const marks::Extent& extent, const ItemSight& sight, const SeenShares& seen) noexcept {
    if (!sight.view_transform.rigid) return 0.0F;
    return least_light(
        sight.lighting,
        {vector(extent.centre), extent.radius, vector(extent.cone.axis), extent.cone.cosine, extent.cone.sine}, seen);
}

float least_tau_of_piece(const marks::StrokePiece& piece, const ItemSight& sight, const SeenShares& seen) noexcept {
    if (!sight.view_transform.rigid) return 0.0F;
    return least_light(
        sight.lighting,
        {vector(piece.centre), piece.radius, vector(piece.tone.axis), piece.tone.cosine, piece.tone.sine}, seen);
}

} // namespace hrbfnpr::frame
