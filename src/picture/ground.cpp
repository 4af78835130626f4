// SPDX-License-Identifier: MIT
#include "picture/ground.h"

#include "base/assert.h"
#include "picture/settings.h"
#include "picture/shade.h"
#include "picture/tuning_ground.h"
#include "picture/tuning_plan.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <optional>
#include <string_view>

namespace hrbfnpr::picture {
namespace {

// ---- The plane

constexpr const char* ground_name = "ground";

// Directions along a plane that are as close to axes of the coordinates as possible.
struct PlaneAxes {
    glm::dvec3 u, v;
};

PlaneAxes axes_along(const glm::dvec3& up) noexcept {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(up[axis]) < std::abs(up[least])) least = axis;
    glm::dvec3 u(0.0);
    u[least] = 1.0;
    u = glm::normalize(u - glm::dot(u, up) * up);
    return {u, glm::cross(up, u)};
}

// A rectangle on a plane, in coordinates along its axes.
struct PlaneBox {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};

    void extend(const glm::dvec2& place) noexcept {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    [[nodiscard]] PlaneBox grown(double by) const noexcept { return {low - by, high + by}; }
};

// Coordinates on a plane.
struct PlaneMap {
    explicit PlaneMap(const GroundPlane& of) noexcept : plane(of), axes(axes_along(of.up)) {}

    [[nodiscard]] glm::dvec2 foot(const glm::dvec3& p) const noexcept {
        return {glm::dot(p, axes.u), glm::dot(p, axes.v)};
    }
    [[nodiscard]] glm::dvec3 place(const glm::dvec2& at) const noexcept {
        return at.x * axes.u + at.y * axes.v + plane.height * plane.up;
    }

    GroundPlane plane;
    PlaneAxes axes;
};

PlaneBox footprint(const PlaneMap& map, std::span<const glm::dvec3> places) noexcept {
    PlaneBox box;
    for (const glm::dvec3& place : places) box.extend(map.foot(place));
    return box;
}

double lowest_along(const glm::dvec3& up, std::span<const glm::dvec3> places) noexcept {
    double lowest = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& place : places) lowest = std::min(lowest, glm::dot(up, place));
    return lowest;
}

double diagonal_of_places(std::span<const glm::dvec3> places) noexcept {
    geometry::Bounds bounds;
    for (const glm::dvec3& place : places) bounds.extend(place);
    return bounds.diagonal();
}

// The function of the plane as a model: the signed distance from it.
struct PlaneFunction {
    base::Memory* memory;
    GroundPlane plane;
};

std::int32_t evaluate_plane(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                            double* hessian) noexcept {
    const GroundPlane& plane = static_cast<const PlaneFunction*>(user)->plane;
    for (std::int64_t i = 0; i < count; ++i) {
        const double* const p = points + 3 * i;
        value[i] = plane.up.x * p[0] + plane.up.y * p[1] + plane.up.z * p[2] - plane.height;
        for (int axis = 0; gradient != nullptr && axis < 3; ++axis) gradient[3 * i + axis] = plane.up[axis];
    }
    if (hessian != nullptr) std::fill_n(hessian, 6 * count, 0.0);
    return 0;
}

void release_plane(void* user) noexcept {
    auto* const function = static_cast<PlaneFunction*>(user);
    function->memory->deallocate(function, sizeof *function);
}

Model model_of_plane(const Call& call, const Ground& ground) {
    base::Memory& memory = call.pool.memory();
    auto* const function = ::new (memory.allocate(sizeof(PlaneFunction))) PlaneFunction{&memory, ground.plane};
    auto desc = defaults<hrbfnpr_custom_desc>(hrbfnpr_custom_desc_init);
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_HAS_HESSIAN | HRBFNPR_CUSTOM_THREAD_SAFE;
    desc.function = evaluate_plane;
    desc.user = function;
    desc.release = release_plane;
    geometry::Bounds bounds;
    const glm::dvec3 half(0.5 * ground_tuning.thickness * ground.diagonal);
    for (const glm::dvec3& corner : ground.corners) {
        bounds.extend(corner - half);
        bounds.extend(corner + half);
    }
    std::copy(&bounds.min.x, &bounds.min.x + 3, desc.bounds_min);
    std::copy(&bounds.max.x, &bounds.max.x + 3, desc.bounds_max);
    try {
        return make<Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_create_custom(&call.context, &desc, made, error);
        });
    } catch (...) {
        release_plane(function);
        throw;
    }
}

