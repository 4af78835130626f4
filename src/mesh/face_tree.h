// SPDX-License-Identifier: MIT
// A tree of boxes over faces. It finds the nearest face, and the faces that a ray meets.
#pragma once

#include "geometry/heap_node.h"
#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {

class FaceTree {
public:
    struct Nearest {
        double squared = std::numeric_limits<double>::infinity(); // the squared distance to the nearest place
        std::int64_t face = -1;                                   // -1 if no face is within the limit
        glm::dvec3 place{0.0};
    };
    struct Alone : Nearest {
        bool alone = false; // true if all other faces are farther by more than rounding errors
    };
    struct Hit {
        double t = std::numeric_limits<double>::infinity(); // the parameter of the ray, in lengths of its direction
        std::int64_t face = -1;                             // -1 if the ray meets no face
    };

    FaceTree(const base::Work& work, const base::Array<glm::dvec3>& vertex, const base::Array<Triangle>& triangle);
    // Makes a tree of the faces of another tree whose boxes overlap a box. They keep their order and indices.
    FaceTree(base::Memory& memory, const FaceTree& all, const geometry::Bounds& box);

    // These functions may be called on any number of threads. nearest() always finds the same face if several are
    // equally near. It finds no face farther than `limit`, which is a squared distance.
    [[nodiscard]] Nearest nearest(const glm::dvec3& p,
                                  double limit = std::numeric_limits<double>::infinity()) const noexcept;
    // Finds the nearest face, and whether it is alone. If it is not, nearest() may find another face.
    [[nodiscard]] Alone nearest_alone(const glm::dvec3& p, double limit) const noexcept;
    [[nodiscard]] double distance(const glm::dvec3& p) const noexcept { return std::sqrt(nearest(p).squared); }
    // Returns the first face that a ray meets at t_min < t < t_max.
    [[nodiscard]] Hit first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                                double t_max) const noexcept;
    // Calls visit(face, t, sign) for all faces that a ray meets at 0 < t < limit, in the order of the tree. The sign is
    // 1 if the face's normal points along the ray, so that the ray leaves the solid, else -1.
    template <class Visit>
    void crossings(const glm::dvec3& origin, const glm::dvec3& direction, Visit&& visit,
                   const double limit = std::numeric_limits<double>::infinity()) const {
        walk<false>(origin, direction, 0.0, limit, [&](std::int64_t at, double t) {
            visit(face_[at], t, glm::dot(doubled_area(corners_[at]), direction) > 0.0 ? 1 : -1);
        });
    }
    // Returns the winding number at `place` minus that at `other`: the sum of the signs of the faces between them.
    [[nodiscard]] int winding_beyond(const glm::dvec3& place, const glm::dvec3& other) const noexcept {
        const glm::dvec3 way = other - place;
        const double limit = 1.0;
        int winding = 0;
        walk<false>(place, way, 0.0, limit, [&](std::int64_t at, double) {
            winding += glm::dot(doubled_area(corners_[at]), way) > 0.0 ? 1 : -1;
        });
        return winding;
    }

    [[nodiscard]] std::int64_t bytes() const noexcept { return box_.bytes() + face_.bytes() + corners_.bytes(); }

private:
    using Corners = std::array<glm::dvec3, 3>;
    static constexpr std::int64_t leaf_size = 4;
    using Range = geometry::HeapNode<leaf_size>;

    // Returns the t at which a ray meets a face, or NaN if it does not.
    [[nodiscard]] static double meet(const Corners& p, const glm::dvec3& origin, const glm::dvec3& direction) noexcept;
    // Returns whether a ray meets the box at a t in the range.
    [[nodiscard]] static bool meets(const geometry::Bounds& box, const glm::dvec3& origin, const glm::dvec3& inverse,
                                    double t_min, double t_max) noexcept {
        const glm::dvec3 a = (box.min - origin) * inverse;
        const glm::dvec3 b = (box.max - origin) * inverse;
        const glm::dvec3 low = glm::min(a, b);
        const glm::dvec3 high = glm::max(a, b);
        const double from = std::max({low.x, low.y, low.z, t_min});
        const double to = std::min({high.x, high.y, high.z, t_max});
        return from <= to * (1.0 + 1e-12) || from <= to; // In a flat box `from` may equal `to`.
    }
    // Calls visit(at, t) for the faces that a ray meets at t_min < t < limit. The call may lower the limit. If
    // near_first is true, boxes are visited roughly in the order in which the ray enters them.
    template <bool near_first, class Visit>
    void walk(const glm::dvec3& origin, const glm::dvec3& direction, double t_min, const double& limit,
              Visit&& visit) const;
    void split(const base::Array<glm::dvec3>& middle, const Range& range);
    void split_all(const base::Array<glm::dvec3>& middle, const Range& range);
    void set_box(const Range& range) noexcept;   // from the boxes of the node's children, or from its faces
    void set_boxes(const Range& range) noexcept; // the same for the node and all below it

    base::Array<geometry::Bounds> box_; // the boxes of the nodes, in heap order
    base::Array<std::int32_t> face_;    // the indices of the faces, in the order of the tree
    base::Array<Corners> corners_;
};

// Directions of rays that are unlikely to pass exactly through edges of a mesh.
inline constexpr std::array<glm::dvec3, 3> ray_directions{
    glm::dvec3{0.5773, 0.2161, 0.7874}, glm::dvec3{-0.6431, 0.7321, 0.2247}, glm::dvec3{0.1713, -0.5119, -0.8418}};

template <bool near_first, class Visit>
void FaceTree::walk(const glm::dvec3& origin, const glm::dvec3& direction, double t_min, const double& limit,
                    Visit&& visit) const {
    const glm::dvec3 inverse = 1.0 / direction;
    std::array<Range, geometry::most_heap_levels> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, 0, face_.size()};
    while (depth > 0) {
        const Range range = stack[--depth];
        if (!meets(box_[range.node], origin, inverse, t_min, limit)) continue;
        if (!range.leaf()) {
            HRBFNPR_ASSERT(depth + 2 <= stack.size());
            bool low_first = true;
            if constexpr (near_first) {
                const glm::dvec3 way = box_[range.low().node].centre() - box_[range.high().node].centre();
                low_first = glm::dot(way, direction) <= 0.0;
            }
            stack[depth++] = low_first ? range.high() : range.low();
            stack[depth++] = low_first ? range.low() : range.high();
            continue;
        }
        for (std::int64_t at = range.begin; at < range.end; ++at) {
            const double t = meet(corners_[at], origin, direction);
            if (t > t_min && t < limit) visit(at, t);
        }
    }
}

} // namespace hrbfnpr::mesh
