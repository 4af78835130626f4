// SPDX-License-Identifier: MIT
// Makes a line set in four steps. First, the view-independent lines are listed; they are found only once, when the line
// set is made. Second, the limit of support is chosen, at which the surface ends. Third, the sharp edges of a mesh are
// joined to polylines; they are used unless the model has its own creases. Fourth, the library finds the lines.
#include "picture/lines.h"

#include "base/assert.h"
#include "base/status.h"
#include "picture/tuning_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hrbfnpr::picture {

hrbfnpr_line_desc LinesOnce::view() const noexcept {
    auto desc = defaults<hrbfnpr_line_desc>(hrbfnpr_line_desc_init);
    desc.kind = kind;
    desc.name = name.c_str();
    desc.lower = lower;
    desc.upper = upper;
    desc.shortest = shortest;
    for (int axis = 0; axis < 3; ++axis) desc.plane[axis] = plane[axis];
    if (!levels.empty())
        desc.levels = {levels.data(), static_cast<std::int64_t>(levels.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
    if (!points.empty()) {
        desc.position = view_of(points);
        desc.line_first = {line_first.data(), static_cast<std::int64_t>(line_first.size()), 0, HRBFNPR_SCALAR_UINT32,
                           1};
    }
    return desc;
}

// ---- Creases of a mesh

namespace {

// The sharp or tangent edges of a mesh. Each edge is stored once, directed from its vertex with the lower index.
struct SharpEdges {
    struct Edge {
        std::int64_t from, to; // The indices in `places` of the two ends of the edge.
    };
    Points places;
    Vector<Edge> edges; // The edges, in the order of the mesh's triangles.
};

double diagonal_of_points(const Points& points) noexcept {
    geometry::Bounds bounds;
    for (const glm::dvec3& point : points) bounds.extend(point);
    return points.empty() ? 0.0 : bounds.diagonal();
}

bool is_finite(const glm::dvec3& p) noexcept { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// The faces whose corners are all finite.
Vector<Triangle> usable_faces(const Shape& shape, Pool& pool) {
    Vector<Triangle> usable(&pool);
    for (const Triangle& face : shape.triangles)
        if (std::all_of(face.begin(), face.end(),
                        [&](std::int64_t i) { return is_finite(shape.points[static_cast<std::size_t>(i)]); }))
            usable.push_back(face);
    return usable;
}

enum class EdgeClass : std::int32_t { sharp = 1, tangent = 2 }; // as hrbfnpr_mesh_edges writes them

// Returns the edges of a class that hrbfnpr_mesh_edges finds. Edges are sharp by the angle alone, or if `angle` is 0 as
// in a fit of the mesh.
SharpEdges edges_of_class(hrbfnpr_context& context, const Shape& shape, EdgeClass wanted, double angle,
                          hrbfnpr_operation* operation, Pool& pool) {
    SharpEdges found{Points(&pool), Vector<SharpEdges::Edge>(&pool)};
    const Vector<Triangle> faces = usable_faces(shape, pool);
    Points points(&pool);
    for (const glm::dvec3& p : shape.points) points.push_back(is_finite(p) ? p : glm::dvec3(0.0));
    auto of_mesh = defaults<hrbfnpr_mesh_desc>(hrbfnpr_mesh_desc_init);
    of_mesh.vertices = view_of(points);
    of_mesh.triangles = view_of(faces);
    of_mesh.parts = HRBFNPR_PARTS_ALL;
    const Mesh mesh = make<Mesh>([&](hrbfnpr_mesh** made, hrbfnpr_error* error) {
        return hrbfnpr_mesh_create(&context, &of_mesh, operation, made, error);
    });
    const auto view = [&](std::uint32_t attribute) {
        hrbfnpr_array array{};
        call([&](hrbfnpr_error* error) { return hrbfnpr_mesh_view(mesh.get(), attribute, &array, error); });
        return array;
    };
    const hrbfnpr_array vertices = view(HRBFNPR_MESH_ATTRIBUTE_VERTEX);
    const hrbfnpr_array triangles = view(HRBFNPR_MESH_ATTRIBUTE_TRIANGLE);
    Vector<std::int32_t> sharp(static_cast<std::size_t>(3 * triangles.count), 0, &pool);
    auto desc = defaults<hrbfnpr_mesh_edges_desc>(hrbfnpr_mesh_edges_desc_init);
    if (angle > 0.0) {
        desc.edges = HRBFNPR_EDGES_SHARP;
        desc.crease_angle = std::clamp(angle, 1.0, 179.0);
        desc.far = diagonal_of_points(shape.points); // With this limit, only the angle decides.
    }
    desc.tangent = wanted == EdgeClass::tangent ? 1 : 0;
    const hrbfnpr_array_out to_sharp{sharp.data(), triangles.count, 0, HRBFNPR_SCALAR_INT32, 3};
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_mesh_edges(mesh.get(), &desc, nullptr, &to_sharp, nullptr, operation, error);
    });
    const auto* const place = static_cast<const glm::dvec3*>(vertices.data);
    const auto* const corner = static_cast<const std::int32_t*>(triangles.data);
    found.places.assign(place, place + vertices.count);
    for (std::size_t side = 0; side < sharp.size(); ++side) {
        const std::int64_t from = corner[side];
        const std::int64_t to = corner[side % 3 == 2 ? side - 2 : side + 1];
        if (sharp[side] == static_cast<std::int32_t>(wanted) && from < to) found.edges.push_back({from, to});
    }
    return found;
}

// For each vertex of a sharp edge, the edges that meet at the vertex. The vertices are numbered from 0, in the order in
// which they first occur in the list of edges.
struct EdgeGraph {
    struct Way {
        std::size_t to;   // The vertex at the other end.
        std::size_t edge; // The index of the edge.
    };
    Vector<std::int64_t> place; // The index of each vertex in SharpEdges::places.
    Vector<std::size_t> first;  // The index in `ways` where the list of each vertex begins, and the size of `ways`.
    Vector<Way> ways;

    [[nodiscard]] std::size_t degree(std::size_t vertex) const noexcept { return first[vertex + 1] - first[vertex]; }
};

EdgeGraph graph_of_edges(const Vector<SharpEdges::Edge>& edges, std::size_t place_count, Pool& pool) {
    EdgeGraph graph{Vector<std::int64_t>(&pool), Vector<std::size_t>(&pool), Vector<EdgeGraph::Way>(&pool)};
    constexpr auto none = static_cast<std::size_t>(-1);
    Vector<std::size_t> vertex_of_place(place_count, none, &pool);
    Vector<std::size_t> degrees(&pool);
    const auto add = [&](std::int64_t place) {
        std::size_t& vertex = vertex_of_place[static_cast<std::size_t>(place)];
        if (vertex == none) {
            vertex = graph.place.size();
            graph.place.push_back(place);
            degrees.push_back(0);
        }
        ++degrees[vertex];
    };
    for (const SharpEdges::Edge& edge : edges) {
        add(edge.from);
        add(edge.to);
    }
    graph.first.reserve(degrees.size() + 1);
    graph.first.push_back(0);
    for (const std::size_t degree : degrees) graph.first.push_back(graph.first.back() + degree);
    graph.ways.resize(graph.first.back());
    Vector<std::size_t> next(graph.first.begin(), graph.first.end(), &pool);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const std::size_t from = vertex_of_place[static_cast<std::size_t>(edges[i].from)];
        const std::size_t to = vertex_of_place[static_cast<std::size_t>(edges[i].to)];
        graph.ways[next[from]++] = {to, i};
        graph.ways[next[to]++] = {from, i};
    }
    return graph;
}

// Joins consecutive edges to polylines. Each edge is used once. Polylines that begin at a vertex of one edge, or of
// more than two edges, come first.
Vector<Polyline> join_edges(const EdgeGraph& graph, std::size_t edge_count, const Points& places, Pool& pool) {
    Vector<bool> is_left(edge_count, true, &pool);
    Vector<Polyline> lines(&pool);
    const std::size_t vertices = graph.place.size();
    const auto place = [&](std::size_t vertex) { return places[static_cast<std::size_t>(graph.place[vertex])]; };
    const auto follow = [&](std::size_t start) {
        for (std::size_t w = graph.first[start]; w < graph.first[start + 1]; ++w) {
            if (!is_left[graph.ways[w].edge]) continue;
            Polyline& line = lines.emplace_back();
            line.push_back(place(start));
            const EdgeGraph::Way* way = &graph.ways[w];
            while (way != nullptr) {
                is_left[way->edge] = false;
                line.push_back(place(way->to));
                const std::size_t vertex = way->to;
                way = nullptr;
                if (graph.degree(vertex) != 2) break;
                for (std::size_t k = graph.first[vertex]; k < graph.first[vertex + 1] && way == nullptr; ++k)
                    if (is_left[graph.ways[k].edge]) way = &graph.ways[k];
            }
        }
    };
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        if (graph.degree(vertex) != 2) follow(vertex);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) follow(vertex);
    return lines;
}

