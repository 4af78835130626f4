// SPDX-License-Identifier: MIT
// The plain reference of technical drawings: which places are hidden, by straight lines through exact solids or through
// all triangles of a mesh; and places on all edges, found from the functions of the faces.
#pragma once

#include "technical_parts.h"

#include <map>
#include <optional>
#include <random>
#include <set>

namespace bench {

class TechnicalReference {
public:
    explicit TechnicalReference(const TechnicalPart& part) : part_(part) {
        for (const PlainSolid& item : part.items) item.add_faces(glm::dmat4(1.0), faces_);
        const double size = 6.0;
        low_ = glm::dvec3(size);
        high_ = -low_;
        if (part.is_mesh())
            for (const glm::dvec3& p : part.mesh.points) extend(p);
        else // The box of a solid is found from many straight lines.
            for (int axis = 0; axis < 3; ++axis)
                for (int i = -60; i <= 60; ++i)
                    for (int k = -60; k <= 60; ++k) extend_by(axis, 0.05 * i + 0.001, 0.05 * k + 0.002);
        diagonal = glm::distance(low_, high_);
        // Meshes are fitted, and drawn up to a third of a percent off.
        margin = (part.is_mesh() ? 4e-3 : 1e-3) * diagonal;
    }

    // Returns whether a place on the surface is hidden, or nothing if lines beside it say otherwise.
    [[nodiscard]] std::optional<bool> hidden(const glm::dvec3& p, const glm::dvec3& to_eye) const {
        const glm::dvec3 out = outward(p);
        const glm::dvec3 side =
            glm::normalize(glm::cross(to_eye, std::abs(to_eye.x) < 0.8 ? technical::x_axis : technical::y_axis));
        const glm::dvec3 up = glm::cross(side, to_eye);
        const auto meets_all = [&](double away) {
            int count = 0;
            for (const glm::dvec3& beside : {glm::dvec3(0.0), side, -side, up, -up})
                count += meets(p + 2.0 * away * out + std::abs(away) * beside, to_eye) ? 1 : 0;
            return count;
        };
        // Lines nearer to the place must say the same. Just beyond the place where a line turns away from the eye, the
        // solid hides it so shallowly that only the nearest line meets it.
        const auto side_is_hidden = [&](double sign) -> std::optional<bool> {
            const int count = meets_all(sign * margin);
            if (count != 0 && count != 5) return std::nullopt;
            for (const double near : {0.05, 2e-3})
                if (meets(p + sign * near * margin * out, to_eye) != (count == 5)) return std::nullopt;
            return count == 5;
        };
        const std::optional<bool> front = side_is_hidden(1.0);
        if (!part_.is_mesh() || !front || !*front) return front;
        const std::optional<bool> back = side_is_hidden(-1.0); // An open surface may be seen from its other side.
        return back;
    }

    // Returns places on the sharp edges and, for a direction to the eye, on the contours of round faces. They are at
    // most about a hundredth of the diagonal apart.
    [[nodiscard]] std::vector<glm::dvec3> edge_places(const glm::dvec3& to_eye) const {
        return part_.is_mesh() ? places_on_mesh() : places_on_solids(to_eye);
    }
    [[nodiscard]] const glm::dvec3& low() const { return low_; }
    [[nodiscard]] const glm::dvec3& high() const { return high_; }

    double diagonal = 0.0;
    double margin = 0.0;

private:
    void extend(const glm::dvec3& p) {
        low_ = glm::min(low_, p);
        high_ = glm::max(high_, p);
    }
    void extend_by(int axis, double a, double b) {
        glm::dvec3 origin(0.0);
        glm::dvec3 way(0.0);
        way[axis] = 1.0;
        origin[(axis + 1) % 3] = a;
        origin[(axis + 2) % 3] = b;
        for (const PlainSolid& item : part_.items)
            for (const InsideSpan& span : item.spans(origin, way)) {
                extend(origin + span.from * way);
                extend(origin + span.to * way);
            }
    }

