// SPDX-License-Identifier: MIT
#include "picture/views.h"

#include "api/descriptor.h"
#include "api/fields.h"
#include "base/assert.h"
#include "base/utf8.h"
#include "picture/cut_faces.h"
#include "picture/ends.h"
#include "picture/faces.h"
#include "picture/lines.h"
#include "picture/look.h"
#include "picture/tuning_views.h"
#include "picture/view_lines.h"
#include "picture/view_marks.h"

#include <cstring>

// ---- The descriptor

namespace hrbfnpr::api {
namespace {

using ViewsDesc = hrbfnpr_views_desc;
constexpr std::uint32_t views_flags =
    HRBFNPR_VIEWS_CENTRE_LINES | HRBFNPR_VIEWS_LABELS | HRBFNPR_VIEWS_UNIT_IS_METRE | HRBFNPR_VIEWS_VERIFY;
constexpr double longest_on_paper = 1e9; // The largest length in mm, and the largest value of other numbers.

constexpr auto views_fields() noexcept {
    using D = ViewsDesc;
    constexpr rule::PositiveUpTo positive{longest_on_paper};
    constexpr rule::Between on_paper{0.01, 1000.0}; // The range of lengths on the paper, in mm.
    return FieldTable{
        field("flags", &D::flags, rule::Flags{views_flags}),
        field("projection", &D::projection, rule::OneOf{HRBFNPR_VIEWS_ANGLE_THIRD, "HRBFNPR_VIEWS_ANGLE_*"}),
        field("hidden", &D::hidden, rule::OneOf{HRBFNPR_VIEWS_HIDDEN_SHOWN, "HRBFNPR_VIEWS_HIDDEN_*"}),
        field("views", &D::views, rule::Any{}),
        field("sections", &D::sections, rule::Any{}),
        field("paper", &D::paper, rule::Any{}),
        field("scale", &D::scale, rule::Any{}),
        field("smooth", &D::smooth, rule::Any{}),
        field("title", &D::title, rule::Any{}),
        field("model", &D::model, rule::Any{}),
        field("unit_mm", &D::unit_mm, rule::Between{0.0, longest_on_paper}),
        field("crease_angle", &D::crease_angle, positive),
        field("line_width", &D::line_width, on_paper),
        field("hatch_spacing", &D::hatch_spacing, on_paper),
        field("spacing", &D::spacing, positive),
        field("page", &D::page, rule::Any{}),
        field("tangent", &D::tangent, rule::OneOf{HRBFNPR_VIEWS_TANGENT_NONE, "HRBFNPR_VIEWS_TANGENT_*"}),
        reserved("reserved", &D::reserved)};
}
static_assert(views_fields().covers<ViewsDesc>());

} // namespace

template <>
hrbfnpr_views_desc defaults() noexcept {
    hrbfnpr_views_desc desc{};
    desc.crease_angle = 30.0;
    desc.line_width = 0.5;
    desc.hatch_spacing = 3.0;
    desc.spacing = 15.0;
    return desc;
}

template <>
hrbfnpr_views_info defaults() noexcept {
    return {};
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_views_desc_init(hrbfnpr_views_desc* desc, uint32_t struct_size) {
    return hrbfnpr::api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_views_info_init(hrbfnpr_views_info* info, uint32_t struct_size) {
    return hrbfnpr::api::init_struct(info, struct_size);
}

} // extern "C"

namespace hrbfnpr::picture {
namespace {

// Returns a text of the descriptor, or `otherwise` if the text is NULL.
std::string_view views_text(const char* text, const char* field, std::string_view otherwise) {
    constexpr std::size_t longest = 65536;
    if (text == nullptr) return otherwise;
    const std::string_view given(text, strnlen(text, longest + 1));
    if (given.size() > longest)
        fail(Status::invalid_argument, "views_desc.%s is longer than %zu bytes", field, longest);
    if (!base::is_utf8(given)) fail(Status::invalid_argument, "views_desc.%s is not UTF-8", field);
    return given;
}

Vector<std::uint32_t> parse_smooth(std::string_view text, const Report& report) {
    struct SmoothKind {
        std::string_view name;
        std::uint32_t kind;
    };
    constexpr std::array known{SmoothKind{"ridges", HRBFNPR_LINE_KIND_RIDGE},
                               SmoothKind{"valleys", HRBFNPR_LINE_KIND_VALLEY},
                               SmoothKind{"suggestive", HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR}};
    Vector<std::uint32_t> kinds(&report.pool());
    if (text == "none" || text.empty()) return kinds;
    for (const std::string_view part : split_text(text, ',', report.pool())) {
        const auto* found =
            std::find_if(known.begin(), known.end(), [&](const SmoothKind& one) { return one.name == part; });
        if (found == known.end())
            report.refuse(formatted(
                report.pool(), "{smooth}: there are no edges '%.*s'; there are ridges, valleys, suggestive and none",
                static_cast<int>(std::min<std::size_t>(part.size(), 80)), part.data()));
        if (std::find(kinds.begin(), kinds.end(), found->kind) == kinds.end()) kinds.push_back(found->kind);
    }
    return kinds;
}

constexpr std::string_view views_of_first_angle = "front,left,top,iso";
constexpr std::string_view views_of_third_angle = "front,right,top,iso";

// ---- The plan of a sheet before its lines are drawn

struct SheetPlan {
    Standing axes;
    glm::dvec3 middle;
    double diagonal;
    Vector<CutPlane> planes;
    Vector<ViewCell> cells;
    SheetLayout layout;
};

void require_cut(const CutPlane& plane, const AskedCut& cut, const Points& places, const Report& report) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec3& place : places) {
        low = std::min(low, glm::dot(place, plane.normal));
        high = std::max(high, glm::dot(place, plane.normal));
    }
    if (low < plane.place && plane.place < high) return;
    // This factor has the sign of the requested normal.
    const double factor = std::copysign(glm::length(cut.normal), glm::dot(plane.normal, cut.normal));
    report.refuse(formatted(report.pool(), "{section}: the plane at %g misses the model, which lies between %g and %g",
                            factor * plane.place, std::min(factor * low, factor * high),
                            std::max(factor * low, factor * high)));
}

SheetPlan plan_sheet(const Call& call, const ViewsOptions& options, const glm::dvec3& up, const Points& places,
                     double unit_mm) {
    Pool& pool = call.pool;
    geometry::Bounds bounds;
    for (const glm::dvec3& place : places) bounds.extend(place);
    if (!(bounds.diagonal() > 0.0)) call.report.refuse("the model is a single point: its views would be empty");
    const Standing axes = standing(up);
    const glm::dvec3 middle = middle_of(places, axes);
    Vector<CutPlane> planes = planes_of(options.cuts, options.views, axes, middle, pool);
    for (std::size_t i = 0; i < planes.size(); ++i) require_cut(planes[i], options.cuts[i], places, call.report);
    Vector<ViewCell> cells = cells_of(views_of(options.views, planes, axes, pool), planes, places, middle,
                                      options.projection, axes.up, options.labels, pool);
    SheetLayout layout =
        choose_layout(cells, options.paper, options.scale, {unit_mm, options.spacing, axes.up}, call.report);
    return {axes, middle, bounds.diagonal(), std::move(planes), std::move(cells), std::move(layout)};
}

// ---- The model

Points centres_of(const Model& model, Pool& pool) {
    hrbfnpr_array view{};
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_model_view(model.get(), HRBFNPR_MODEL_ATTRIBUTE_POSITION, &view, error);
    });
    const auto* const first = static_cast<const double*>(view.data);
    Points centres(&pool);
    for (std::int64_t i = 0; i < view.count; ++i)
        centres.emplace_back(first[3 * i], first[3 * i + 1], first[3 * i + 2]);
    return centres;
}