// Makes the line set on which borders of shadows lie.
LineSet lines_of_plane(const Call& call, const Ground& ground) {
    auto desc = defaults<hrbfnpr_line_set_desc>(hrbfnpr_line_set_desc_init);
    desc.cell_size = glm::length(ground.corners[2] - ground.corners[0]) / ground_tuning.cells;
    return make<LineSet>([&](hrbfnpr_line_set** made, hrbfnpr_error* error) {
        return hrbfnpr_line_set_create(&call.context, ground.model.get(), &desc, nullptr, made, error);
    });
}

// ---- Lights

// A light in world space: the direction to it, or its place.
struct GroundLamp {
    glm::dvec3 place;
    bool is_place;
    double intensity, shadow, softness;

    [[nodiscard]] glm::dvec3 towards(const glm::dvec3& from) const noexcept {
        return glm::normalize(is_place ? place - from : place);
    }
};

glm::dmat4 view_of_camera(const hrbfnpr_camera& camera) noexcept {
    glm::dmat4 view;
    for (int i = 0; i < 16; ++i) view[i / 4][i % 4] = camera.view[i];
    return view;
}

hrbfnpr_light single_light(const hrbfnpr_style& style) noexcept {
    auto light = defaults<hrbfnpr_light>(hrbfnpr_light_init);
    light.space = style.light_space;
    light.intensity = style.light_intensity;
    light.shadow = style.light_shadow;
    light.softness = style.light_softness;
    std::copy(style.light, style.light + 3, light.place);
    return light;
}

GroundLamp lamp_in_world(const hrbfnpr_light& light, const hrbfnpr_camera& camera) noexcept {
    GroundLamp lamp{{light.place[0], light.place[1], light.place[2]},
                    light.kind == HRBFNPR_LIGHT_KIND_PLACE,
                    static_cast<double>(light.intensity),
                    static_cast<double>(light.shadow),
                    static_cast<double>(light.softness)};
    if (light.space != HRBFNPR_LIGHT_CAMERA) return lamp;
    lamp.place = glm::dvec3(glm::inverse(view_of_camera(camera)) * glm::dvec4(lamp.place, lamp.is_place ? 1.0 : 0.0));
    return lamp;
}

Vector<GroundLamp> lamps_of(const Style& style, const hrbfnpr_camera& camera, Pool& pool) {
    Vector<GroundLamp> lamps(&pool);
    for (const hrbfnpr_light& light : style.lights) lamps.push_back(lamp_in_world(light, camera));
    return lamps;
}

// Returns the place on the plane where the shadow of a place falls. Places below the plane have their foot.
glm::dvec2 shadow_of(const PlaneMap& map, const GroundLamp& lamp, const glm::dvec3& place) noexcept {
    const glm::dvec3 towards = lamp.towards(place);
    const double above = std::max(glm::dot(map.plane.up, place) - map.plane.height, 0.0);
    const double rise = std::max(glm::dot(map.plane.up, towards), ground_tuning.lowest_light);
    return map.foot(place) - above / rise * map.foot(towards);
}

bool may_cast(const GroundLamp& lamp, const PlaneMap& map, const glm::dvec3& middle) noexcept {
    return lamp.shadow > 0.0 && glm::dot(map.plane.up, lamp.towards(middle)) > 0.0;
}

// Calls visit(place on the plane) for the shadow of each place by each light. Shadows end at the box.
template <class Visit>
void for_shadows(const PlaneMap& map, std::span<const GroundLamp> lamps, std::span<const glm::dvec3> places,
                 const PlaneBox& box, Visit&& visit) {
    if (places.empty()) return;
    for (const GroundLamp& lamp : lamps) {
        if (!may_cast(lamp, map, places.front())) continue;
        for (const glm::dvec3& place : places) visit(glm::clamp(shadow_of(map, lamp, place), box.low, box.high));
    }
}

