// SPDX-License-Identifier: MIT
#include "frame/scene/shadow_lines.h"

#include "base/assert.h"
#include "features/contours.h"
#include "frame/scene/tuning.h"
#include "geometry/point_grid.h"
#include "geometry/segment.h"
#include "geometry/tangent_frame.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace hrbfnpr::frame {
namespace {

using curves::CubicPiece;
using curves::CurvePoint;

constexpr std::int64_t edges_a_task = 64;
// Newton's method for a place on a surface ends after a step shorter than this, in cells, or after `most_steps` steps.
constexpr double shortest_step = 1e-6;
constexpr int most_steps = 16;

[[nodiscard]] glm::dvec3 transformed(const glm::dmat4& m, const glm::dvec3& place) noexcept {
    return glm::dvec3(m * glm::dvec4(place, 1.0));
}

// ---- The light and the surfaces

// A light in world space: its place (w = 1), or the unit vector towards it (w = 0).
struct Source {
    glm::dvec4 light;

    // Returns the unit vector along the ray of light through a place.
    [[nodiscard]] glm::dvec3 away(const glm::dvec3& place) const noexcept {
        return light.w == 0.0 ? -glm::dvec3(light) : glm::normalize(place - glm::dvec3(light));
    }
    [[nodiscard]] double distance(const glm::dvec3& place) const noexcept {
        return light.w == 0.0 ? std::numeric_limits<double>::infinity() : glm::distance(place, glm::dvec3(light));
    }
};

struct Surface {
    const curves::LineSet* lines;
    glm::dmat4 to_world, from_world;
    double cell; // the side of its mesh's cells, in world units
};

[[nodiscard]] Surface surface_of(const curves::LineSet& lines, const glm::dmat4& to_world) {
    return {&lines, to_world, glm::inverse(to_world), lines.mesh().side * mean_scale(to_world)};
}

// The surfaces that rays of light meet. The item on which shadows fall may be one of the casters.
struct Surroundings {
    const Casters& casters;
    Surface receiver;
    std::int64_t number = -1;      // the receiver's number among the casters, or -1
    std::optional<Casters> single; // the receiver, unless it is one of the casters
    geometry::Bounds bounds;       // the box around the receiver in the world
};

[[nodiscard]] Surroundings surroundings_of(const base::Work& work, const Casters& casters, const ShadedItem& item) {
    Surroundings all{casters, surface_of(*item.lines, item.to_world), -1, std::nullopt, {}};
    const implicit::Implicit* const surface = &item.lines->surface();
    for (std::int64_t i = 0; i < casters.caster.size() && all.number < 0; ++i)
        if (&casters.caster[i].lines->surface() == surface && casters.caster[i].to_world == item.to_world)
            all.number = i;
    if (all.number < 0) {
        const Caster receiver{&item.lines->mesh(), item.to_world, item.lines};
        all.single.emplace(casters_of(work.without_progress(), {&receiver, 1}));
    }
    all.bounds = all.number < 0 ? all.single->bounds[0] : casters.bounds[all.number];
    return all;
}

// Returns the light of a style. If a surface has creases, the light is moved a little to one side, because it is not
// clear on which side of its edges a face lies that the light just grazes.
[[nodiscard]] Source source_of(const LightStyle& style, const ShadedItem& item, const Casters& casters) {
    const light::Lamp lamp = lamp_of(style, item, 1);
    Source source{glm::dvec4(lamp.place, lamp.is_place ? 1.0 : 0.0)};
    const bool sharp = std::any_of(casters.caster.begin(), casters.caster.end(),
                                   [](const Caster& caster) { return caster.lines->creases().count() > 0; });
    if (!sharp) return source;
    geometry::Bounds box;
    for (const geometry::Bounds& its : casters.bounds) {
        box.extend(its.min);
        box.extend(its.max);
    }
    const glm::dvec3 towards = lamp.is_place ? lamp.place - 0.5 * (box.min + box.max) : lamp.place;
    const double distance = glm::length(towards);
    if (!(distance > 0.0)) return source;
    const glm::dvec3 u = geometry::any_perpendicular(towards / distance);
    const glm::dvec3 v = glm::cross(towards / distance, u);
    constexpr double angle = scene_tuning.off_planes_angle;
    const double shift = scene_tuning.off_planes * distance;
    const glm::dvec3 moved = lamp.place + shift * (std::cos(angle) * u + std::sin(angle) * v);
    source.light = glm::dvec4(lamp.is_place ? moved : glm::normalize(moved), source.light.w);
    return source;
}

// Returns false if no shadow of a caster can fall on the receiver. Both are in balls.
[[nodiscard]] bool may_shade(const Source& source, const geometry::Bounds& caster, const geometry::Bounds& receiver) {
    const glm::dvec3 from = 0.5 * (caster.min + caster.max);
    const glm::dvec3 to = 0.5 * (receiver.min + receiver.max);
    const double from_radius = 0.5 * caster.diagonal();
    const double to_radius = 0.5 * receiver.diagonal();
    if (source.light.w == 0.0) {
        const glm::dvec3 way = to - from;
        const double along = -glm::dot(way, glm::dvec3(source.light));
        return along >= -from_radius - to_radius &&
               glm::length(way + along * glm::dvec3(source.light)) <= from_radius + to_radius;
    }
    const glm::dvec3 light(source.light);
    const double near = glm::distance(from, light);
    const double far = glm::distance(to, light);
    if (near <= from_radius || far <= to_radius) return true;
    const double angle = std::acos(std::clamp(glm::dot(from - light, to - light) / (near * far), -1.0, 1.0));
    return near - from_radius <= far + to_radius && angle <= std::asin(from_radius / near) + std::asin(to_radius / far);
}

// ---- Outlines

// The outlines of one caster. Points have world coordinates. The rays of light that touch an outline beside a point
// form a plane there; `gradient` is its unit normal, which points away from the surface.
struct Outlines {
    explicit Outlines(base::Memory& memory) : curves(memory), turn(memory) {}

