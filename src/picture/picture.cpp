// SPDX-License-Identifier: MIT
// Makes surfaces from sources, marks and lines from surfaces, and drawings from marks and lines.
#include "picture/picture.h"

#include "api/drawing.h"
#include "api/line_set.h"
#include "api/still.h"
#include "base/clock.h"
#include "picture/blank.h"
#include "picture/ends.h"
#include "picture/field_table.h"
#include "picture/lines.h"
#include "picture/make.h"
#include "picture/mesh_surface.h"
#include "picture/plate.h"
#include "picture/points.h"
#include "picture/shade.h"
#include "picture/up.h"
#include "picture/wanted_lines.h"

#include <algorithm>
#include <optional>
#include <utility>

using namespace hrbfnpr;

geometry::Bounds hrbfnpr_picture::bounds() const {
    const picture::Surfaces& all = surfaces();
    if (all.list.empty()) return picture::bounds_of(all.marks);
    geometry::Bounds bounds;
    for (const picture::Surface& surface : all.list) {
        const geometry::Bounds own = picture::bounds_of(surface.model);
        bounds.extend(own.min);
        bounds.extend(own.max);
    }
    return bounds;
}

std::int64_t hrbfnpr_picture::mark_count() const {
    std::int64_t count = 0;
    for (const picture::Part& part : parts) count += picture::mark_count_of(part.marks);
    if (ground) count += picture::mark_count_of(ground->marks);
    return count;
}

bool hrbfnpr_picture::is_still() const noexcept {
    return marks && marks->base.distribution == HRBFNPR_DISTRIBUTION_BLUE_NOISE &&
           style->base.visibility == HRBFNPR_VISIBILITY_DEPTH_LAYERS && !options.has(HRBFNPR_PICTURE_KEEP_MARKS) &&
           options.desc.turn == 0.0 && !picture::has_section(options);
}

