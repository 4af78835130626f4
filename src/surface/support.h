// SPDX-License-Identifier: MIT
// Support: how well the samples around a point of the surface confirm it. The zero level of an implicit continues
// beyond its samples, and the surface there is invented.
//
//   s(x) = 3 (|c|^2 - ln sum_j w_j),   w_j = exp(-|q_j|^2) ((1 + n_j . m) / 2)^2,   q_j = (x - p_j) / (0.9 h_j)
//
// The sums are over the samples p_j nearest to x. n_j are their normals, h_j is the spacing around each, m is the unit
// normal at x, and c = sum_j w_j q_j / sum_j w_j. c tells how far x is from the middle of its neighbours (Adamson and
// Alexa 2004), and does not depend on how many there are. s is near -4.7 among samples. It grows away from them, and
// where they face another way.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/along_curves.h"
#include "geometry/cell_set.h"
#include "geometry/point_tree.h"
#include "geometry/vec_array.h"

#include <cstdint>

namespace hrbfnpr::surface {

class Support {
public:
    static constexpr std::int64_t nearest = 24;

    // The value of s at a point with a normal, and its derivatives by both.
    struct ValueAndDerivatives {
        double value;               // infinite if no sample is near or faces the same way
        glm::dvec3 place_gradient;  // its gradient for a fixed normal
        glm::dvec3 normal_gradient; // its derivative by the normal, perpendicular to the normal
    };

    // `position` and `normal` (unit) belong to the same samples, one or more. Spacings below `closest` are raised to
    // it, so that dense samples of a coarser shape support all within `closest`.
    Support(const base::Work& work, const geometry::VecArray& position, const geometry::VecArray& normal,
            double closest);

    // Keeps s below `limit` in the `kept` cells from now on, so that holes there stay closed. `ends` are the cells in
    // which the surface may end, among all that it is known to pass.
    void keep(const geometry::CellGrid& grid, geometry::CellSet kept, geometry::CellSet ends, double limit);
    [[nodiscard]] bool may_end_at(const glm::dvec3& place) const noexcept {
        return !(limit_ > 0.0) || !kept_.contains(geometry::CellGrid::pack(grid_.cell_of(place)));
    }
    [[nodiscard]] bool has_kept() const noexcept { return limit_ > 0.0; }
    // Tells whether the surface may end in a cube around the point.
    [[nodiscard]] bool may_end_near(const glm::dvec3& place, double half) const noexcept;

    // These run on the calling thread, and may be called from any number of threads at once.
    [[nodiscard]] double value(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept;
    [[nodiscard]] ValueAndDerivatives evaluate(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept;
    // Computes s at many points from grad f there, which need not be unit, and resizes `value`. The result has the same
    // bits for any number of threads.
    void evaluate_all(const base::Work& work, const geometry::VecArray& place, const geometry::VecArray& gradient,
                      base::Array<double>& value) const;

    // The nearest sample's distance, its spacing, and whether others surround it (surface/surrounded.h).
    struct Nearest {
        double distance, spacing;
        bool surrounded;
    };
    [[nodiscard]] Nearest nearest_sample(const glm::dvec3& place) const noexcept;
    [[nodiscard]] double median_spacing() const;
    // Tells whether a cube surely holds no surface: s is above `limit` in all of it for any normal, and no cell is
    // kept. Returns false if that is not certain.
    [[nodiscard]] bool has_nothing_near(const glm::dvec3& place, double half, double limit) const noexcept;
    // Tells whether the samples are along curves, with nothing between these.
    [[nodiscard]] bool samples_lie_along_curves() const { return geometry::lie_along_curves(tree_); }
    [[nodiscard]] geometry::VecArray samples_not_surrounded() const;

    // The samples' positions and normals, in this object's own order.
    [[nodiscard]] const geometry::VecArray& positions() const noexcept { return tree_.points(); }
    [[nodiscard]] const geometry::VecArray& normals() const noexcept { return normal_; }
    // Returns which of the given samples is at position `at` of this object's order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return tree_.index(at); }
    [[nodiscard]] const geometry::CellGrid& grid() const noexcept { return grid_; }
    [[nodiscard]] const geometry::CellSet& kept() const noexcept { return kept_; }
    [[nodiscard]] const geometry::CellSet& ends() const noexcept { return ends_; }
    [[nodiscard]] std::int64_t samples() const noexcept { return tree_.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct NearSamples;

    // Calls visit(packed cell) for the cells of the grid in a cube, until it returns false. Returns false then, and if
    // there are too many cells.
    template <class Visit>
    [[nodiscard]] bool for_cells(const glm::dvec3& place, double half, Visit&& visit) const;
    void measure_spacing(const base::Work& work, double closest);
    // Returns the vector from a sample to a point, in widths of the sample's kernel.
    [[nodiscard]] glm::dvec3 scaled_offset(std::int64_t j, const glm::dvec3& place) const noexcept;
    [[nodiscard]] NearSamples find_near_samples(const glm::dvec3& place, const glm::dvec3& normal) const noexcept;

    geometry::PointTree tree_;
    geometry::VecArray normal_;     // in the tree's order, as the arrays below
    base::Array<double> spacing_;   // h
    base::Array<double> sharpness_; // 1 / r^2, r the width of the kernel
    double least_sharpness_ = 0.0;
    base::Array<std::uint8_t> surrounded_;
    geometry::CellGrid grid_;
    geometry::CellSet kept_, ends_; // where the surface continues, and where it may end, if limit_ > 0
    double limit_ = 0.0;
};

} // namespace hrbfnpr::surface