    template <class F>
    static glm::dvec3 gradient(const F& f, const glm::dvec3& p, double h) {
        glm::dvec3 g;
        for (int c = 0; c < 3; ++c) {
            glm::dvec3 step(0.0);
            step[c] = h;
            g[c] = (f(p + step) - f(p - step)) / (2.0 * h);
        }
        return g;
    }
    // Returns the direction away from the item, or the items, on whose surface a place lies.
    [[nodiscard]] glm::dvec3 outward(const glm::dvec3& p) const {
        glm::dvec3 sum(0.0);
        if (part_.is_mesh()) {
            double nearest = 1e300;
            for (const Face& face : part_.mesh.faces) nearest = std::min(nearest, distance(p, face));
            for (const Face& face : part_.mesh.faces)
                if (distance(p, face) < nearest + 0.2 * margin) sum += normal_of(face);
        } else {
            double least = 1e300;
            for (const PlainSolid& item : part_.items) least = std::min(least, std::abs(item.value(p)));
            for (const PlainSolid& item : part_.items)
                if (std::abs(item.value(p)) < least + 0.1 * margin)
                    sum +=
                        glm::normalize(gradient([&](const glm::dvec3& q) { return item.value(q); }, p, 0.2 * margin));
        }
        const double length = glm::length(sum);
        return length > 1e-6 ? sum / length : glm::dvec3(0.0);
    }
    [[nodiscard]] bool meets(const glm::dvec3& origin, const glm::dvec3& way) const {
        constexpr double least = 1e-9;
        if (!part_.is_mesh())
            return std::any_of(part_.items.begin(), part_.items.end(), [&](const PlainSolid& item) {
                const InsideSpans spans = item.spans(origin, way);
                return std::any_of(spans.begin(), spans.end(), [&](const InsideSpan& span) {
                    return std::min(span.to, 1e9) - std::max(span.from, 0.0) > least;
                });
            });
        return std::any_of(part_.mesh.faces.begin(), part_.mesh.faces.end(), [&](const Face& face) {
            const glm::dvec3 a = corner(face, 0);
            const glm::dvec3 u = corner(face, 1) - a;
            const glm::dvec3 v = corner(face, 2) - a;
            const glm::dvec3 h = glm::cross(way, v);
            const double det = glm::dot(u, h);
            if (det == 0.0) return false;
            const glm::dvec3 s = origin - a;
            const double x = glm::dot(s, h) / det;
            const glm::dvec3 q = glm::cross(s, u);
            const double y = glm::dot(way, q) / det;
            return x >= 0.0 && y >= 0.0 && x + y <= 1.0 && glm::dot(v, q) / det > 0.0;
        });
    }
    [[nodiscard]] const glm::dvec3& point(std::int32_t number) const {
        return part_.mesh.points[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] const glm::dvec3& corner(const Face& face, std::size_t k) const { return point(face[k]); }
    [[nodiscard]] glm::dvec3 normal_of(const Face& face) const {
        return glm::normalize(glm::cross(corner(face, 1) - corner(face, 0), corner(face, 2) - corner(face, 0)));
    }
    // Returns the distance of a place from a triangle.
    [[nodiscard]] double distance(const glm::dvec3& p, const Face& face) const {
        const glm::dvec3 n = normal_of(face);
        bool inside = true;
        double to_edge = 1e300;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = corner(face, k);
            const glm::dvec3 b = corner(face, (k + 1) % 3);
            inside = inside && glm::dot(glm::cross(b - a, p - a), n) >= 0.0;
            const double share = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            to_edge = std::min(to_edge, glm::distance(p, glm::mix(a, b, share)));
        }
        return inside ? std::abs(glm::dot(p - corner(face, 0), n)) : to_edge;
    }

    [[nodiscard]] std::vector<glm::dvec3> places_on_mesh() const {
        std::map<std::pair<std::int32_t, std::int32_t>, std::vector<glm::dvec3>> edges;
        for (const Face& face : part_.mesh.faces)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [a, b] = std::minmax(face[k], face[(k + 1) % 3]);
                edges[{a, b}].push_back(normal_of(face));
            }
        std::vector<glm::dvec3> places;
        for (const auto& [edge, normals] : edges) {
            if (normals.size() == 2 && glm::dot(normals[0], normals[1]) > std::cos(glm::radians(30.0))) continue;
            const glm::dvec3 a = point(edge.first);
            const glm::dvec3 b = point(edge.second);
            const int count = 1 + static_cast<int>(glm::distance(a, b) / (0.01 * diagonal));
            for (int i = 0; i < count; ++i) places.push_back(glm::mix(a, b, (i + 0.5) / count));
        }
        return places;
    }