    curves::Curves curves;
    // For each point: 1 if the surface bends away from the ray, -1 if it bends towards the ray, which is then inside
    // the surface, and 0 for a cusp, where this changes.
    base::Array<std::int8_t> turn;
    std::int64_t first_border = 0; // the number of the first curve that is a border of the surface
};

void add_point(const Surface& surface, const glm::dvec3& place, const glm::dvec3& tangent, const glm::dvec3& normal,
               int turn, Outlines& out) {
    const glm::dmat3 linear(surface.to_world);
    CurvePoint p;
    p.position = transformed(surface.to_world, place);
    p.gradient = glm::normalize(glm::transpose(glm::dmat3(surface.from_world)) * normal);
    p.level_gradient = glm::cross(glm::normalize(linear * tangent), p.gradient);
    p.is_cusp = turn == 0 ? 1 : 0;
    out.curves.point.push_back(p);
    out.turn.push_back(static_cast<std::int8_t>(turn));
}

// The surface bends away from a ray that touches it where v^T H v is positive.
void add_contours(const Surface& surface, const curves::View& view, const curves::Curves& contours, Outlines& out) {
    for (std::int64_t c = 0; c < contours.count(); ++c) {
        for (std::int64_t i = contours.first[c]; i < contours.first[c + 1]; ++i) {
            const CurvePoint& p = contours.point[i];
            const double bend = glm::dot(p.level_gradient, view.sight(p.position));
            add_point(surface, p.position, p.direction(), p.gradient, p.is_cusp != 0 ? 0 : bend > 0.0 ? 1 : -1, out);
        }
        out.curves.end(contours.closed[c] != 0);
    }
}

// Adds creases or borders. The surface, or its lit sheet, is on their left side.
void add_edges(const Surface& surface, const curves::View& view, const curves::SurfaceLines& lines, bool is_border,
               Outlines& out) {
    for (std::int64_t c = 0; c < lines.curves.count(); ++c) {
        for (std::int64_t i = lines.curves.first[c]; i < lines.curves.first[c + 1]; ++i) {
            const CurvePoint& p = lines.curves.point[i];
            const glm::dvec3 tangent = p.direction();
            glm::dvec3 normal = glm::cross(glm::normalize(view.sight(p.position)), glm::normalize(tangent));
            if (is_border && glm::dot(normal, glm::cross(p.gradient, tangent)) > 0.0) normal = -normal;
            if (!(glm::length(normal) > 1e-6)) normal = p.gradient; // The ray runs along the line.
            add_point(surface, p.position, tangent, normal, is_border || lines.strength[i] > 0.0F ? 1 : -1, out);
        }
        out.curves.end(lines.curves.closed[c] != 0);
    }
}

[[nodiscard]] Outlines find_outlines(const base::Work& work, const Surface& surface, const Source& source) {
    const curves::LineSet& lines = *surface.lines;
    const glm::dvec4 eye = surface.from_world * (source.light.w == 0.0 ? -source.light : source.light);
    const curves::View view{curves::eye_for(lines, eye.w == 0.0 ? glm::normalize(eye) : eye), glm::dmat4(1.0)};
    base::List<curves::Curves> contours(work.memory);
    const auto prepare = [&](std::int64_t) { contours.add(curves::Curves(work.memory)); };
    curves::trace_parts(work, lines, prepare, [&](const base::Work& with, std::int64_t p) {
        const curves::SmoothPart part{lines, p};
        const curves::ContourLevel level(part.surface(), view);
        curves::TraceReport report;
        std::int64_t evaluations = 0;
        const curves::Curves traced = curves::trace(with, level, part.mesh(), {}, report);
        contours[p] = curves::with_cusps(with, level, view, traced, evaluations);
    });
    Outlines out(work.memory);
    for (const curves::Curves& some : contours) add_contours(surface, view, some, out);
    if (lines.creases().count() > 0)
        add_edges(surface, view, curves::parts_in_view(work, *lines.surface().sheets(), lines.creases(), view).folds,
                  false, out);
    out.first_border = out.curves.count();
    add_edges(surface, view, lines.border(), true, out);
    return out;
}

// ---- Sections

// A place on an outline.
struct Edge {
    double at = 0.0;                                // how many points of the outline's curve are before the place
    glm::dvec3 place{0.0}, along{0.0}, normal{0.0}; // in the world; unit vectors, as in Outlines
    bool is_cusp = false;
    bool lit = false;   // whether the light sees the place
    bool falls = false; // whether its shadow falls on the receiver, from the outside
    // Where the shadow falls, and the receiver's unit normal there, in the coordinates of the receiver.
    glm::dvec3 shadow{0.0}, up{0.0};
};

// Parts of the outlines beside which the surface bends away from the rays.
struct Sections : curves::Chains<Edge> {
    explicit Sections(base::Memory& memory) : Chains(memory), curve(memory) {}