Vector<Polyline> joined_edges(const SharpEdges& sharp, Pool& pool) {
    return join_edges(graph_of_edges(sharp.edges, sharp.places.size(), pool), sharp.edges.size(), sharp.places, pool);
}

// Adds a point in the middle of each piece that is a chord of an arc. A piece is one if the line turns less than
// `arc_turn` at both of its ends, and the pieces beside it have about its length.
Polyline with_middles(const Polyline& line) {
    const std::size_t pieces = line.size() - 1;
    const bool is_closed = pieces > 2 && line.front() == line.back();
    const auto continues = [&](std::size_t piece, std::size_t next) {
        const glm::dvec3 a = line[piece + 1] - line[piece], b = line[next + 1] - line[next];
        const double shorter = std::min(glm::length(a), glm::length(b)),
                     longer = std::max(glm::length(a), glm::length(b));
        return shorter > lines_tuning.arc_pieces * longer &&
               glm::dot(a, b) > std::cos(lines_tuning.arc_turn * (std::numbers::pi / 180.0)) * shorter * longer;
    };
    Polyline made(line.get_allocator());
    for (std::size_t i = 0; i < pieces; ++i) {
        const std::size_t before = i > 0 ? i - 1 : pieces - 1, after = i + 1 < pieces ? i + 1 : 0;
        const bool has_before = (i > 0 || is_closed) && continues(before, i);
        const bool has_after = (i + 1 < pieces || is_closed) && continues(i, after);
        made.push_back(line[i]);
        // The middle of a cubic through four points, or of a parabola through three.
        if (has_before && has_after)
            made.push_back((9.0 * (line[i] + line[i + 1]) - line[before] - line[after + 1]) / 16.0);
        else if (has_before)
            made.push_back((3.0 * line[i + 1] + 6.0 * line[i] - line[before]) / 8.0);
        else if (has_after)
            made.push_back((3.0 * line[i] + 6.0 * line[i + 1] - line[after + 1]) / 8.0);
    }
    made.push_back(line.back());
    return made;
}