PointSet stipples_on(const Call& call_, const Model& model, std::int64_t budget, hrbfnpr_operation* operation) {
    auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    layer.budget = budget;
    auto desc = defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
    desc.layers = &layer;
    desc.layer_count = 1;
    return make<PointSet>([&](hrbfnpr_point_set** out, hrbfnpr_error* error) {
        return hrbfnpr_point_set_generate(&call_.context, model.get(), &desc, operation, out, error);
    });
}

// Returns places spread over all models.
Points places_of_models(const Call& call, std::span<const Surface> surfaces) {
    Points places(&call.pool);
    for (const Surface& surface : surfaces) {
        const Points some = probe(call, surface.model).places;
        places.insert(places.end(), some.begin(), some.end());
        if (surface.shape == nullptr || trim_info_of(surface.model).is_trimmed != 0) continue;
        const Points centres = centres_of(surface.model, call.pool);
        places.insert(places.end(), centres.begin(), centres.end());
    }
    return places;
}

// Returns the lines that are found once: lines that are not sharp edges, and the outlines of cuts.
Vector<LinesOnce> lines_once(const ViewsOptions& options, const SheetPlan& plan, Pool& pool) {
    Vector<LinesOnce> once(&pool);
    for (const std::uint32_t kind : options.smooth)
        if (kind != HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR) once.emplace_back(kind, pool);
    for (const CutPlane& plane : plan.planes) {
        LinesOnce& lines = once.emplace_back(std::uint32_t{HRBFNPR_LINE_KIND_SECTION}, pool);
        lines.name = plane.name;
        lines.plane = plane.normal;
        lines.levels.push_back(plane.place);
        lines.shortest = 0.0;
    }
    return once;
}