    base::Array<std::int64_t> curve; // for each section: the curve of the outlines
    std::int64_t first_border = 0;   // as in Outlines
};

[[nodiscard]] Edge edge_at(const Outlines& outlines, std::int64_t curve, double at) {
    const curves::Curves& curves = outlines.curves;
    const std::int64_t size = curves.size_of(curve);
    const auto before = static_cast<std::int64_t>(at);
    const double share = at - static_cast<double>(before);
    const CurvePoint& a = curves.point[curves.first[curve] + before % size];
    Edge edge;
    edge.at = at;
    if (share == 0.0) {
        edge.place = a.position;
        edge.along = a.direction();
        edge.normal = a.gradient;
        edge.is_cusp = a.is_cusp != 0;
        return edge;
    }
    const CurvePoint& b = curves.point[curves.first[curve] + (before + 1) % size];
    const CubicPiece piece(a, b);
    edge.place = piece.at(share);
    edge.along = glm::normalize(piece.derivative(share));
    edge.normal = glm::normalize((1.0 - share) * a.gradient + share * b.gradient);
    return edge;
}

[[nodiscard]] Sections sections_of(const Outlines& outlines) {
    const curves::Curves& curves = outlines.curves;
    Sections sections(outlines.turn.memory());
    sections.first_border = outlines.first_border;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::int64_t size = curves.size_of(c);
        const std::int8_t* const turn = outlines.turn.data() + curves.first[c];
        const auto joined = [&](std::int64_t i) {
            const int a = turn[i % size];
            const int b = turn[(i + 1) % size];
            return a + b > 0 && a >= 0 && b >= 0;
        };
        curves::for_joined(size, curves.closed[c] != 0, joined, [&](std::int64_t begin, std::int64_t end, bool whole) {
            if (end - begin < 2) return;
            for (std::int64_t i = begin; i < end; ++i)
                sections.point.push_back(edge_at(outlines, c, static_cast<double>(i)));
            sections.end(whole);
            sections.curve.push_back(c);
        });
    }
    return sections;
}

