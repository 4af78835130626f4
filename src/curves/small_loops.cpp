// SPDX-License-Identifier: MIT
#include "curves/small_loops.h"

#include "base/list.h"
#include "geometry/tangent_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t searched_a_task = 8192;
// A vertex is looked around if |g| there is below this share of what it is more at a neighbour.  The extremum of a
// quadratic is nearer than half an edge, and lower by a quarter of that difference.
constexpr double low = 1.0;
// In sides of the mesh.
constexpr double probe = 0.05;
constexpr double longest_step = 0.5;
constexpr double farthest_extremum = 1.5;
constexpr double near_surface = 1e-3; // what is no farther off counts as on it
// Of |g| at the vertex: a quadratic whose extremum is no lower, and near, has no zero.
constexpr double hopeless = 0.5;
constexpr int extremum_steps = 5;

std::int64_t corner_of(const SurfaceMesh& mesh, std::int64_t triangle, std::int32_t vertex) noexcept {
    std::int64_t k = 0;
    while (mesh.corner[3 * triangle + k] != vertex) ++k;
    return k;
}

// Whether `holds` does for all neighbours of a triangle's corner: around it over the edges that begin there, and at a
// border also the other way.
template <class Holds>
bool all_neighbours(const SurfaceMesh& mesh, std::int64_t triangle, std::int32_t vertex, Holds&& holds) {
    for (const std::int64_t over : {0, 2}) {
        std::int64_t t = triangle;
        do {
            const std::int64_t k = corner_of(mesh, t, vertex);
            if (!holds(mesh.corner[3 * t + (k + 1) % 3]) || !holds(mesh.corner[3 * t + (k + 2) % 3])) return false;
            t = mesh.neighbour[3 * t + (k + over) % 3];
        } while (t >= 0 && t != triangle);
        if (t >= 0) break;
    }
    return true;
}

// Whether g has one sign in a triangle, and |g| is low at a corner beside another.  Without branches: it is asked of
// every triangle.
bool is_low(double a, double b, double c) noexcept {
    const double lower = std::min(std::abs(a), std::min(std::abs(b), std::abs(c)));
    const double upper = std::max(std::abs(a), std::max(std::abs(b), std::abs(c)));
    const unsigned parted = unsigned(std::min(a, std::min(b, c)) < 0.0) & unsigned(std::max(a, std::max(b, c)) > 0.0);
    return (unsigned(lower < low * (upper - lower)) & ~parted) != 0;
}

// The corner where |g| is least.
std::int32_t least_corner(const SurfaceMesh& mesh, const base::Array<double>& level, std::int64_t triangle) noexcept {
    const std::int32_t* const v = mesh.corner.data() + 3 * triangle;
    return *std::min_element(v, v + 3,
                             [&](std::int32_t a, std::int32_t b) { return std::abs(level[a]) < std::abs(level[b]); });
}

// Whether |g| is nowhere less among a vertex' neighbours, and none of these has the other sign.
bool is_least(const SurfaceMesh& mesh, const base::Array<double>& level, std::int64_t triangle, std::int32_t vertex) {
    const double here = level[vertex];
    return all_neighbours(mesh, triangle, vertex, [&](std::int32_t other) {
        return (level[other] < 0.0) == (here < 0.0) && std::abs(level[other]) >= std::abs(here);
    });
}

// Vertices where |g| is least and low, ascending.
base::Array<std::int32_t> find_low(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                   const base::Array<double>& level) {
    const std::int64_t tasks = (mesh.triangles() + searched_a_task - 1) / searched_a_task;
    base::List<base::Array<std::int32_t>> found(runtime.memory);
    for (std::int64_t task = 0; task < tasks; ++task) found.add(base::Array<std::int32_t>(runtime.memory));
    runtime.parallel.for_chunks(mesh.triangles(), searched_a_task, [&](std::int64_t begin, std::int64_t end) {
        base::Array<std::int32_t>& here = found[begin / searched_a_task];
        for (std::int64_t t = begin; t < end; ++t) {
            const std::int32_t* const v = mesh.corner.data() + 3 * t;
            if (!is_low(level[v[0]], level[v[1]], level[v[2]])) continue;
            const std::int32_t lowest = least_corner(mesh, level, t);
            if (is_least(mesh, level, t, lowest)) here.push_back(lowest);
        }
    });
    base::Array<std::int32_t> all(runtime.memory);
    for (const base::Array<std::int32_t>& some : found)
        for (const std::int32_t v : some) all.push_back(v);
    std::sort(all.begin(), all.end());
    all.resize(std::unique(all.begin(), all.end()) - all.begin());
    return all;
}

// On the way to an extremum.
struct LoopSearch {
    std::int32_t vertex;
    glm::dvec3 place;
};

class Searches {
public:
    Searches(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
             const base::Array<double>& at_vertices)
        : runtime_(runtime), level_(level), mesh_(mesh), at_vertices_(at_vertices), active_(runtime.memory),
          points_(runtime.memory), found_(runtime.memory) {}