void trace_lines_of(Solid& solid, const Call& call_, const Surface& surface, const ViewsOptions& options,
                    const SheetPlan& plan) {
    Pool& pool = call_.pool;
    Stage stage(call_.report, HRBFNPR_STAGE_LINES);
    const bool has_mesh = surface.shape != nullptr && surface.shape->is_mesh();
    Vector<LinesOnce> once = lines_once(options, plan, pool);
    if (has_mesh && options.tangent != TangentLines::none) {
        LinesOnce tangents =
            as_lines_once(HRBFNPR_LINE_KIND_TANGENT_EDGE, "",
                          mesh_tangents(call_.context, *surface.shape, 0.0, stage.operation(), pool), pool);
        solid.has_tangents = !tangents.points.empty();
        if (solid.has_tangents) once.push_back(std::move(tangents));
    }
    Vector<hrbfnpr_line_desc> list(&pool);
    for (const LinesOnce& lines : once) list.push_back(lines.view());
    auto desc = defaults<hrbfnpr_line_set_desc>(hrbfnpr_line_set_desc_init);
    desc.lines = list.data();
    desc.line_count = static_cast<std::int64_t>(list.size());
    desc.mesh = surface.mesh.get();
    const bool has_suggestive = std::find(options.smooth.begin(), options.smooth.end(),
                                          HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR) != options.smooth.end();
    if (has_suggestive) desc.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;

    if (has_mesh)
        solid.creases = without_loose_edges(
            mesh_creases(call_.context, *surface.shape, options.crease_angle, stage.operation(), pool), plan.diagonal,
            pool);
    solid.lines = make<LineSet>([&](hrbfnpr_line_set** out, hrbfnpr_error* error) {
        return hrbfnpr_line_set_create(&call_.context, solid.model.get(), &desc, stage.operation(), out, error);
    });
    auto info = defaults<hrbfnpr_line_set_info>(hrbfnpr_line_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_line_set_get_info(solid.lines.get(), &info, error); });
    // The model itself has creases, so the edges of the mesh are not needed.
    if (info.creases > 0) solid.creases.clear();
    stage.says(formatted(pool, "%s of the mesh on %lld triangles",
                         count_of(static_cast<std::int64_t>(solid.creases.size()), "sharp edge", pool).c_str(),
                         static_cast<long long>(info.triangles)));
}