namespace hrbfnpr::picture {
namespace {

// ---- From sources to surfaces

glm::dvec3 given_up(const Options& options) noexcept {
    return {options.desc.up[0], options.desc.up[1], options.desc.up[2]};
}

// Returns the up direction of a source that is not a file: from the options, or else from its marks.
glm::dvec3 up_of_marks(const Call& call, const PointSet& marks) {
    if (call.options.has_up()) return given_up(call.options);
    return choose_up(call, nullptr, positions_of(marks, call.pool), normals_of(marks, call.pool));
}

void add_model(const Call& call, Source& source, Surfaces& to, bool is_first) {
    Surface& surface = to.list.emplace_back();
    surface.model = source.model;
    surface.marks = source.marks;
    if (!is_first || call.options.has(HRBFNPR_PICTURE_IS_SOLID)) return;
    to.up = call.options.has_up() ? given_up(call.options) : up_of_marks(call, probe(call, source.model).marks);
}

void add_shape(const Call& call, Shape&& shape, Surfaces& to, bool is_first) {
    leave_out_unusable(call, shape);
    if (shape.is_mesh()) tell_unused_viewpoint(call, shape);
    glm::dvec3 up = to.up;
    if (shape.is_mesh()) {
        for (Surface& surface : fit_mesh(call, std::move(shape), up)) to.list.push_back(std::move(surface));
    } else {
        to.list.push_back(fit_points(call, std::move(shape), up));
    }
    if (is_first) to.up = up;
}

void make_surfaces(hrbfnpr_picture& made, const hrbfnpr_picture_desc& desc) {
    const Call call = made.call();
    Surfaces& to = made.own_surfaces;
    Vector<Source> sources = read_sources(desc, made.pool);
    to.name = sources.front().name;
    for (std::size_t number = 0; number < sources.size(); ++number) {
        Source& source = sources[number];
        const bool is_first = number == 0;
        const std::size_t before = to.list.size();
        to.values.add(std::move(source.values));
        if (source.shape) {
            add_shape(call, std::move(*source.shape), to, is_first);
        } else if (source.model) {
            add_model(call, source, to, is_first);
        } else {
            to.marks = source.marks;
            to.up = up_of_marks(call, source.marks);
            to.places = positions_of(source.marks, made.pool);
        }
        for (std::size_t i = before; i < to.list.size(); ++i) to.list[i].source = number;
    }
}

void probe_surfaces(const Call& call, Surfaces& to) {
    for (const Surface& surface : to.list) {
        to.probes.push_back(probe(call, surface.model));
        const Points& places = to.probes.back().places;
        to.places.insert(to.places.end(), places.begin(), places.end());
    }
}

// ---- Marks and lines

bool is_trimmed(const Model& model) { return trim_info_of(model).is_trimmed != 0; }

// Returns a key with everything on which the lines of a surface depend, except the surface itself. Pictures of the same
// surfaces share their line sets if their keys are equal.
String key_of_lines(const Call& call, const Style& style, const Vector<WantedLine>& wanted) {
    String key(&call.pool);
    key += needs_curvature(style) ? "curved" : "plain";
    for (const WantedLine& line : wanted) {
        key += ';';
        for (const double number : {double(line.kind), double(line.axis), double(line.planes)})
            append_decimals(key += ' ', number);
        for (const double level : line.levels) append_decimals(key += ' ', level);
    }
    for (const Change& change : call.options.changes.list())
        if (std::string_view(change.path).starts_with("line_set."))
            (((key += ';') += change.path) += '=') += change.value;
    return key;
}

StillDrawing still_of(const hrbfnpr_picture& picture, std::size_t part) {
    StillDrawing still{defaults<hrbfnpr_item>(hrbfnpr_item_init), picture.camera};
    still.item.style = &picture.style_view;
    still.item.sides = picture.parts[part].sides;
    return still;
}

// Returns the numbers of the planned drawings of all parts that decide which marks they need.
Vector<double> key_of_still(const hrbfnpr_picture& picture) {
    Vector<double> key(&picture.root().pool);
    for (std::size_t i = 0; i < picture.parts.size(); ++i) {
        const StillDrawing still = still_of(picture, i);
        const api::CheckedStill checked(picture.context().runtime.memory, still.item, still.camera);
        const base::Array<double> own = frame::still_key(picture.context().runtime.memory, checked.still);
        key.insert(key.end(), own.begin(), own.end());
    }
    return key;
}

// Looks for marks that another picture of the same surfaces placed for the same plan and the same key of a still
// picture.
std::optional<Vector<Part>> find_made_marks(const hrbfnpr_picture& picture, const Vector<double>& still_key) {
    const hrbfnpr_picture& root = picture.root();
    const std::scoped_lock lock(root.making);
    for (const MadeParts& made : root.made)
        if (made.marks && made.marks->same_as(*picture.marks) && made.still_key == still_key) return made.parts;
    return std::nullopt;
}

std::optional<Vector<Part>> find_made_lines(const hrbfnpr_picture& picture, const String& lines_key) {
    const hrbfnpr_picture& root = picture.root();
    const std::scoped_lock lock(root.making);
    for (const MadeParts& made : root.made)
        if (made.has_lines && made.lines_key == lines_key) return made.parts;
    return std::nullopt;
}

// The largest number of sets of marks and lines that are kept for reuse by pictures of the same surfaces.
constexpr std::size_t most_made = 24;

void keep_made_parts(const hrbfnpr_picture& picture, MadeParts&& made) {
    const hrbfnpr_picture& root = picture.root();
    const std::scoped_lock lock(root.making);
    if (root.made.size() < most_made) root.made.push_back(std::move(made));
}

double area_of(const Surfaces& surfaces) noexcept {
    double area = 0.0;
    for (const Probe& probe : surfaces.probes) area += probe.area;
    return area;
}

// Makes the hatching of a part follow the directions of its source, if the plan names some.
void set_direction(const hrbfnpr_picture& picture, const Call& call, std::size_t source, Marks& marks) {
    if (marks.direction_field.empty()) return;
    const SourceFields& values = picture.surfaces().values;
    const WantedField wanted = values.find(call, marks.direction_field, FieldUse::direction);
    Field field = values.make_field(call, wanted, source);
    if (!field) return;
    if (const Field painted = field_of_dabs(call, HRBFNPR_DAB_DIRECTION)) {
        const auto held = directions_over(call, field, painted);
        marks.hold(held);
        field = held->field;
    } else {
        marks.hold(std::make_shared<Field>(field));
    }
    for (hrbfnpr_layer_desc& layer : marks.layers)
        if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) layer.direction_field = field.get();
}

// Returns the planned marks of all parts, in the member `marks` of each part. `is_still`: only those that the planned
// camera needs.
Vector<Part> place_marks(const hrbfnpr_picture& picture, const Call& call, bool is_still) {
    const Surfaces& surfaces = picture.surfaces();
    MadeParts made(picture.root().pool);
    if (is_still) made.still_key = key_of_still(picture);
    if (std::optional<Vector<Part>> before = find_made_marks(picture, made.still_key)) return std::move(*before);
    made.marks.emplace(*picture.marks, picture.root().pool);
    const double area = area_of(surfaces);
    for (std::size_t i = 0; i < surfaces.list.size(); ++i) {
        Marks own =
            surfaces.list.size() == 1 ? *picture.marks : share_of(*picture.marks, surfaces.probes[i].area / area);
        set_direction(picture, call, surfaces.list[i].source, own);
        const StillDrawing still = still_of(picture, i);
        Part& part = made.parts.emplace_back();
        part.marks = generate_marks(call, surfaces.list[i].model, own, is_still ? &still : nullptr);
    }
    Vector<Part> parts = made.parts;
    keep_made_parts(picture, std::move(made));
    return parts;
}

// Tells whether the surfaces darken themselves or a ground.
bool casts_shadows(const hrbfnpr_picture& picture) noexcept {
    return picture.ground.has_value() || needs_shading(*picture.style);
}

void trace_lines(hrbfnpr_picture& picture, const Call& call, std::size_t i) {
    const Surface& surface = picture.surfaces().list[i];
    const Style& style = *picture.style;
    const bool is_mesh = surface.shape != nullptr && surface.shape->is_mesh();
    const Vector<WantedLine> wanted = wanted_lines(call, style, is_mesh);
    const Vector<LinesOnce> section = section_lines(call, surface.model, picture.camera);
    picture.parts[i].lines = make_lines(call, surface, style, wanted, section, casts_shadows(picture));
}

// Traces the lines of all parts. Lines of a section are valid for this camera only.
void trace_all_lines(hrbfnpr_picture& picture, const Call& call) {
    const bool is_mesh =
        std::any_of(picture.surfaces().list.begin(), picture.surfaces().list.end(),
                    [](const Surface& surface) { return surface.shape != nullptr && surface.shape->is_mesh(); });
    const bool is_shared = !has_section(call.options);
    const String key = key_of_lines(call, *picture.style, wanted_lines(call, *picture.style, is_mesh));
    const bool is_drawn = picture.style->base.visibility != HRBFNPR_VISIBILITY_PUBLISHED &&
                          (!picture.style->lines.empty() || casts_shadows(picture));
    if (is_shared && is_drawn) {
        if (const std::optional<Vector<Part>> before = find_made_lines(picture, key)) {
            for (std::size_t i = 0; i < picture.parts.size(); ++i) picture.parts[i].lines = (*before)[i].lines;
            return;
        }
    }
    for (std::size_t i = 0; i < picture.parts.size(); ++i) trace_lines(picture, call, i);
    if (!is_shared || !is_drawn) return;
    MadeParts made(picture.root().pool);
    made.lines_key = key;
    made.has_lines = true;
    made.parts = picture.parts;
    keep_made_parts(picture, std::move(made));
}

// ---- The picture

// Resolves the names of fields in the style.
void resolve_fields(hrbfnpr_picture& picture, const Call& call) {
    if (!uses_fields(picture.options, *picture.style)) return;
    const Surfaces& surfaces = picture.surfaces();
    const PointSet& given = surfaces.list.empty() ? surfaces.marks : surfaces.list.front().marks;
    picture.fields.emplace(call, *picture.style, surfaces.values, given);
}

// Shows the style to the renderer and to the planner of stills, with the names that marks know fields by.
void view_style(hrbfnpr_picture& picture) {
    picture.style_view = picture.style->view();
    if (picture.fields) picture.style_view.layers = picture.fields->layers().data();
}

// Gives the marks of parts the values of their fields.
void give_values(const hrbfnpr_picture& picture, const Call& call, Vector<Part>& parts) {
    if (!picture.fields) return;
    const Vector<Surface>& surfaces = picture.surfaces().list;
    Stage stage(call.report, HRBFNPR_STAGE_MARKS);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        PointSet& set = parts[i].marks;
        set = picture.fields->with_fields(call, set, surfaces.empty() ? 0 : surfaces[i].source, stage.operation());
    }
    stage.says("values of fields");
}