// ---- Rays of light

// A place where a ray meets f = 0.
struct Root {
    double t;          // in world units along the ray
    double slope;      // f increases along the ray if this is above 0
    glm::dvec3 place;  // in the coordinates of the surface
    glm::dvec3 normal; // the unit normal there
};

// Moves along a ray from t towards a root of f by Newton's method. Returns no value if it does not reach one nearby.
// Roots at the beginning of the ray do not count, because rays touch the surface there.
[[nodiscard]] std::optional<Root> find_root(const Surface& surface, const glm::dvec3& origin, const glm::dvec3& way,
                                            double t) {
    const glm::dvec3 from = transformed(surface.from_world, origin);
    const glm::dvec3 step = glm::dmat3(surface.from_world) * way;
    const double start = t;
    for (int i = 0; i < most_steps; ++i) {
        const glm::dvec3 place = from + t * step;
        double value = 0.0;
        glm::dvec3 gradient(0.0);
        surface.lines->surface().evaluate({&place.x, &place.y, &place.z, 1},
                                          {&value, {&gradient.x, &gradient.y, &gradient.z}, {}});
        const double slope = glm::dot(gradient, step);
        const double change = std::clamp(-value / slope, -surface.cell, surface.cell);
        if (!std::isfinite(change)) return std::nullopt;
        if (std::abs(change) < shortest_step * surface.cell) {
            if (!(t > scene_tuning.shadow_start * surface.cell)) return std::nullopt;
            return Root{t, slope, place, glm::normalize(gradient)};
        }
        t += change;
        if (!(std::abs(t - start) < scene_tuning.shadow_near * surface.cell)) return std::nullopt;
    }
    return std::nullopt;
}

[[nodiscard]] std::int64_t caster_of(const Casters& casters, std::int64_t face) noexcept {
    const std::int64_t* const after = std::upper_bound(casters.first_face.begin(), casters.first_face.end(), face);
    return after - casters.first_face.begin() - 1;
}

// A ray of light that touches an outline. It begins a little beside the outline, so that it does not meet the mesh of
// its own surface.
struct TouchingRay {
    const Surface& surface; // the surface of the outline
    std::int64_t number;    // its number among the casters
    glm::dvec3 origin, beside, way;
    glm::dvec3 normal; // Edge::normal
};

// Finds the first place near the outline where the ray enters its own surface. The exact surface is evaluated at places
// along the ray, because the ray runs along the mesh there. Returns no value if all of them are outside.
[[nodiscard]] std::optional<Root> find_near_root(const TouchingRay& ray) {
    const Surface& surface = ray.surface;
    const glm::dvec3 from = transformed(surface.from_world, ray.origin);
    const glm::dvec3 step = glm::dmat3(surface.from_world) * ray.way;
    const double length = scene_tuning.shadow_near * surface.cell / scene_tuning.near_places;
    std::array<std::array<double, scene_tuning.near_places>, 7> numbers{};
    auto& [x, y, z, value, gx, gy, gz] = numbers;
    for (std::size_t k = 0; k < value.size(); ++k) {
        const glm::dvec3 place = from + (static_cast<double>(k) + 1.0) * length * step;
        x[k] = place.x;
        y[k] = place.y;
        z[k] = place.z;
    }
    surface.lines->surface().evaluate({x.data(), y.data(), z.data(), scene_tuning.near_places},
                                      {value.data(), {gx.data(), gy.data(), gz.data()}, {}});
    const double least = scene_tuning.least_depth * surface.lines->mesh().side;
    for (std::size_t k = 0; k < value.size(); ++k) {
        if (!(value[k] < -least * glm::length(glm::dvec3(gx[k], gy[k], gz[k])))) continue;
        const double t = (static_cast<double>(k) + 1.0) * length;
        if (const std::optional<Root> root = find_root(surface, ray.origin, ray.way, t); root) return root;
        return Root{0.0, -1.0, from, glm::normalize(glm::transpose(glm::dmat3(surface.to_world)) * ray.normal)};
    }
    return std::nullopt;
}