// Prepares a model with all lines that the views need.
Solid solid_of_surface(const Call& call_, const Surface& surface, const ViewsOptions& options, const SheetPlan& plan) {
    Solid solid(call_.pool);
    solid.model = surface.model;
    trace_lines_of(solid, call_, surface, options, plan);
    solid.marks = stipples_on(call_, solid.model, views_tuning.marks, nullptr);
    const hrbfnpr_trim_info trim = trim_info_of(solid.model);
    solid.is_open = trim.is_trimmed != 0 && trim.share > sight_tuning.open;
    solid.is_shell = solid.is_open && trim.share > sight_tuning.shell;
    if (solid.is_open)
        call([&](hrbfnpr_error* error) {
            return hrbfnpr_model_lipschitz(solid.model.get(), &solid.lipschitz, nullptr, error);
        });
    return solid;
}

// Prepares all models of the object.
Solid solid_of(const Call& call_, std::span<const Surface> surfaces, const ViewsOptions& options,
               const SheetPlan& plan) {
    HRBFNPR_ASSERT(!surfaces.empty());
    Solid solid = solid_of_surface(call_, surfaces.front(), options, plan);
    for (const Surface& other : surfaces.subspan(1)) {
        solid.others.push_back(solid_of_surface(call_, other, options, plan));
        solid.has_tangents = solid.has_tangents || solid.others.back().has_tangents;
        solid.is_shell = solid.is_shell && solid.others.back().is_shell;
    }
    solid.is_verified = options.verify;
    solid.middle = plan.middle;
    solid.diagonal = plan.diagonal;
    solid.smooth.assign(options.smooth.begin(), options.smooth.end());
    solid.renderer = make<Renderer>([&](hrbfnpr_renderer** out, hrbfnpr_error* error) {
        return hrbfnpr_renderer_create(&call_.context, out, error);
    });
    return solid;
}

// ---- Symmetry

// Keeps every n-th point, so that about `wanted` points remain.
Points thinned(Points points, std::int64_t wanted, Pool& pool) {
    const std::size_t step = std::max<std::size_t>(1, points.size() / static_cast<std::size_t>(wanted));
    Points some(&pool);
    for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
    return some;
}