// Gives the marks of all parts their fields, and chooses inks for them.
void give_fields(hrbfnpr_picture& picture, const Call& call) {
    if (!picture.fields) return;
    give_values(picture, call, picture.parts);
    Vector<PointSet> marks(&picture.pool);
    for (const Part& part : picture.parts) marks.push_back(part.marks);
    choose_palette(call, picture.fields->layers(), marks, *picture.style);
}

void finish(hrbfnpr_picture& picture) {
    view_style(picture);
    if (picture.marks) picture.marks_view = picture.marks->view();
    picture.renderer = make<Renderer>([&](hrbfnpr_renderer** made, hrbfnpr_error* error) {
        return hrbfnpr_renderer_create(&picture.context(), made, error);
    });
}

hrbfnpr_camera choose_camera(const hrbfnpr_picture& picture) {
    return camera_of_view(picture, picture.view, picture.options.desc.turn != 0.0);
}

// ---- The ground

// Finds where the ground is, before there is a camera. The lights do not depend on the size of the picture.
void plan_ground(hrbfnpr_picture& picture, const Call& call, bool has_end) {
    if (!picture.options.wants_ground()) return;
    const Style style = plan_style(call, any_side, any_side, has_end);
    if (style.base.visibility == HRBFNPR_VISIBILITY_PUBLISHED) {
        call.report.note(HRBFNPR_NOTE_NO_GROUND, {},
                         "no ground is drawn: it needs {visibility=depth-layers}, which finds shadows");
        return;
    }
    const Surfaces& surfaces = picture.surfaces();
    picture.ground.emplace(ground_of(picture.options, style, surfaces.up, surfaces.places));
}