// The first surface that a ray meets.
struct Meeting {
    std::int64_t number = -2; // the surface's number, or -2 for none
    double t = 0.0;
    std::optional<Root> near; // the exact place, if the ray meets its own surface near the outline
};

// `also` is a surface apart from the casters, or null. Its number is -1. With `closely`, the ray's own surface
// near the outline is examined even if the ray does not meet its mesh. Near a cusp a ray enters the surface at a small
// angle.
[[nodiscard]] Meeting first_meeting(const Casters& casters, const Casters* also, const TouchingRay& ray, double end,
                                    bool closely) {
    double from = 0.0;
    std::optional<Root> near;
    if (closely) near = find_near_root(ray);
    if (near) end = std::min(end, near->t);
    bool is_clear = closely; // whether the ray's own surface near the outline was examined
    while (true) {
        const geometry::Bvh::Hit hit = casters.tree.first_hit(ray.beside, ray.way, from, end);
        Meeting met;
        if (hit.face >= 0) met = {caster_of(casters, hit.face), hit.t, std::nullopt};
        if (also != nullptr)
            if (const geometry::Bvh::Hit other = also->tree.first_hit(ray.beside, ray.way, from, std::min(end, hit.t));
                other.face >= 0)
                met = {-1, other.t, std::nullopt};
        if (near && (met.number == -2 || met.number == ray.number)) return {ray.number, near->t, near};
        if (met.number != ray.number || met.t > scene_tuning.shadow_near * ray.surface.cell) return met;
        if (!is_clear) met.near = find_near_root(ray);
        if (met.near) return met;
        is_clear = true;
        from = met.t + scene_tuning.shadow_start * ray.surface.cell;
    }
}

[[nodiscard]] bool sees_light(const Casters& casters, const TouchingRay& ray, double end) {
    return first_meeting(casters, nullptr, ray, end, false).number == -2;
}

// Finds the place where the shadow falls.
void find_fall(const Surroundings& all, const TouchingRay& ray, Edge& edge) {
    const Meeting met = first_meeting(all.casters, all.single ? &*all.single : nullptr, ray,
                                      std::numeric_limits<double>::infinity(), true);
    if (met.number != all.number) return;
    const std::optional<Root> root = met.near ? met.near : find_root(all.receiver, ray.origin, ray.way, met.t);
    if (!root || !(root->slope < 0.0)) return;
    edge.falls = true;
    edge.shadow = root->place;
    edge.up = root->normal;
}

// Finds out about light and shadow at places of outlines.
void trace_rays(const base::Work& work, const Surroundings& all, const Source& source, const Surface& surface,
                std::int64_t number, std::span<Edge> edges) {
    const base::Work threads =
        surface.lines->surface().threads(all.receiver.lines->surface().threads(work.without_progress()));
    threads.for_chunks(
        static_cast<std::int64_t>(edges.size()), edges_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                Edge& edge = edges[static_cast<std::size_t>(i)];
                if (edge.is_cusp) continue;
                const glm::dvec3 away = source.away(edge.place);
                const glm::dvec3 beside = edge.place + scene_tuning.shadow_offset * surface.cell * edge.normal;
                edge.lit = sees_light(all.casters, {surface, number, edge.place, beside, -away, edge.normal},
                                      source.distance(beside));
                if (edge.lit) find_fall(all, {surface, number, edge.place, beside, away, edge.normal}, edge);
            }
        });
}

// ---- Shadows along sections