double length_of_polyline(const Polyline& line) noexcept {
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::length(line[i] - line[i - 1]);
    return length;
}

} // namespace

Vector<Polyline> mesh_creases(hrbfnpr_context& context, const Shape& shape, double angle, hrbfnpr_operation* operation,
                              Pool& pool) {
    if (!shape.is_mesh()) fail(Status::invalid_argument, "creases need a mesh; this file has no faces");
    return joined_edges(edges_of_class(context, shape, EdgeClass::sharp, angle, operation, pool), pool);
}

Vector<Polyline> mesh_tangents(hrbfnpr_context& context, const Shape& shape, double angle, hrbfnpr_operation* operation,
                               Pool& pool) {
    if (!shape.is_mesh()) fail(Status::invalid_argument, "tangent edges need a mesh; this file has no faces");
    Vector<Polyline> lines =
        joined_edges(edges_of_class(context, shape, EdgeClass::tangent, angle, operation, pool), pool);
    for (Polyline& line : lines)
        for (int round = 0; round < lines_tuning.arc_rounds; ++round) line = with_middles(line);
    return lines;
}

LinesOnce as_lines_once(std::uint32_t kind, const char* name, const Vector<Polyline>& lines, Pool& pool) {
    LinesOnce once(kind, pool);
    once.name = name;
    once.line_first.push_back(0);
    for (const Polyline& line : lines) {
        once.points.insert(once.points.end(), line.begin(), line.end());
        once.line_first.push_back(static_cast<std::uint32_t>(once.points.size()));
    }
    return once;
}