// Lets an object of lines alone hide the ground, as a ground that shows faintly through it looks like stains. The
// caller or the settings may say otherwise.
void hide_ground(hrbfnpr_picture& picture) {
    const Options& options = picture.options;
    if (!picture.ground || options.changes.has("style.hidden_lines") || options.style ||
        options.takes_style_of_settings)
        return;
    Style& style = *picture.style;
    const bool has_marks =
        style.layers.empty() || std::any_of(style.layers.begin(), style.layers.end(),
                                            [](const hrbfnpr_layer_style& layer) { return layer.shown != 0; });
    if (!has_marks && style.base.hidden_lines == HRBFNPR_HIDDEN_LINES_ATTENUATE)
        style.base.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
}

// Returns the vertices of the meshes that cast shadows.
Points casting_places(const hrbfnpr_picture& picture) {
    Points places(&picture.pool);
    for (const Part& part : picture.parts) {
        if (!part.lines) continue;
        const geometry::VecArray& vertices = part.lines.get()->lines.mesh().position;
        for (std::int64_t i = 0; i < vertices.size(); ++i) places.push_back(vertices[i]);
    }
    return places;
}

// Calls place(call, plan, ground) with the plan for the ground's marks.
template <class Place>
void with_ground_plan(hrbfnpr_picture& picture, Place&& place) {
    const Call call = picture.call();
    const Points surface = casting_places(picture);
    const std::span<const hrbfnpr_layer_desc> layers = picture.marks
                                                           ? std::span<const hrbfnpr_layer_desc>(picture.marks->layers)
                                                           : std::span<const hrbfnpr_layer_desc>();
    const double pen = pen_of(call, picture.camera.viewport[2], picture.camera.viewport[3]);
    place(call, GroundPlan{*picture.style, layers, surface, picture.camera, pen, picture.is_still()}, *picture.ground);
}

