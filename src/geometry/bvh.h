// SPDX-License-Identifier: MIT
// A bounding volume hierarchy over triangles. It finds the nearest triangle, and the triangles that a ray meets.
//
// The walk through the boxes computes with floats and finds all triangles that may matter (bvh_loops.h). These are
// tested in doubles. So the results are those of a test of all triangles one by one, whatever the instruction set.
#pragma once

#include "base/memory.h"
#include "base/work.h"
#include "geometry/bvh_loops.h"
#include "geometry/vec.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

namespace hrbfnpr::geometry {

class Bvh {
public:
    using Triangle = std::array<std::int32_t, 3>;
    struct Nearest {
        double squared = std::numeric_limits<double>::infinity(); // the squared distance to the nearest place
        std::int64_t face = -1;                                   // -1 if no face is within the limit
        glm::dvec3 place{0.0};
    };
    struct Hit {
        double t = std::numeric_limits<double>::infinity(); // the parameter of the ray, in lengths of its direction
        std::int64_t face = -1;                             // -1 if the ray meets no face
    };

    Bvh(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle);

    // The functions below may be called on any number of threads. If several faces are equally good, the one with the
    // lowest index is found.

    // Finds no face farther than `limit`, which is a squared distance.
    [[nodiscard]] Nearest nearest(const glm::dvec3& p,
                                  double limit = std::numeric_limits<double>::infinity()) const noexcept;
    [[nodiscard]] double distance(const glm::dvec3& p) const noexcept { return std::sqrt(nearest(p).squared); }

    // A ray through an edge or a vertex meets all faces there, so no ray passes between faces. t_min must be at least
    // 0.

    // Returns the first face that a ray meets at t_min < t < t_max.
    [[nodiscard]] Hit first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                                double t_max) const noexcept;
    // Returns whether a ray meets a face at t_min < t < t_max. The search ends at any such face.
    [[nodiscard]] bool any_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                               double t_max) const noexcept;
    // Calls visit(face, t, sign) for all faces that a ray meets at t > 0, in no particular order. The sign is 1 if the
    // face's normal points along the ray, so that the ray leaves the solid, else -1.
    template <class Visit>
    void crossings(const glm::dvec3& origin, const glm::dvec3& direction, Visit&& visit) const {
        using Function = std::remove_reference_t<Visit>;
        visit_crossings(
            origin, direction, std::numeric_limits<double>::infinity(),
            [](void* user, std::int32_t face, double t, int sign) { (*static_cast<Function*>(user))(face, t, sign); },
            const_cast<void*>(static_cast<const void*>(std::addressof(visit))));
    }
    // Returns the winding number at `place` minus that at `other`: the sum of the signs of the faces between them.
    [[nodiscard]] int winding_beyond(const glm::dvec3& place, const glm::dvec3& other) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return node_.bytes() + leaf_.bytes() + face_.bytes() + corners_.bytes();
    }

private:
    using Corners = std::array<glm::dvec3, 3>;
    using VisitCrossing = void (*)(void* user, std::int32_t face, double t, int sign);
    struct ExactRay;
    struct WalkRay;

    void visit_crossings(const glm::dvec3& origin, const glm::dvec3& direction, double t_max, VisitCrossing visit,
                         void* user) const;
    [[nodiscard]] bool start(const ExactRay& exact, double t_min, double t_max, WalkRay& walk) const noexcept;
    // Calls meet(number, t) for the faces that a ray meets at t_min < t <= t_max. It returns a new value of t_max. A
    // negative value ends the search.
    template <class Meet>
    void cast(const glm::dvec3& origin, const glm::dvec3& direction, double t_min, double t_max, Meet&& meet) const;
    [[nodiscard]] BvhView view() const noexcept { return {node_.data(), leaf_.data(), root_}; }

    BvhLoops loops_;
    base::Array<BvhNode> node_;
    base::Array<BvhLeaf> leaf_;
    base::Array<std::int32_t> face_; // the indices of the faces, in the order of the leaves
    base::Array<Corners> corners_;   // in the same order
    std::uint32_t root_ = 0;
    Bounds bounds_;
    glm::dvec3 centre_{0.0};
    double scale_ = 1.0; // The walk's coordinates are scale_ * (x - centre_).
};

} // namespace hrbfnpr::geometry