// Tells for each of the three planes through the middle whether it is a plane of symmetry of a surface.
std::array<bool, 3> symmetry_of(const Call& call_, const Model& model, const SheetPlan& plan) {
    Pool& pool = call_.pool;
    std::array<bool, 3> found{};
    Points points = centres_of(model, pool);
    // A model without a fit, such as a solid combined from others, has no centres.
    if (points.empty()) points = positions_of(stipples_on(call_, model, views_tuning.mirrored, nullptr), pool);
    points = thinned(std::move(points), views_tuning.mirrored, pool);
    if (points.empty()) return found;
    const std::array normals{plan.axes.right, plan.axes.up, plan.axes.front};
    for (std::size_t plane = 0; plane < normals.size(); ++plane) {
        const glm::dvec3& normal = normals[plane];
        Points mirrored(&pool);
        for (const glm::dvec3& p : points) mirrored.push_back(p - 2.0 * (glm::dot(p - plan.middle, normal) * normal));
        Vector<double> away(mirrored.size(), &pool);
        Points gradients(mirrored.size(), &pool);
        const hrbfnpr_array at = view_of(mirrored);
        const hrbfnpr_array_out value{away.data(), at.count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out gradient = room_in(gradients);
        call([&](hrbfnpr_error* error) {
            return hrbfnpr_model_evaluate(model.get(), &at, &value, &gradient, nullptr, nullptr, error);
        });
        for (std::size_t i = 0; i < away.size(); ++i)
            away[i] = std::abs(away[i]) / std::max(glm::length(gradients[i]), 1e-300);
        found[plane] = percentile(away, views_tuning.symmetric_percent) < views_tuning.symmetric * plan.diagonal;
    }
    return found;
}

// Returns the normals of those planes through the middle that are planes of symmetry of all surfaces.
Vector<glm::dvec3> symmetric_planes(const Call& call_, std::span<const Surface> surfaces, const SheetPlan& plan) {
    std::array<bool, 3> all{true, true, true};
    for (const Surface& surface : surfaces) {
        const std::array<bool, 3> own = symmetry_of(call_, surface.model, plan);
        for (std::size_t plane = 0; plane < all.size(); ++plane) all[plane] = all[plane] && own[plane];
    }
    const std::array normals{plan.axes.right, plan.axes.up, plan.axes.front};
    Vector<glm::dvec3> found(&call_.pool);
    for (std::size_t plane = 0; plane < all.size(); ++plane)
        if (all[plane]) found.push_back(normals[plane]);
    return found;
}

// ---- The sheet

void add_lines(SheetContent& content, SheetKind kind, const Vector<PaperLine>& lines, const PlacedView& placed) {
    Vector<glm::dvec2> moved(lines.get_allocator());
    for (const PaperLine& line : lines) {
        moved.clear();
        for (const glm::dvec2& p : line) moved.push_back(p + placed.centre);
        content.add(kind, moved, placed.view.name);
    }
}

// Returns the outlines of the faces of a cut. Warns of outlines that enclose no face, unless the object is a shell.
Vector<PaperLine> faces_of_cut(const Vector<PaperLine>& outlines, const Solid& solid, const PlacedView& placed,
                               const Call& call) {
    Vector<PaperLine> closed(&call.pool);
    Vector<PaperLine> ended(&call.pool);
    for (const PaperLine& outline : outlines) {
        if (outline.front() != outline.back()) {
            if (length_of_line(outline) > views_tuning.least_outline)
                ended.emplace_back(outline.begin(), outline.end());
        } else if (!solid.is_shell) {
            closed.emplace_back(outline.begin(), outline.end());
        }
    }
    ClosedOutlines walls = close_outlines(ended, views_tuning.wall, call.pool);
    for (PaperLine& outline : walls.closed) closed.push_back(std::move(outline));
    const std::int64_t open = walls.open;
    if (open > 0 && !solid.is_shell)
        call.report.warn(HRBFNPR_NOTE_SECTION_OPEN, {static_cast<double>(open)},
                         formatted(call.pool, "section %s: %s of the cut not closed, so not hatched",
                                   short_name(placed.view.name, call.pool).c_str(),
                                   count_of(open, "outline", call.pool).c_str()),
                         {.detail = "The model is open there, or the plane lies in one of its faces."});
    return closed;
}

void add_hatching(SheetContent& content, const Vector<PaperLine>& outlines, const ViewsOptions& options,
                  const PlacedView& placed, const Call& call) {
    for (const Segment& segment : hatched(outlines, options.hatch_spacing, call.pool))
        content.add(SheetKind::hatching, {segment[0] + placed.centre, segment[1] + placed.centre}, placed.view.name);
}

void mark_view(SheetContent& content, const PlacedView& placed, const ViewCell& cell, const SheetPlan& plan,
               const Vector<glm::dvec3>& symmetric) {
    for (const std::size_t number : cell.cuts) add_cutting_plane(content, placed, plan.planes[number], plan.middle);
    // A plane of symmetry that is also a cutting plane gets no centre line.
    const auto is_cut = [&](const glm::dvec3& normal) {
        return std::any_of(cell.cuts.begin(), cell.cuts.end(), [&](std::size_t number) {
            const CutPlane& plane = plan.planes[number];
            return std::abs(plane.place - glm::dot(plane.normal, plan.middle)) <
                       views_tuning.in_middle * plan.diagonal &&
                   std::abs(glm::dot(normal, plane.normal)) > 1.0 - view_layout_tuning.along;
        });
    };
    for (const glm::dvec3& normal : symmetric)
        if (placed.view.is_edge_on(normal) && !is_cut(normal)) add_centre_line(content, placed, normal);
    if (cell.has_label) add_view_name(content, placed);
}

SheetContent draw_sheet(const Call& call, std::span<const Surface> surfaces, const ViewsOptions& options,
                        const SheetPlan& plan) {
    Pool& pool = call.pool;
    const Solid solid = solid_of(call, surfaces, options, plan);
    Vector<glm::dvec3> symmetric(&pool);
    if (options.centre_lines) {
        symmetric = symmetric_planes(call, surfaces, plan);
        if (symmetric.empty())
            call.report.note(HRBFNPR_NOTE_NO_SYMMETRY, {},
                             "{centre_lines!}: the model has no plane of symmetry through its middle");
    }
    SheetContent content(options.line_width, options.hidden == HiddenLines::shown, pool);
    Stage stage(call.report, HRBFNPR_STAGE_VIEWS);
    hrbfnpr_operation part(call.context); // The calls for a view report no progress. This operation only cancels them.
    part.operation.set_parent(&stage.operation()->operation);
    String names(&pool);
    const double scale = plan.layout.unit_scale;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const ViewCell& cell = plan.cells[i];
        const glm::dvec2& centre = plan.layout.centres[i];
        const PlacedView placed{cell.view, scale, centre, cell.seen(scale).moved(centre),
                                cell.box(scale).moved(centre)};
        const ViewLines lines = lines_of_view(cell.view, plan.planes, solid, scale, &part, pool);
        content.proof.add(lines.proof);
        // Sections show only visible edges [ISO 128-3].
        const bool with_hidden = options.hidden != HiddenLines::none && !cell.view.is_section();
        const ShownLines shown = draw_in_order(lines.curves, with_hidden, pool);
        add_lines(content, SheetKind::outlines, shown.outlines, placed);
        add_lines(content, SheetKind::hidden, shown.hidden, placed);
        add_lines(content, SheetKind::smooth, shown.smooth, placed);
        add_lines(content, SheetKind::tangent,
                  options.tangent == TangentLines::cut_short
                      ? shortened(shown.tangent, views_tuning.tangent_gap * options.line_width, pool)
                      : shown.tangent,
                  placed);
        add_hatching(content, faces_of_cut(lines.outlines, solid, placed, call), options, placed, call);
        mark_view(content, placed, cell, plan, symmetric);
        if (i > 0) names += ", ";
        names += cell.view.name;
        stage.update(static_cast<double>(i + 1) / static_cast<double>(plan.cells.size()));
    }
    stage.says(names);
    return content;
}