void make_ground(hrbfnpr_picture& picture, const Call& call) {
    if (!picture.ground) return;
    const char* why = "no ground is drawn: the camera sees it from below";
    if (sees_ground(picture.camera, picture.ground->plane)) {
        try {
            with_ground_plan(picture, place_ground);
            return;
        } catch (const Error& error) {
            if (error.status() != Status::not_converged) throw;
            why = "no ground is drawn: its shadows are outside the picture";
        }
    }
    picture.ground.reset();
    call.report.note(HRBFNPR_NOTE_NO_GROUND, {}, why);
}

// Lets the light of the sky come from above, unless the caller or the settings say from where.
void set_sky(hrbfnpr_picture& picture) {
    const Options& options = picture.options;
    const hrbfnpr_style& style = picture.style->base;
    const bool has_ambient_light = style.ambient_sky > 0.0F || style.ambient_ground > 0.0F;
    if (!has_ambient_light || options.changes.has("style.ambient_up") || options.style ||
        options.takes_style_of_settings)
        return;
    const glm::dvec3 up = glm::normalize(picture.surfaces().up);
    std::copy(&up.x, &up.x + 3, picture.style->base.ambient_up);
}

void plan_point_set(hrbfnpr_picture& picture, const Call& call) {
    const Surfaces& surfaces = picture.surfaces();
    picture.camera = choose_camera(picture);
    const std::string_view lines = picture.options.desc.lines != nullptr ? picture.options.desc.lines : "none";
    if (lines != "none" && !lines.empty())
        call.report.note(HRBFNPR_NOTE_NO_LINES_OF_MARKS, {},
                         "no lines are drawn: they need a model, and this is a point set");
    if (picture.options.wants_ground())
        call.report.note(HRBFNPR_NOTE_NO_GROUND, {}, "no ground is drawn: it needs a model, and this is a point set");
    picture.style.emplace(plan_style(call, picture.camera.viewport[2], picture.camera.viewport[3], false));
    Part& part = picture.parts.emplace_back();
    part.marks = surfaces.marks;
    part.sides = sides_of(call, Model());
    resolve_fields(picture, call);
    give_fields(picture, call);
}

// Tells the caller if borders of shadows are asked for, and there are no shadows.
void note_missing_shadows(const hrbfnpr_picture& picture, const Call& call) {
    if (picture.ground || !draws_shadow_lines(*picture.style) || needs_cast_shadows(*picture.style)) return;
    call.report.note(HRBFNPR_NOTE_NO_SHADOWS, {},
                     "no borders of shadows are drawn: no light casts shadows; give it {shadow=1}");
}