// Returns the direction of the shadow's border, along the section or against it. The planes of light and the plane that
// touches the receiver meet in it.
[[nodiscard]] glm::dvec3 border_direction(const Surface& receiver, const Source& source, const Edge& edge) {
    if (edge.is_cusp) return glm::normalize(glm::dmat3(receiver.from_world) * source.away(edge.place));
    const glm::dvec3 normal = glm::transpose(glm::dmat3(receiver.to_world)) * edge.normal;
    const glm::dvec3 direction = glm::cross(edge.up, normal);
    const double length = glm::length(direction);
    return length > 1e-9 * glm::length(normal) ? direction / length : glm::dvec3(0.0);
}

enum class Link : std::uint8_t { none, corner, smooth };

// Tells how the shadows of two places of an outline are linked.
[[nodiscard]] Link link_of(const Surface& receiver, const Source& source, const Edge& a, const Edge& b) {
    if (!a.falls || !b.falls) return Link::none;
    const double side = receiver.lines->mesh().side;
    const glm::dvec3 chord = b.shadow - a.shadow;
    const double length = glm::length(chord);
    if (!(length > 0.0)) return Link::smooth;
    if (length > scene_tuning.longest_border * side) return Link::none;
    const double cosine = std::min(std::abs(glm::dot(border_direction(receiver, source, a), chord)),
                                   std::abs(glm::dot(border_direction(receiver, source, b), chord))) /
                          length;
    if (cosine > scene_tuning.straight_border) return Link::smooth;
    if (length > scene_tuning.shortest_border * side) return Link::none;
    const double turn =
        std::abs(glm::dot(border_direction(receiver, source, a), border_direction(receiver, source, b)));
    return turn > scene_tuning.border_corner ? Link::smooth : Link::corner;
}

// Sets the light and the shadows of cusps. Beside a cusp the shadow falls near the outline, and it begins in the cusp.
void set_cusps(bool is_own, const Surroundings& all, Sections& sections) {
    for (std::int64_t s = 0; s < sections.count(); ++s) {
        const std::int64_t first = sections.first[s];
        const std::int64_t last = sections.first[s + 1] - 1;
        for (const auto& [at, beside] : {std::pair{first, first + 1}, std::pair{last, last - 1}}) {
            Edge& edge = sections.point[at];
            if (!edge.is_cusp) continue;
            edge.lit = sections.point[beside].lit;
            edge.falls = edge.lit && is_own;
            edge.shadow = transformed(all.receiver.from_world, edge.place);
            edge.up = glm::normalize(glm::transpose(glm::dmat3(all.receiver.to_world)) * edge.normal);
        }
    }
}

// Finds the light and the shadows of all places, and adds places until each end and each link is known.
[[nodiscard]] Sections follow(const base::Work& work, const Surroundings& all, const Source& source,
                              const Surface& surface, std::int64_t number, const Outlines& outlines) {
    Sections sections = sections_of(outlines);
    const bool is_own = number == all.number;
    trace_rays(work, all, source, surface, number, sections.point.span());
    set_cusps(is_own, all, sections);
    const auto middle_of = [&](std::int64_t s, const Edge& a, const Edge& b) {
        const double end = b.at > a.at ? b.at : b.at + static_cast<double>(outlines.curves.size_of(sections.curve[s]));
        return std::pair{0.5 * (a.at + end), end - a.at};
    };
    const auto wanted = [&](std::int64_t s, std::int64_t i, std::int64_t j, Edge& edge) {
        const Edge& a = sections.point[i];
        const Edge& b = sections.point[j];
        const bool is_end = a.falls != b.falls || (is_own && a.lit != b.lit);
        if (!is_end && (!a.falls || link_of(all.receiver, source, a, b) != Link::none)) return false;
        const auto [at, length] = middle_of(s, a, b);
        if (length < scene_tuning.least_share) return false;
        edge = edge_at(outlines, sections.curve[s], at);
        return true;
    };
    const auto bring = [&](base::Array<Edge>& added, const auto&, const auto&) {
        trace_rays(work, all, source, surface, number, added.span());
        base::Array<std::uint8_t> found(work.memory, added.size());
        std::fill(found.begin(), found.end(), std::uint8_t{1});
        return found;
    };
    while (curves::halve_pieces(sections, wanted, bring)) {
    }
    return sections;
}

// ---- Lines