// ---- The style

// Lets the first light cast shadows if none does, and makes the ground transparent.
void light_ground(Style& style) {
    hrbfnpr_style& base = style.base;
    base.tone = HRBFNPR_TONE_LIGHT;
    base.tone_function = nullptr;
    base.tone_rule = HRBFNPR_TONE_RULE_SHARE;
    base.rim_light = base.fill_light = base.occlusion_lights = 0.0F;
    // A ground that is transparent hides nothing.
    base.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
    base.attenuation_front = base.attenuation_back = 0.0;
    if (style.lights.empty()) style.lights.push_back(single_light(base));
    const bool casts = std::any_of(style.lights.begin(), style.lights.end(),
                                   [](const hrbfnpr_light& light) { return light.shadow > 0.0F; });
    if (!casts) {
        style.lights.front().shadow = 1.0F;
        if (!(style.lights.front().softness > 0.0F)) style.lights.front().softness = ground_tuning.softness;
    }
}

// Returns the light of open ground: the least at the corners, as lights at places are less bright far from them.
double open_light(const Ground& ground, const hrbfnpr_camera& camera) noexcept {
    const hrbfnpr_style& base = ground.style.base;
    double sum = 0.0;
    for (const hrbfnpr_light& light : ground.style.lights) {
        const GroundLamp lamp = lamp_in_world(light, camera);
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& corner : ground.corners) {
            const double facing = std::max(glm::dot(lamp.towards(corner), ground.plane.up), 0.0);
            least = std::min(least, std::pow(facing, base.tone_exponent));
        }
        sum += lamp.intensity * least;
    }
    return sum;
}

// Returns the ambient light of open ground.
double open_ambient(const Ground& ground) noexcept {
    const hrbfnpr_style& base = ground.style.base;
    const auto up = glm::normalize(glm::dvec3(base.ambient_up[0], base.ambient_up[1], base.ambient_up[2]));
    const double sky = 0.5 * (1.0 + glm::dot(up, ground.plane.up));
    return sky * static_cast<double>(base.ambient_sky) + (1.0 - sky) * static_cast<double>(base.ambient_ground);
}

// Makes ambient light if the style has none, so that the ground is darker beside the object. Strong ambient light is
// made weaker, because shadows would be pale.
void set_ambient_of_ground(const hrbfnpr_camera& camera, Ground& ground) noexcept {
    hrbfnpr_style& base = ground.style.base;
    const double direct = open_light(ground, camera);
    const double wanted = ground_tuning.ambient * (direct > 0.0 ? direct : 1.0);
    const double given = open_ambient(ground);
    if (!(given > 0.0)) {
        base.ambient_sky = static_cast<float>(wanted);
        for (int axis = 0; axis < 3; ++axis) base.ambient_up[axis] = ground.plane.up[axis];
    } else if (given > wanted) {
        base.ambient_sky *= static_cast<float>(wanted / given);
        base.ambient_ground *= static_cast<float>(wanted / given);
    }
}

// The hatching of a style that draws no marks.
hrbfnpr_layer_style hatching_of_lines(const Style& style, double pen) {
    auto layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    layer.kind = HRBFNPR_LAYER_KIND_HATCH;
    const auto scaled = [&](float length) { return static_cast<float>(static_cast<double>(length) * pen); };
    layer.hatch_spacing = scaled(2.8F);
    layer.hatch_pen = scaled(0.45F);
    layer.hatch_white = scaled(0.68F);
    layer.hatch_taper = scaled(12.0F);
    layer.hatch_shortest = scaled(7.0F);
    const float* const ink = style.lines.empty() ? style.base.silhouette_ink : style.lines.front().ink;
    std::copy(ink, ink + 4, layer.ink);
    return layer;
}