    // Returns how the boundary of the solid looks around a place of it, in the plane across a direction: the angle
    // between the two ways along the boundary, or a negative number if it is no boundary. A smooth surface has 180
    // degrees.
    [[nodiscard]] double angle_at(const PlainSolid& item, const glm::dvec3& p, const glm::dvec3& along) const {
        const glm::dvec3 u =
            glm::normalize(glm::cross(along, std::abs(along.x) < 0.8 ? technical::x_axis : technical::y_axis));
        const glm::dvec3 v = glm::cross(along, u);
        constexpr int steps = 180;
        int inside = 0;
        int changes = 0;
        bool last = false;
        for (int i = 0; i <= steps; ++i) {
            const double turn = 2.0 * std::numbers::pi * (i + 0.3) / steps;
            const bool now = item.value(p + 1e-4 * diagonal * (std::cos(turn) * u + std::sin(turn) * v)) < 0.0;
            if (i > 0) changes += now != last ? 1 : 0;
            if (i > 0) inside += now ? 1 : 0;
            last = now;
        }
        return changes == 0 ? -1.0 : 360.0 * inside / steps;
    }

    [[nodiscard]] std::vector<glm::dvec3> places_on_solids(const glm::dvec3& to_eye) const {
        std::vector<glm::dvec3> places;
        std::set<std::array<int, 3>> cells; // one place for each cell
        std::mt19937 random(1);             // NOLINT: the places must be the same in each run
        std::uniform_real_distribution<double> share(-0.05, 1.05);
        const double h = 1e-6 * diagonal;
        const auto search = [&](const PlainFunction& f, const PlainFunction& g, bool is_contour, int tries) {
            for (int i = 0; i < tries; ++i) {
                glm::dvec3 p = low_ + (high_ - low_) * glm::dvec3(share(random), share(random), share(random));
                glm::dvec3 a(0.0);
                glm::dvec3 b(0.0);
                for (int step = 0; step < 10; ++step) { // Newton steps of least length
                    a = gradient(f, p, h);
                    b = gradient(g, p, h);
                    const double aa = glm::dot(a, a);
                    const double ab = glm::dot(a, b);
                    const double bb = glm::dot(b, b);
                    const double det = aa * bb - ab * ab;
                    if (!(det > 1e-4 * aa * bb)) break;
                    p -= ((f(p) * bb - g(p) * ab) * a + (g(p) * aa - f(p) * ab) * b) / det;
                }
                if (std::abs(f(p)) + std::abs(g(p)) > 1e-7 * diagonal) continue;
                const glm::dvec3 along = glm::cross(a, b);
                if (!(glm::length(along) > 1e-3 * glm::length(a) * glm::length(b))) continue;
                for (const PlainSolid& item : part_.items) {
                    if (std::abs(item.value(p)) > 1e-6 * diagonal) continue;
                    const double angle = angle_at(item, p, glm::normalize(along));
                    const bool is_smooth = std::abs(angle - 180.0) < 8.0;
                    if (angle < 0.0 || is_smooth != is_contour) continue;
                    const glm::dvec3 cell = glm::floor(p / (0.008 * diagonal));
                    if (cells.insert({static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)})
                            .second)
                        places.push_back(p);
                }
            }
        };
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            for (std::size_t k = i + 1; k < faces_.size(); ++k) search(faces_[i], faces_[k], false, 60);
            const PlainFunction& f = faces_[i];
            search(
                f, [&](const glm::dvec3& p) { return diagonal * glm::dot(gradient(f, p, 1e-4 * diagonal), to_eye); },
                true, 200);
        }
        return places;
    }

    const TechnicalPart& part_;
    std::vector<PlainFunction> faces_;
    glm::dvec3 low_, high_;
};

} // namespace bench