void plan_surfaces(hrbfnpr_picture& picture, const Call& call) {
    const Surfaces& surfaces = picture.surfaces();
    const bool has_end = std::any_of(surfaces.list.begin(), surfaces.list.end(),
                                     [](const Surface& surface) { return is_trimmed(surface.model); });
    if (has_end) look_at_front(call, picture.view, surfaces.list.front().shape.get(), surfaces.probes);
    plan_ground(picture, call, has_end);
    picture.camera = choose_camera(picture);
    const hrbfnpr_camera& camera = picture.camera;
    picture.style.emplace(plan_style(call, camera.viewport[2], camera.viewport[3], has_end));
    resolve_fields(picture, call);
    set_sky(picture);
    hide_ground(picture);
    for (const Surface& surface : surfaces.list) {
        Part& part = picture.parts.emplace_back();
        part.marks = surface.marks;
        part.sides = sides_of(call, surface.model);
    }
    if (!surfaces.list.front().marks) {
        const Model& first = surfaces.list.front().model;
        const double pixels = pixels_per_unit(camera, bounds_of(first).centre());
        picture.marks.emplace(
            plan_marks(call, *picture.style, area_of(surfaces), pixels, model_info_of(first).centres));
        view_style(picture);
        // A palette may be chosen from the marks once they are placed. Inks do not decide which marks a still needs.
        static constexpr float any_ink[4] = {0.0F, 0.0F, 0.0F, 1.0F};
        if (picture.style->palette.empty()) {
            picture.style_view.palette = any_ink;
            picture.style_view.palette_count = 1;
        }
        const Vector<Part> placed = place_marks(picture, call, picture.is_still());
        for (std::size_t i = 0; i < placed.size(); ++i) picture.parts[i].marks = placed[i].marks;
    }
    give_fields(picture, call);
    trace_all_lines(picture, call);
    make_ground(picture, call);
    note_missing_shadows(picture, call);
}

void plan(hrbfnpr_picture& picture) {
    const Call call = picture.call();
    picture.view = view_of(picture.options, picture.surfaces().up);
    if (picture.surfaces().list.empty())
        plan_point_set(picture, call);
    else
        plan_surfaces(picture, call);
    picture.pen = pen_of(call, picture.camera.viewport[2], picture.camera.viewport[3]);
    finish(picture);
}

// Makes a picture. work(picture) completes it; if that fails, the picture is released.
template <class Work>
hrbfnpr_picture* made_by(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc, const hrbfnpr_picture* root,
                         hrbfnpr_operation* operation, Work&& work) {
    const api::OperationUse use(operation);
    const base::Stopwatch watch;
    auto* const picture = api::make_handle<hrbfnpr_picture>(context, desc, root);
    try {
        const Serving serving(picture->report, operation);
        work(*picture);
    } catch (...) {
        api::release_handle(picture);
        throw;
    }
    picture->report.end_planning();
    picture->seconds = watch.seconds();
    return use.finish_with(picture);
}

// Places all marks of a still picture, if that was not done before.
void complete_marks(hrbfnpr_picture& picture) {
    if (!picture.is_still() || picture.parts.front().whole) return;
    Vector<Part> placed = place_marks(picture, picture.call(), false);
    give_values(picture, picture.call(), placed);
    for (std::size_t i = 0; i < placed.size(); ++i) picture.parts[i].whole = placed[i].marks;
    if (picture.ground) with_ground_plan(picture, complete_ground);
}

bool is_planned_camera(const hrbfnpr_picture& picture, const hrbfnpr_camera& camera) noexcept {
    const hrbfnpr_camera& planned = picture.camera;
    return camera.depth_convention == planned.depth_convention &&
           std::equal(camera.view, camera.view + 16, planned.view) &&
           std::equal(camera.projection, camera.projection + 16, planned.projection) &&
           std::equal(camera.viewport, camera.viewport + 4, planned.viewport);
}

// Returns the items of a drawing, without their shadings. `with_all_marks`: whether a still picture is drawn with all
// marks.
Vector<hrbfnpr_item> items_of(hrbfnpr_picture& picture, bool with_all_marks) {
    Vector<hrbfnpr_item> items(&picture.pool);
    for (const Part& part : picture.parts) {
        auto& item = items.emplace_back(defaults<hrbfnpr_item>(hrbfnpr_item_init));
        item.point_set = with_all_marks ? part.whole.get() : part.marks.get();
        item.line_set = part.lines.get();
        item.style = &picture.style_view;
        item.sides = part.sides;
    }
    return items;
}

// Returns the item of the ground, without its shading.
hrbfnpr_item item_of_ground(const Ground& ground, bool with_all_marks) {
    auto item = defaults<hrbfnpr_item>(hrbfnpr_item_init);
    item.point_set = with_all_marks ? ground.whole.get() : ground.marks.get();
    item.style = &ground.style_view;
    item.line_set = ground.lines.get();
    return item;
}