struct GroundLayer {
    hrbfnpr_layer_style style;
    hrbfnpr_layer_desc desc;
};

// Returns the layer that a style has for the ground: a style of layers named "ground".
std::optional<GroundLayer> given_layer(const GroundPlan& plan) {
    for (const hrbfnpr_layer_style& style : plan.style.layers) {
        if (style.name == nullptr || std::string_view(style.name) != ground_name) continue;
        GroundLayer found{style, defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init)};
        const bool is_stipples = style.kind == HRBFNPR_LAYER_KIND_STIPPLES;
        found.desc.kind = is_stipples ? HRBFNPR_LAYER_KIND_STIPPLES : HRBFNPR_LAYER_KIND_HATCH;
        return found;
    }
    return std::nullopt;
}

// Returns the layer of the ground: that which the style has for it, or else the first layer that the picture draws. One
// family of lines takes the range of tones of all families of the picture.
GroundLayer layer_of_ground(const GroundPlan& plan) {
    if (const std::optional<GroundLayer> given = given_layer(plan)) return *given;
    GroundLayer found{hatching_of_lines(plan.style, plan.pen), defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init)};
    found.desc.kind = HRBFNPR_LAYER_KIND_HATCH;
    bool has_any = false;
    double white = 1.0; // the share of the paper between all families of lines
    for (const hrbfnpr_layer_desc& desc : plan.layers) {
        const hrbfnpr_layer_style style = plan.style.style_of(desc.kind, desc.name);
        if (style.shown == 0) continue;
        if (!has_any) {
            found = {style, desc};
            has_any = true;
        }
        if (desc.kind != HRBFNPR_LAYER_KIND_HATCH) continue;
        white *= 1.0 - static_cast<double>(style.hatch_coverage_end);
        found.style.hatch_tone_begin = std::min(found.style.hatch_tone_begin, style.hatch_tone_begin);
        found.style.hatch_tone_end = std::max(found.style.hatch_tone_end, style.hatch_tone_end);
        if (found.desc.kind == HRBFNPR_LAYER_KIND_HATCH)
            found.style.hatch_coverage_end = static_cast<float>(1.0 - white);
        else
            found.style.share = 1.0F; // Lines add to the stipples in the darks of the object, but not of the ground.
    }
    found.style.hatch_fade =
        std::min(found.style.hatch_fade, std::max(found.style.hatch_tone_begin - ground_tuning.first_marks, 0.0F));
    found.style.kind = found.desc.kind;
    found.style.shown = 1;
    found.style.contours = 0;
    if (found.desc.kind == HRBFNPR_LAYER_KIND_HATCH) found.style.shape = HRBFNPR_SHAPE_HATCH;
    return found;
}

// Fields are known on the surfaces of the object, but not on the ground.
void remove_fields(hrbfnpr_layer_style& layer) noexcept {
    layer.density_field = nullptr;
    layer.tone_field = nullptr;
    layer.width_field = nullptr;
    layer.mask_field = nullptr;
    layer.ink_field = nullptr;
}

// ---- Marks

std::int32_t constant_direction(void* user, std::int64_t count, const double*, const double*,
                                double* directions) noexcept {
    const glm::dvec3& along = *static_cast<const glm::dvec3*>(user);
    for (std::int64_t i = 0; i < count; ++i)
        for (int axis = 0; axis < 3; ++axis) directions[3 * i + axis] = along[axis];
    return 0;
}

// The direction from the ground to the eye, which is at infinity if the camera has no perspective.
glm::dvec3 towards_eye(const hrbfnpr_camera& camera, const glm::dvec3& from) noexcept {
    const glm::dmat4 to_world = glm::inverse(view_of_camera(camera));
    const bool is_perspective = camera.projection[11] != 0.0;
    return glm::normalize(is_perspective ? glm::dvec3(to_world[3]) - from : glm::dvec3(to_world[2]));
}