void add_borders(const Sections& sections, const Surface& receiver, const Source& source, float strength,
                 curves::SurfaceLines& lines) {
    curves::LineBuilder builder(lines, true);
    for (std::int64_t s = 0; s < sections.count(); ++s) {
        const Edge* const edge = sections.point.data() + sections.first[s];
        const std::int64_t size = sections.size_of(s);
        const auto joined = [&](std::int64_t i) {
            return link_of(receiver, source, edge[i % size], edge[(i + 1) % size]) == Link::smooth;
        };
        curves::for_joined(size, sections.closed[s] != 0, joined,
                           [&](std::int64_t begin, std::int64_t end, bool whole) {
                               if (!edge[begin % size].falls) return;
                               for (std::int64_t i = begin; i < end; ++i) {
                                   const Edge& e = edge[i % size];
                                   const std::int64_t before = whole ? i + size - 1 : std::max(begin, i - 1);
                                   const std::int64_t after = whole ? i + 1 : std::min(end - 1, i + 1);
                                   const glm::dvec3 chord = edge[after % size].shadow - edge[before % size].shadow;
                                   const glm::dvec3 direction = border_direction(receiver, source, e);
                                   builder.add(e.shadow, e.up, static_cast<double>(strength),
                                               glm::dot(direction, chord) < 0.0 ? -direction : direction);
                               }
                               builder.end(whole);
                           });
    }
}

void add_terminators(const Sections& sections, const Surface& receiver, float strength, curves::SurfaceLines& lines) {
    curves::LineBuilder builder(lines, true);
    const glm::dmat3 from_world(receiver.from_world);
    const glm::dmat3 of_normals = glm::transpose(glm::dmat3(receiver.to_world));
    for (std::int64_t s = 0; s < sections.count(); ++s) {
        if (sections.curve[s] >= sections.first_border) break; // Borders lie between light and light.
        const Edge* const edge = sections.point.data() + sections.first[s];
        const std::int64_t size = sections.size_of(s);
        const auto is_lit = [&](std::int64_t i) { return edge[i].lit; };
        curves::for_parts(size, sections.closed[s] != 0, is_lit, [&](std::int64_t begin, std::int64_t end, bool whole) {
            for (std::int64_t i = begin; i < end; ++i) {
                const Edge& e = edge[i % size];
                builder.add(transformed(receiver.from_world, e.place), glm::normalize(of_normals * e.normal),
                            static_cast<double>(strength), from_world * e.along);
            }
            builder.end(whole);
        });
    }
}

// ---- Scraps

[[nodiscard]] double length_of(const curves::Curves& curves, std::int64_t line) noexcept {
    double length = 0.0;
    for (std::int64_t i = curves.first[line]; i < curves.first[line + 1]; ++i)
        if (const std::int64_t j = curves.next(line, i); j >= 0)
            length += glm::distance(curves.point[i].position, curves.point[j].position);
    return length;
}

// Borders and terminators.
struct ShadowLines {
    explicit ShadowLines(base::Memory& memory) : borders(memory), terminators(memory) {}

    curves::SurfaceLines borders, terminators;
};