bool draws_ground(const hrbfnpr_picture& picture, const hrbfnpr_camera& camera) {
    return picture.ground && picture.occluders && sees_ground(camera, picture.ground->plane);
}

void shade_items(const hrbfnpr_picture& picture, const Call& call, std::span<const hrbfnpr_item> items,
                 const Style& style, const hrbfnpr_camera& camera, ShadedMarks& shaded) {
    const bool is_current = !shaded.of_part.empty() && (!shadows_follow_camera(style) ||
                                                        std::equal(camera.view, camera.view + 16, shaded.view.begin()));
    if (is_current) return;
    shaded.of_part = make_shadings(call, picture.occluders, items, camera, shaded.of_part);
    std::copy(camera.view, camera.view + 16, shaded.view.begin());
}

// Finds the light that reaches the marks, if the styles need that and it is not known for this camera.
void shade(hrbfnpr_picture& picture, const hrbfnpr_camera& camera, bool with_all_marks) {
    if (picture.parts.empty() || !casts_shadows(picture)) return;
    const Vector<hrbfnpr_item> items = items_of(picture, with_all_marks);
    const Call call = picture.call();
    if (!picture.occluders) picture.occluders = make_occluders(call, items);
    if (!picture.occluders) return;
    if (needs_shading(*picture.style))
        shade_items(picture, call, items, *picture.style, camera,
                    with_all_marks ? picture.shaded_whole : picture.shaded);
    if (!draws_ground(picture, camera)) return;
    Ground& ground = *picture.ground;
    set_ground_light(camera, ground);
    const hrbfnpr_item item = item_of_ground(ground, with_all_marks);
    shade_items(picture, call, {&item, 1}, ground.style, camera,
                with_all_marks ? picture.shaded_whole_ground : picture.shaded_ground);
}

Drawing draw(hrbfnpr_picture& picture, const hrbfnpr_camera& camera, bool with_all_marks,
             hrbfnpr_operation* operation) {
    Vector<hrbfnpr_item> items = items_of(picture, with_all_marks);
    const ShadedMarks& shaded = with_all_marks ? picture.shaded_whole : picture.shaded;
    for (std::size_t i = 0; i < shaded.of_part.size(); ++i) items[i].shading = shaded.of_part[i].get();
    if (draws_ground(picture, camera)) {
        items.push_back(item_of_ground(*picture.ground, with_all_marks));
        items.back().shading = (with_all_marks ? picture.shaded_whole_ground : picture.shaded_ground).of_part[0].get();
    }
    return make<Drawing>([&](hrbfnpr_drawing** made, hrbfnpr_error* error) {
        return hrbfnpr_renderer_draw_with_operation(picture.renderer.get(), items.data(),
                                                    static_cast<std::int64_t>(items.size()), sizeof(hrbfnpr_item),
                                                    &camera, operation, made, error);
    });
}

// Fails because almost nothing of a drawing can be seen; `ink` is what can be seen. The marks of a still picture do not
// tell why, so it is drawn with all marks.
[[noreturn]] void fail_as_blank(hrbfnpr_picture& picture, Drawing drawing, double ink) {
    if (picture.is_still()) {
        complete_marks(picture);
        shade(picture, picture.camera, true);
    }
    Stage stage(picture.report, HRBFNPR_STAGE_FRAME);
    if (picture.is_still()) drawing = draw(picture, picture.camera, true, stage.operation());
    const Blank blank = why_blank(drawing, ink, picture.bounds(), picture.camera, picture.style_view,
                                  picture.options.has(HRBFNPR_PICTURE_FLIP), picture.pool);
    picture.report.fail(HRBFNPR_NOTE_BLANK,
                        {static_cast<double>(blank.shown), static_cast<double>(blank.marks), blank.ink}, blank.text);
}

} // namespace