Vector<Polyline> without_facets(Vector<Polyline> creases, double diagonal) {
    double sum = 0.0;
    for (const Polyline& line : creases) sum += length_of_polyline(line);
    if (creases.empty() || sum / static_cast<double>(creases.size()) > lines_tuning.mean_facet * diagonal)
        return creases;
    std::erase_if(creases, [&](const Polyline& line) {
        return !(length_of_polyline(line) > lines_tuning.long_crease * diagonal);
    });
    return creases;
}

// ---- Line sets

namespace {

bool is_found_once(std::uint32_t kind) noexcept {
    return kind == HRBFNPR_LINE_KIND_RIDGE || kind == HRBFNPR_LINE_KIND_VALLEY || kind == HRBFNPR_LINE_KIND_PARABOLIC ||
           kind == HRBFNPR_LINE_KIND_SECTION || kind == HRBFNPR_LINE_KIND_SOFT_EDGE;
}

bool wants_kind(const Vector<WantedLine>& wanted, std::uint32_t kind) noexcept {
    return std::any_of(wanted.begin(), wanted.end(), [&](const WantedLine& one) { return one.kind == kind; });
}

LinesOnce lines_of_wanted(const WantedLine& wanted, const hrbfnpr_model& model, Pool& pool) {
    LinesOnce lines(wanted.kind, pool);
    if (wanted.kind != HRBFNPR_LINE_KIND_SECTION) return lines;
    HRBFNPR_ASSERT(wanted.axis >= 0 && wanted.axis < 3 && wanted.planes >= 1);
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_info(&model, &info, error); });
    const double low = info.bounds_min[wanted.axis];
    const double high = info.bounds_max[wanted.axis];
    const auto planes = static_cast<double>(wanted.planes);
    lines.levels.reserve(static_cast<std::size_t>(wanted.planes));
    for (std::int64_t i = 0; i < wanted.planes; ++i)
        lines.levels.push_back(low + (high - low) * (static_cast<double>(i) + 0.5) / planes);
    lines.plane = glm::dvec3(0.0);
    lines.plane[wanted.axis] = 1.0;
    return lines;
}

LinesOnce lines_of_settings(const hrbfnpr_line_desc& of_file, Pool& pool) {
    LinesOnce lines(of_file.kind, pool);
    if (of_file.name != nullptr) lines.name = of_file.name;
    lines.lower = of_file.lower;
    lines.upper = of_file.upper;
    lines.shortest = of_file.shortest;
    lines.plane = {of_file.plane[0], of_file.plane[1], of_file.plane[2]};
    HRBFNPR_ASSERT(of_file.levels.count == 0 ||
                   (of_file.levels.scalar == HRBFNPR_SCALAR_FLOAT64 && of_file.levels.stride == 0));
    const auto* const levels = static_cast<const double*>(of_file.levels.data);
    lines.levels.assign(levels, levels + of_file.levels.count);
    return lines;
}

// Returns the creases of a mesh as lines named "crease". If the caller names no lines, the short creases between the
// facets of rounded shapes are removed.
LinesOnce edges_of_mesh(const Call& call, const Shape& shape, hrbfnpr_operation* operation) {
    Vector<Polyline> found = mesh_creases(call.context, shape, lines_tuning.crease_angle, operation, call.pool);
    if (call.options.desc.lines == nullptr) found = without_facets(std::move(found), diagonal_of_points(shape.points));
    return as_lines_once(HRBFNPR_LINE_KIND_OWN, "crease", found, call.pool);
}

// Returns the limit of support for a line set: the surface ends where the support is below the limit. The limit is 0 if
// no border lines are wanted; the surface then does not end for lack of samples. The limit is also 0 for a trimmed
// model, which already has a border.
double support_of_lines(const hrbfnpr_model& model, const Vector<WantedLine>& wanted) {
    auto trim = defaults<hrbfnpr_trim_info>(hrbfnpr_trim_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_trim_info(&model, &trim, error); });
    return trim.is_trimmed == 0 && wants_kind(wanted, HRBFNPR_LINE_KIND_BORDER) ? lines_tuning.open_support : 0.0;
}