// Returns a file name without its extension.
std::string_view stem_of(std::string_view name) noexcept {
    const std::size_t dot = name.rfind('.');
    return dot == std::string_view::npos || dot == 0 || dot + 1 == name.size() ? name : name.substr(0, dot);
}

String upper_case(std::string_view text, Pool& pool) {
    String result(text, &pool);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

void write_sheet(const Call& call_, const SheetContent& content, const SheetPlan& plan, const String& title,
                 const ViewsOptions& options, hrbfnpr_write_fn write, void* user, hrbfnpr_page_info& info) {
    const SheetAnnotations made = annotations_of(content, call_.pool);
    String description = formatted(call_.pool, "Drawn by hrbfnpr %s", hrbfnpr_version_string());
    if (content.proof.pieces > 0) description += "; " + text_of(content.proof, call_.pool);
    hrbfnpr_page_desc page = options.page;
    page.width = plan.layout.page.width;
    page.height = plan.layout.page.height;
    if (page.title == nullptr) page.title = title.c_str();
    if (page.description == nullptr) page.description = description.c_str();
    page.items = nullptr;
    page.item_count = 0;
    page.annotations = made.list.data();
    page.annotation_count = static_cast<std::int64_t>(made.list.size());
    page.annotation_stride = 0;
    page.pens = made.pens.data();
    page.pen_count = static_cast<std::int64_t>(made.pens.size());
    page.pen_stride = 0;
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_page_write(&call_.context, &page, write, user, &info, nullptr, error);
    });
}

} // namespace