std::int64_t mark_count_of(const PointSet& marks) {
    if (!marks) return 0;
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    return info.marks;
}

hrbfnpr_picture* create_picture(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc,
                                hrbfnpr_operation* operation) {
    return made_by(context, desc, nullptr, operation, [&](hrbfnpr_picture& picture) {
        make_surfaces(picture, desc);
        if (picture.options.has(HRBFNPR_PICTURE_SURFACE_ONLY)) return;
        probe_surfaces(picture.call(), picture.own_surfaces);
        plan(picture);
    });
}

hrbfnpr_picture* restyle_picture(const hrbfnpr_picture& of, const hrbfnpr_picture_desc& desc,
                                 hrbfnpr_operation* operation) {
    if (desc.source_count != 0)
        fail(Status::invalid_argument,
             "picture_desc.source_count is %lld; a restyled picture keeps its surfaces: give 0",
             static_cast<long long>(desc.source_count));
    if (of.surfaces().probes.empty() && !of.surfaces().marks)
        fail(Status::invalid_argument, "picture was made with HRBFNPR_PICTURE_SURFACE_ONLY; make it without");
    return made_by(of.context(), desc, &of.root(), operation, [](hrbfnpr_picture& picture) { plan(picture); });
}

hrbfnpr_camera camera_of_view(const hrbfnpr_picture& picture, const View& view, bool for_orbit) {
    const Options& options = picture.options;
    const Points& object = picture.surfaces().places;
    const auto camera_that_sees = [&](const Points& places) {
        if (!for_orbit) return camera_for(view, picture.bounds(), places, options.is_find());
        return first_camera(view, picture.bounds(), places, options.desc.turn, options.desc.turn_frames,
                            options.is_find());
    };
    const hrbfnpr_camera camera = camera_that_sees(object);
    if (!picture.ground || view.camera) return camera;
    Points places = framed_shadows(*picture.ground, camera, object, picture.pool);
    places.insert(places.end(), object.begin(), object.end());
    return with_depth_of(camera_that_sees(places), rim_of_ground(*picture.ground, object, picture.pool));
}

void require_planned(const hrbfnpr_picture& picture) {
    if (!picture.style)
        fail(Status::invalid_argument,
             "picture was made with HRBFNPR_PICTURE_SURFACE_ONLY, and has no marks and no camera");
}

hrbfnpr_drawing* draw_picture(hrbfnpr_picture& picture, const hrbfnpr_camera* camera, hrbfnpr_operation* operation) {
    require_planned(picture);
    const api::OperationUse use(operation);
    const Serving serving(picture.report, operation);
    Drawing drawing;
    const bool is_other_camera = camera != nullptr && picture.is_still() && !is_planned_camera(picture, *camera);
    if (is_other_camera) complete_marks(picture);
    shade(picture, camera != nullptr ? *camera : picture.camera, is_other_camera);
    std::optional<double> blank_ink;
    {
        Stage stage(picture.report, HRBFNPR_STAGE_FRAME);
        drawing = draw(picture, camera != nullptr ? *camera : picture.camera, is_other_camera, stage.operation());
        auto info = defaults<hrbfnpr_drawing_info>(hrbfnpr_drawing_info_init);
        call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_get_info(drawing.get(), &info, error); });
        stage.says(formatted(picture.pool, "%lld of %s visible, %s", static_cast<long long>(info.shown),
                             count_of(picture.mark_count(), "mark", picture.pool).c_str(),
                             count_of(info.line_curves, "line", picture.pool).c_str()));
        if (camera == nullptr && !picture.options.has(HRBFNPR_PICTURE_ALLOW_BLANK))
            blank_ink = find_blank(drawing, picture.camera, picture.style_view, picture.pool);
        if (camera == nullptr && !blank_ink) tell_doubts(picture.report, info);
    }
    if (blank_ink) fail_as_blank(picture, std::move(drawing), *blank_ink);
    return use.finish_with(drawing.take());
}

} // namespace hrbfnpr::picture