void size_layer(const GroundPlan& plan, const Ground& ground, const GroundLayer& from, hrbfnpr_layer_desc& layer,
                bool for_all_cameras) {
    const glm::dvec3 middle = 0.5 * (ground.corners[0] + ground.corners[2]);
    const double pixels = pixels_per_unit(plan.camera, middle);
    const double facing = std::abs(glm::dot(towards_eye(plan.camera, middle), ground.plane.up));
    const double shortened = for_all_cameras ? 1.0 : std::clamp(facing, ground_tuning.least_foreshortening, 1.0);
    if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) {
        layer.separation = static_cast<double>(from.style.hatch_spacing) / (pixels * shortened);
        layer.step = std::min(0.4 * layer.separation, ground_tuning.step / pixels);
        return;
    }
    const double area = glm::length(ground.corners[1] - ground.corners[0]) *
                        glm::length(ground.corners[3] - ground.corners[0]) * (pixels * pixels) * shortened;
    const auto radius = static_cast<double>(from.style.radius);
    const double wanted = plan_tuning.stipple_coverage * area / (std::numbers::pi * radius * radius);
    layer.budget = static_cast<std::int64_t>(std::clamp(wanted, 1.0, static_cast<double>(plan_tuning.most_marks)));
}

PointSet place_marks_of(const Call& call, const GroundPlan& plan, Ground& ground, bool is_still) {
    const GroundLayer from = layer_of_ground(plan);
    Marks marks(call.pool);
    call.options.changes.apply("marks", marks.base);
    marks.base.distribution = HRBFNPR_DISTRIBUTION_BLUE_NOISE;
    marks.base.seed_source = HRBFNPR_SEED_AUTO;
    marks.base.shared_budget = 0;
    auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    layer.kind = from.desc.kind;
    layer.name = ground_name;
    if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES) {
        layer.tone_begin = std::max(from.desc.tone_begin, ground_tuning.first_marks);
        layer.tone_end = from.desc.tone_end > layer.tone_begin ? from.desc.tone_end : 1.0F;
    } else {
        layer.direction_function = constant_direction;
        layer.direction_user = &ground.along;
    }
    layer.tone_smoothing = 0.0;
    size_layer(plan, ground, from, layer, !is_still);
    call.options.changes.apply("marks.ground", layer);
    marks.layers.push_back(layer);
    StillDrawing still{defaults<hrbfnpr_item>(hrbfnpr_item_init), plan.camera};
    still.item.style = &ground.style_view;
    return generate_marks(call, ground.model, marks, is_still ? &still : nullptr);
}

// Finds the rectangle of the plane that shadows and hidden sky may darken.
void find_dark_part(const Call& call, const GroundPlan& plan, Ground& ground) {
    const PlaneMap map(ground.plane);
    const Vector<GroundLamp> lamps = lamps_of(ground.style, plan.camera, call.pool);
    const PlaneBox foot = footprint(map, plan.surface);
    PlaneBox dark = foot;
    for_shadows(map, lamps, plan.surface, foot.grown(ground_tuning.longest_shadow * ground.diagonal),
                [&](const glm::dvec2& place) { dark.extend(place); });
    double margin = ground_tuning.margin;
    for (const GroundLamp& lamp : lamps) margin = std::max(margin, lamp.softness);
    const hrbfnpr_style& base = ground.style.base;
    if (needs_occlusion(base)) {
        auto shading = defaults<hrbfnpr_shading_desc>(hrbfnpr_shading_desc_init);
        call.options.changes.apply("shading", shading);
        margin = std::max(margin, shading.occlusion_reach);
    }
    dark = dark.grown(margin * ground.diagonal);
    ground.corners = {map.place(dark.low), map.place({dark.high.x, dark.low.y}), map.place(dark.high),
                      map.place({dark.low.x, dark.high.y})};
}

} // namespace