ViewsOptions read_views(const hrbfnpr_views_desc& desc, const Report& report) {
    api::views_fields().check("views_desc", desc);
    ViewsOptions options(report.pool());
    const auto has = [&](std::uint32_t flag) { return (desc.flags & flag) != 0; };
    options.projection = static_cast<Projection>(desc.projection);
    options.views =
        parse_views(views_text(desc.views, "views",
                               options.projection == Projection::first ? views_of_first_angle : views_of_third_angle),
                    report);
    options.cuts = parse_sections(views_text(desc.sections, "sections", ""), report);
    options.hidden = static_cast<HiddenLines>(desc.hidden);
    options.tangent = static_cast<TangentLines>(desc.tangent);
    options.centre_lines = has(HRBFNPR_VIEWS_CENTRE_LINES);
    options.labels = has(HRBFNPR_VIEWS_LABELS);
    options.unit_is_metre = has(HRBFNPR_VIEWS_UNIT_IS_METRE);
    options.verify = has(HRBFNPR_VIEWS_VERIFY);
    options.paper = parse_paper(views_text(desc.paper, "paper", "auto"), report);
    options.scale = parse_scale(views_text(desc.scale, "scale", "auto"), report);
    if (desc.unit_mm > 0.0) options.unit_mm = desc.unit_mm;
    options.smooth = parse_smooth(views_text(desc.smooth, "smooth", "none"), report);
    options.crease_angle = desc.crease_angle;
    options.line_width = desc.line_width;
    options.hatch_spacing = desc.hatch_spacing;
    options.spacing = desc.spacing;
    options.title = views_text(desc.title, "title", "");
    options.model = views_text(desc.model, "model", "");
    options.page = api::read_optional_struct(desc.page, "views_desc.page");
    options.page.struct_size = sizeof options.page;
    options.page.struct_size = sizeof options.page;
    if (desc.page == nullptr) options.page.tolerance = views_tuning.tolerance;
    return options;
}

void write_views(const Call& call, std::span<const Surface> surfaces, const glm::dvec3& up, const ViewsOptions& options,
                 hrbfnpr_write_fn write, void* user, hrbfnpr_views_info& info) {
    HRBFNPR_ASSERT(!surfaces.empty() && glm::length(up) > 0.0 && !options.views.empty());
    Pool& pool = call.pool;
    constexpr double metre = 1000.0;
    double unit_mm = options.unit_mm.value_or(1.0);
    if (!options.unit_mm && options.unit_is_metre) {
        unit_mm = metre;
        call.report.note(HRBFNPR_NOTE_UNIT_IS_METRE, {}, "glTF is in metres: a unit is 1000 mm ({unit_mm} changes it)");
    }
    const SheetPlan plan = plan_sheet(call, options, up, places_of_models(call, surfaces), unit_mm);
    SheetContent content = draw_sheet(call, surfaces, options, plan);

    const SheetPage& page = plan.layout.page;
    const String title(options.title.empty() ? stem_of(options.model) : std::string_view(options.title), &pool);
    String page_fact = upper_case(page.name, pool);
    page_fact += ", mm";
    add_frame(content, page);
    add_title_block(content, page, {title, options.model, plan.layout.scale.text, page_fact}, options.projection, pool);
    add_scale_bar(content, page, plan.layout.unit_scale / unit_mm, pool);
    auto written = defaults<hrbfnpr_page_info>(hrbfnpr_page_info_init);
    write_sheet(call, content, plan, title, options, write, user, written);

    tell_proof(call.report, content.proof);
    info = hrbfnpr_views_info{};
    info.pieces = content.proof.pieces;
    info.agreeing = content.proof.agreeing;
    info.undecided = content.proof.undecided;
    info.repaired = content.proof.repaired;
    info.struct_size = sizeof info;
    info.views = static_cast<std::int64_t>(plan.cells.size());
    info.bytes = written.bytes;
    info.width = page.width;
    info.height = page.height;
    info.scale = plan.layout.scale.value;
    info.unit_mm = unit_mm;
    copy_message(info.scale_text, sizeof info.scale_text, plan.layout.scale.text.c_str());
    copy_message(info.paper, sizeof info.paper, page.name.c_str());
}

} // namespace hrbfnpr::picture