// Returns for each border, and then for each terminator, the length of all lines that are joined with it: an end of one
// is within the distance `reach` of the other. Points of a line are at most `longest` apart, or not joined.
[[nodiscard]] base::Array<double> joined_lengths(const ShadowLines& lines, double reach, double longest) {
    base::Memory& memory = lines.borders.strength.memory();
    geometry::VecArray ends(memory), from(memory), to(memory), middle(memory);
    base::Array<std::int64_t> line_of_piece(memory);
    base::Array<double> own(memory);
    for (const curves::Curves* const curves : {&lines.borders.curves, &lines.terminators.curves})
        for (std::int64_t l = 0; l < curves->count(); ++l) {
            ends.push_back(curves->point[curves->first[l]].position);
            ends.push_back(curves->point[curves->first[l + 1] - 1].position);
            for (std::int64_t i = curves->first[l]; i < curves->first[l + 1]; ++i) {
                const std::int64_t j = curves->next(l, i);
                if (j < 0) continue;
                from.push_back(curves->point[i].position);
                to.push_back(curves->point[j].position);
                middle.push_back(0.5 * (curves->point[i].position + curves->point[j].position));
                line_of_piece.push_back(own.size());
            }
            own.push_back(length_of(*curves, l));
        }
    // For each line: a line of the same group with a lower number, or the line itself.
    base::Array<std::int64_t> group(memory, own.size());
    std::iota(group.begin(), group.end(), std::int64_t{0});
    const auto root = [&](std::int64_t line) {
        while (group[line] != line) line = group[line];
        return line;
    };
    const geometry::PointGrid grid(middle, reach + 0.5 * longest);
    for (std::int64_t e = 0; e < ends.size(); ++e)
        grid.around(ends[e], [&](std::int64_t at) {
            const std::int64_t piece = grid.index(at);
            if (geometry::distance_to_segment(ends[e], from[piece], to[piece]) > reach) return;
            const std::int64_t a = root(e / 2);
            const std::int64_t b = root(line_of_piece[piece]);
            group[std::max(a, b)] = std::min(a, b);
        });
    base::Array<double> total(memory, own.size());
    for (std::int64_t l = 0; l < own.size(); ++l) total[root(l)] += own[l];
    for (std::int64_t l = 0; l < own.size(); ++l) total[l] = total[root(l)];
    return total;
}

// Returns the lines whose length is at least `shortest`.
[[nodiscard]] curves::SurfaceLines without_scraps(const curves::SurfaceLines& lines, const double* length,
                                                  double shortest) {
    curves::SurfaceLines kept(lines.strength.memory());
    curves::LineBuilder builder(kept, true);
    for (std::int64_t l = 0; l < lines.curves.count(); ++l) {
        if (length[l] < shortest) continue;
        for (std::int64_t i = lines.curves.first[l]; i < lines.curves.first[l + 1]; ++i) builder.add(lines, i);
        builder.end(lines.curves.closed[l] != 0);
    }
    return kept;
}

} // namespace

base::List<curves::FoundLines> find_shadow_lines(const base::Work& work, const Casters& casters,
                                                 const ShadedItem& item) {
    HRBFNPR_ASSERT(item.lines != nullptr);
    const Surroundings all = surroundings_of(work, casters, item);
    ShadowLines lines(work.memory);
    for (std::size_t i = 0; i < item.lights.size(); ++i) {
        const LightStyle& light = item.lights[i];
        if (!(light.shadow > 0.0F)) continue;
        const Source source = source_of(light, item, casters);
        if (!(glm::length(glm::dvec3(source.light)) > 0.0) && source.light.w == 0.0) continue;
        for (std::int64_t number = 0; number < casters.caster.size(); ++number) {
            work.update(
                (static_cast<double>(i) + static_cast<double>(number) / static_cast<double>(casters.caster.size())) /
                static_cast<double>(item.lights.size()));
            const Caster& caster = casters.caster[number];
            HRBFNPR_ASSERT(caster.lines != nullptr);
            if (!may_shade(source, casters.bounds[number], all.bounds)) continue;
            const Surface surface = surface_of(*caster.lines, caster.to_world);
            const Outlines outlines = find_outlines(work.without_progress(), surface, source);
            const Sections sections = follow(work, all, source, surface, number, outlines);
            add_borders(sections, all.receiver, source, light.shadow, lines.borders);
            if (number == all.number) add_terminators(sections, all.receiver, light.shadow, lines.terminators);
        }
    }
    const double side = item.lines->mesh().side;
    const double shortest = scene_tuning.shortest_shadow * casters.diagonal / mean_scale(item.to_world);
    const base::Array<double> length =
        joined_lengths(lines, scene_tuning.border_gap * side, scene_tuning.longest_border * side);
    base::List<curves::FoundLines> found(work.memory);
    for (const bool cast : {true, false}) {
        curves::FoundLines& of_kind = found.add(curves::FoundLines(work.memory));
        of_kind.kind = cast ? curves::LineKind::shadow : curves::LineKind::terminator;
        of_kind.lines = without_scraps(cast ? lines.borders : lines.terminators,
                                       length.data() + (cast ? 0 : lines.borders.curves.count()), shortest);
    }
    return found;
}

} // namespace hrbfnpr::frame