Ground ground_of(const Options& options, const Style& style, const glm::dvec3& up, std::span<const glm::dvec3> places) {
    HRBFNPR_ASSERT(options.wants_ground() && !places.empty());
    Ground ground{Style(style)};
    light_ground(ground.style);
    ground.plane.up = glm::normalize(up);
    ground.plane.height = options.desc.ground == HRBFNPR_PICTURE_GROUND_HEIGHT ? options.desc.ground_height
                                                                               : lowest_along(ground.plane.up, places);
    ground.diagonal = diagonal_of_places(places);
    const PlaneMap map(ground.plane);
    const PlaneBox foot = footprint(map, places).grown(ground_tuning.longest_shadow * ground.diagonal);
    ground.corners = {map.place(foot.low), map.place({foot.high.x, foot.low.y}), map.place(foot.high),
                      map.place({foot.low.x, foot.high.y})};
    return ground;
}

Points framed_shadows(const Ground& ground, const hrbfnpr_camera& camera, std::span<const glm::dvec3> places,
                      Pool& pool) {
    const PlaneMap map(ground.plane);
    const PlaneBox box = footprint(map, places).grown(ground_tuning.framed * ground.diagonal);
    Points framed(&pool);
    for_shadows(map, lamps_of(ground.style, camera, pool), places, box,
                [&](const glm::dvec2& place) { framed.push_back(map.place(place)); });
    return framed;
}

Points rim_of_ground(const Ground& ground, const Points& object, Pool& pool) {
    const PlaneMap map(ground.plane);
    const PlaneBox foot = footprint(map, object);
    const glm::dvec2 middle = 0.5 * (foot.low + foot.high);
    const double radius = 0.5 * glm::length(foot.high - foot.low) + ground_tuning.framed * ground.diagonal;
    Points rim(&pool);
    for (int i = 0; i < ground_tuning.rim; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / ground_tuning.rim;
        rim.push_back(map.place(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle))));
    }
    return rim;
}

bool sees_ground(const hrbfnpr_camera& camera, const GroundPlane& plane) noexcept {
    return glm::dot(towards_eye(camera, plane.height * plane.up), plane.up) > 0.0;
}

void set_ground_light(const hrbfnpr_camera& camera, Ground& ground) {
    hrbfnpr_style& base = ground.style.base;
    const double open = open_light(ground, camera) + open_ambient(ground);
    base.tone_white =
        static_cast<float>(std::clamp(open * (1.0 - ground_tuning.white_share), ground_tuning.least_light, 16.0));
    base.tone_black = std::min(ground.black, ground_tuning.most_black * base.tone_white);
    ground.style_view = ground.style.view();
}

void place_ground(const Call& call, const GroundPlan& plan, Ground& ground) {
    if (!plan.surface.empty()) {
        ground.diagonal = diagonal_of_places(plan.surface);
        if (call.options.desc.ground == HRBFNPR_PICTURE_GROUND_LOWEST)
            ground.plane.height = lowest_along(ground.plane.up, plan.surface) - ground_tuning.sink * ground.diagonal;
    }
    ground.style = Style(plan.style);
    ground.black = plan.style.base.tone_black;
    light_ground(ground.style);
    set_ambient_of_ground(plan.camera, ground);
    find_dark_part(call, plan, ground);
    std::erase_if(ground.style.lines,
                  [](const hrbfnpr_line_style& line) { return line.kind != HRBFNPR_LINE_KIND_SHADOW; });
    ground.style.layers.clear();
    ground.style.layers.push_back(layer_of_ground(plan).style);
    remove_fields(ground.style.layers.front());
    ground.style.layers.front().name = ground.style.keep(ground_name);
    call.options.changes.apply("style.ground", ground.style.layers.front());
    const glm::dvec3 right = glm::dvec3(glm::transpose(view_of_camera(plan.camera))[0]);
    ground.along = glm::normalize(right - glm::dot(right, ground.plane.up) * ground.plane.up);
    ground.model = model_of_plane(call, ground);
    if (!ground.style.lines.empty()) ground.lines = lines_of_plane(call, ground);
    set_ground_light(plan.camera, ground);
    ground.marks = place_marks_of(call, plan, ground, plan.is_still);
}

void complete_ground(const Call& call, const GroundPlan& plan, Ground& ground) {
    if (!ground.whole) ground.whole = place_marks_of(call, plan, ground, false);
}

} // namespace hrbfnpr::picture