LineSet create_line_set(const Call& call, const hrbfnpr_model& model, const hrbfnpr_line_set_desc& desc, Stage& stage) {
    return make<LineSet>([&](hrbfnpr_line_set** made, hrbfnpr_error* error) {
        return hrbfnpr_line_set_create(&call.context, &model, &desc, stage.operation(), made, error);
    });
}

hrbfnpr_line_set_info info_of(const LineSet& line_set) {
    auto info = defaults<hrbfnpr_line_set_info>(hrbfnpr_line_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_line_set_get_info(line_set.get(), &info, error); });
    return info;
}

// Creates a line set with the lines of `list` and, if they are wanted, the sharp edges of the surface's mesh. The
// model's own creases replace these edges. A model of several sheets nearly always has creases, and other models hardly
// ever, so the line set is seldom created twice.
LineSet create_with_edges(const Call& call, const Surface& surface, bool wants_edges, hrbfnpr_line_set_desc& desc,
                          Vector<hrbfnpr_line_desc>& list, Stage& stage) {
    LinesOnce edges(HRBFNPR_LINE_KIND_OWN, call.pool);
    const auto add_edges = [&] {
        if (wants_edges) edges = edges_of_mesh(call, *surface.shape, stage.operation());
        if (!edges.points.empty()) list.push_back(edges.view());
        return !edges.points.empty();
    };
    const auto create = [&] {
        desc.lines = list.data();
        desc.line_count = static_cast<std::int64_t>(list.size());
        return create_line_set(call, *surface.model.get(), desc, stage);
    };
    const bool has_sheets = surface.fit && surface.fit->sheets > 1;
    const bool has_edges = !has_sheets && add_edges();
    LineSet made = create();
    const bool has_creases = info_of(made).creases > 0;
    if (has_sheets && !has_creases && add_edges()) return create();
    if (has_edges && has_creases) {
        list.pop_back();
        return create();
    }
    return made;
}

void tell_where_it_ends(const Call& call, const hrbfnpr_line_set_info& info, double support) {
    String text(&call.pool);
    if (info.borders == 0) {
        text = formatted(call.pool, "lines: the surface has no border within support %g", support);
    } else {
        text = formatted(call.pool,
                         "lines: the surface has %s where its samples end (support %g); %.1f%% of it is left out",
                         count_of(info.borders, "border", call.pool).c_str(), support, 100.0 * info.left_out);
    }
    call.report.info(HRBFNPR_NOTE_LINES_END, {static_cast<double>(info.borders), support, info.left_out}, text);
}

void tell_if_thin(const Call& call, const hrbfnpr_line_set_info& info) {
    const auto turned = static_cast<double>(info.turned);
    const auto triangles = static_cast<double>(info.triangles);
    if (!(turned > lines_tuning.turned_share * triangles) && info.missed_seeds == 0) return;
    call.report.warn(
        HRBFNPR_NOTE_LINES_THIN, {turned, triangles, static_cast<double>(info.missed_seeds)},
        "parts of the surface are thinner than the grid that finds lines: some may be missing there",
        {.detail = formatted(call.pool, "%lld of %lld triangles of the grid face the wrong way, and it misses %s.",
                             static_cast<long long>(info.turned), static_cast<long long>(info.triangles),
                             count_of(info.missed_seeds, "sample", call.pool).c_str())});
}

} // namespace

Vector<LinesOnce> lines_found_once(const Call& call, const hrbfnpr_model& model, const Vector<WantedLine>& wanted) {
    Vector<LinesOnce> once(&call.pool);
    const Settings* const settings = call.options.settings.get();
    if (settings != nullptr && settings->has_lines && call.options.desc.lines == nullptr) {
        for (const hrbfnpr_line_desc& lines : settings->lines) once.push_back(lines_of_settings(lines, call.pool));
        return once;
    }
    for (const WantedLine& one : wanted)
        if (is_found_once(one.kind)) once.push_back(lines_of_wanted(one, model, call.pool));
    return once;
}