    void add(std::int32_t vertex) { active_.push_back({vertex, mesh_.position[vertex]}); }
    void run(std::int64_t& evaluations, const base::Progress& progress);
    [[nodiscard]] base::Array<Straddle> result() && { return std::move(found_); }

private:
    struct Frame {
        glm::dvec3 u, v;
    };
    [[nodiscard]] Frame frame_at(std::int32_t vertex) const noexcept {
        const glm::dvec3 n = glm::normalize(mesh_.gradient[vertex]);
        const glm::dvec3 u = geometry::any_perpendicular(n);
        return {u, glm::cross(n, u)};
    }
    void place_probes();
    void bring_to_surface(std::int64_t& evaluations, const base::Progress& progress);
    [[nodiscard]] bool go_on(LoopSearch& search, const CurvePoint* three);

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceMesh& mesh_;
    const base::Array<double>& at_vertices_;
    base::Array<LoopSearch> active_;
    base::Array<CurvePoint> points_; // three of each search: its place, and one beside it in each tangent direction
    base::Array<Straddle> found_;
};

void Searches::place_probes() {
    points_.resize(3 * active_.size());
    for (std::int64_t i = 0; i < active_.size(); ++i) {
        const Frame frame = frame_at(active_[i].vertex);
        const glm::dvec3 place = active_[i].place;
        points_[3 * i].position = place;
        points_[3 * i + 1].position = place + probe * mesh_.side * frame.u;
        points_[3 * i + 2].position = place + probe * mesh_.side * frame.v;
    }
}

// Newton's step to where the part of grad g in the tangent plane is 0, by its differences between the three places.
bool Searches::go_on(LoopSearch& search, const CurvePoint* three) {
    const bool negative = at_vertices_[search.vertex] < 0.0;
    for (int k = 0; k < 3; ++k) {
        if ((three[k].level < 0.0) == negative) continue;
        const glm::dvec3 vertex = mesh_.position[search.vertex];
        found_.push_back(negative ? Straddle{vertex, three[k].position} : Straddle{three[k].position, vertex});
        return false;
    }
    const Frame frame = frame_at(search.vertex);
    // On the surface: what of grad g lies along grad f counts for nothing.
    const auto slope = [&](const CurvePoint& p) {
        const glm::dvec3 n = p.gradient / glm::dot(p.gradient, p.gradient);
        const glm::dvec3 g = p.level_gradient - glm::dot(p.level_gradient, n) * p.gradient;
        return glm::dvec2(glm::dot(g, frame.u), glm::dot(g, frame.v));
    };
    const double h = probe * mesh_.side;
    const glm::dvec2 g = slope(three[0]);
    const glm::dvec2 u = (slope(three[1]) - g) / h;
    const glm::dvec2 v = (slope(three[2]) - g) / h;
    const double mixed = 0.5 * (u.y + v.x);
    const double determinant = u.x * v.y - mixed * mixed;
    glm::dvec2 step((-g.x * v.y + g.y * mixed) / determinant, (-g.y * u.x + g.x * mixed) / determinant);
    const double length = glm::length(step);
    if (!(length > 1e-3 * mesh_.side)) return false;
    const double extremum = (three[0].level + 0.5 * glm::dot(g, step)) * (negative ? -1.0 : 1.0);
    if (length <= longest_step * mesh_.side && extremum > hopeless * std::abs(at_vertices_[search.vertex]))
        return false;
    if (length > longest_step * mesh_.side) step *= longest_step * mesh_.side / length;
    search.place = three[0].position + step.x * frame.u + step.y * frame.v;
    return glm::distance(search.place, mesh_.position[search.vertex]) <= farthest_extremum * mesh_.side;
}

// By a step along grad f where that is needed: beside a vertex of the mesh it is not.
void Searches::bring_to_surface(std::int64_t& evaluations, const base::Progress& progress) {
    evaluate(runtime_, level_, points_, progress);
    evaluations += points_.size();
    base::Array<CurvePoint> off(runtime_.memory);
    base::Array<std::int64_t> of(runtime_.memory);
    for (std::int64_t i = 0; i < points_.size(); ++i) {
        CurvePoint p = points_[i];
        step_to_surface(p);
        if (glm::distance(p.position, points_[i].position) <= near_surface * mesh_.side) continue;
        off.push_back(p);
        of.push_back(i);
    }
    evaluate(runtime_, level_, off, progress);
    evaluations += off.size();
    for (std::int64_t k = 0; k < of.size(); ++k) points_[of[k]] = off[k];
}

void Searches::run(std::int64_t& evaluations, const base::Progress& progress) {
    for (int step = 0; step < extremum_steps && !active_.empty(); ++step) {
        place_probes();
        bring_to_surface(evaluations, progress);
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < active_.size(); ++i) {
            LoopSearch search = active_[i];
            if (go_on(search, points_.data() + 3 * i)) active_[left++] = search;
        }
        active_.resize(left);
    }
}

} // namespace

base::Array<Straddle> find_small_loops(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                                       const base::Array<double>& at_vertices, std::int64_t& evaluations,
                                       const base::Progress& progress) {
    Searches searches(runtime, level, mesh, at_vertices);
    for (const std::int32_t vertex : find_low(runtime, mesh, at_vertices)) searches.add(vertex);
    searches.run(evaluations, progress);
    return std::move(searches).result();
}

} // namespace hrbfnpr::curves