LineSet make_lines(const Call& call, const Surface& surface, const Style& style, const Vector<WantedLine>& wanted,
                   const Vector<LinesOnce>& more, bool casts) {
    HRBFNPR_ASSERT(surface.model);
    const bool has_lines = !style.lines.empty() || !more.empty();
    if (style.base.visibility == HRBFNPR_VISIBILITY_PUBLISHED || (!has_lines && !casts)) return {};
    const hrbfnpr_model& model = *surface.model.get();
    const bool has_faces = surface.shape != nullptr && surface.shape->is_mesh();
    const bool is_sharp = wants_kind(wanted, HRBFNPR_LINE_KIND_CREASE);

    const Vector<LinesOnce> once = lines_found_once(call, model, wanted);
    Vector<hrbfnpr_line_desc> list(&call.pool);
    for (const LinesOnce& lines : once) list.push_back(lines.view());
    for (const LinesOnce& lines : more) list.push_back(lines.view());

    auto desc = defaults<hrbfnpr_line_set_desc>(hrbfnpr_line_set_desc_init);
    desc.support = support_of_lines(model, wanted);
    desc.mesh = surface.mesh.get();
    call.options.changes.apply("line_set", desc);
    if (needs_curvature(style)) desc.flags |= HRBFNPR_LINE_SET_WITH_CURVATURE;

    LineSet made;
    const bool has_tangents = wants_kind(wanted, HRBFNPR_LINE_KIND_TANGENT_EDGE);
    if (has_tangents && !has_faces) call.report.refuse("tangent edges need a mesh; this file has no faces");
    LinesOnce tangents(HRBFNPR_LINE_KIND_TANGENT_EDGE, call.pool);
    hrbfnpr_line_set_info info{};
    {
        Stage stage(call.report, HRBFNPR_STAGE_LINES);
        if (has_tangents)
            tangents = as_lines_once(HRBFNPR_LINE_KIND_TANGENT_EDGE, "",
                                     mesh_tangents(call.context, *surface.shape, 0.0, stage.operation(), call.pool),
                                     call.pool);
        if (!tangents.points.empty()) list.push_back(tangents.view());
        made = create_with_edges(call, surface, is_sharp && has_faces, desc, list, stage);
        info = info_of(made);
        stage.says(formatted(call.pool, "%s on %lld triangles",
                             count_of(info.lines, "view-independent line", call.pool).c_str(),
                             static_cast<long long>(info.triangles)));
    }
    if (is_sharp && !has_faces && info.creases == 0)
        call.report.refuse("creases need a mesh, or a model with sharp edges; this file has neither");
    if (desc.support > 0.0) tell_where_it_ends(call, info, desc.support);
    tell_if_thin(call, info);
    return made;
}

void tell_doubts(Report& report, const hrbfnpr_drawing_info& info) {
    const auto warn = [&](std::uint32_t code, std::int64_t count, const char* noun, const char* what) {
        if (count > 0) report.warn(code, {static_cast<double>(count)}, count_of(count, noun, report.pool()) += what);
    };
    warn(HRBFNPR_NOTE_LINES_BROKEN, info.line_broken, "line",
         " broken off inside the surface, or missing: more samples there would help");
    warn(HRBFNPR_NOTE_LINES_DOUBTED, info.line_contradictions, "line",
         " possibly drawn where hidden, or left out where visible");
    warn(HRBFNPR_NOTE_LINES_TANGLED, info.line_tangles, "place",
         " where many lines cross: hidden parts of lines may be wrong there");
    tell_proof(report, {info.line_pieces, info.line_agreeing, info.line_undecided, info.line_repaired});
}

String text_of(const LineProof& proof, Pool& pool) {
    return formatted(pool, "%lld of %lld pieces of lines agree with rays; %lld undecided, %lld repaired",
                     static_cast<long long>(proof.agreeing), static_cast<long long>(proof.decided()),
                     static_cast<long long>(proof.undecided), static_cast<long long>(proof.repaired));
}

void tell_proof(Report& report, const LineProof& proof) {
    if (proof.pieces == 0) return;
    const std::initializer_list<double> figures{
        static_cast<double>(proof.decided()), static_cast<double>(proof.agreeing), static_cast<double>(proof.undecided),
        static_cast<double>(proof.repaired)};
    const String text = text_of(proof, report.pool());
    if (proof.agreeing == proof.decided())
        report.note(HRBFNPR_NOTE_LINES_VERIFIED, figures, text);
    else
        report.warn(HRBFNPR_NOTE_LINES_VERIFIED, figures, text);
}

} // namespace hrbfnpr::picture
