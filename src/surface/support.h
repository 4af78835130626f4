// SPDX-License-Identifier: MIT
// Support: how well the samples around a point of the surface confirm it. The zero set of an implicit function
// continues beyond its samples, where no data confirm it.
//
//   s(x) = 3 (|c|^2 - ln sum_j w_j),   w_j = exp(-|q_j|^2) ((1 + n_j . m) / 2)^2,   q_j = (x - p_j) / (0.9 h_j)
//
// The sums are over the samples p_j nearest to x. n_j are their normals, and h_j is the spacing around each. m is the
// unit normal at x, and c = sum_j w_j q_j / sum_j w_j. c tells how far x is from the middle of its neighbours (Adamson
// and Alexa 2004), whatever their number is. s is about -4.7 among samples. It grows with the distance from samples,
// and where they face another way.
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

    // The value of s at a point with a normal, and its derivatives with respect to both.
    struct ValueAndDerivatives {
        double value;               // infinite if no sample near the point faces the same way
        glm::dvec3 place_gradient;  // the gradient of s for a fixed normal
        glm::dvec3 normal_gradient; // the derivative of s with respect to the normal; it is perpendicular to the normal
    };

    // `position` and `normal` (unit) are those of one or more samples. Spacings below `closest` are raised to
    // `closest`. It is the accuracy of the shape: samples that are denser than this support all places within this
    // distance.
    Support(const base::Work& work, const geometry::VecArray& position, const geometry::VecArray& normal,
            double closest);

    // From now on, keeps s below `limit` in the `kept` cells, so that holes there stay closed. Of the cells that the
    // surface is known to pass, `ends` are those in which it may end.
    void keep(const geometry::CellGrid& grid, geometry::CellSet kept, geometry::CellSet ends, double limit);
    [[nodiscard]] bool may_end_at(const glm::dvec3& place) const noexcept {
        return !(limit_ > 0.0) || !kept_.contains(geometry::CellGrid::pack(grid_.cell_of(place)));
    }
    // Returns whether s is certainly below `limit` at a place, whatever the samples are.
    [[nodiscard]] bool continues_at(const glm::dvec3& place, double limit) const noexcept {
        return limit_ > 0.0 && limit_ <= limit && !may_end_at(place);
    }
    [[nodiscard]] bool has_kept() const noexcept { return limit_ > 0.0; }
    // Returns whether the surface may end in a cube, given by its centre and half its side.
    [[nodiscard]] bool may_end_near(const glm::dvec3& place, double half) const noexcept;

    // These functions run on the calling thread, and are thread-safe.
    [[nodiscard]] double value(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept;
    [[nodiscard]] ValueAndDerivatives evaluate(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept;
    // Computes s at many points. `gradient` is grad f there, of any length. Resizes `value`. The result has the same
    // bits for any number of threads.
    void evaluate_all(const base::Work& work, const geometry::VecArray& place, const geometry::VecArray& gradient,
                      base::Array<double>& value) const;

    // The distance to the nearest sample, the sample's spacing, and whether other samples surround it
    // (surface/surrounded.h).
    struct Nearest {
        double distance, spacing;
        bool surrounded;
    };
    [[nodiscard]] Nearest nearest_sample(const glm::dvec3& place) const noexcept;
    [[nodiscard]] double median_spacing() const;
    // Returns true only if a cube certainly contains no surface: s is above `limit` in the whole cube for every normal,
    // and no cell is kept.
    [[nodiscard]] bool has_nothing_near(const glm::dvec3& place, double half, double limit) const noexcept;
    // Returns whether the samples lie along curves with gaps between the curves.
    [[nodiscard]] bool samples_lie_along_curves() const { return geometry::lie_along_curves(tree_); }
    [[nodiscard]] geometry::VecArray samples_not_surrounded() const;

    // The positions and normals of the samples, in the order of the tree.
    [[nodiscard]] const geometry::VecArray& positions() const noexcept { return tree_.points(); }
    [[nodiscard]] const geometry::VecArray& normals() const noexcept { return normal_; }
    // Returns the original index of the sample at position `at` of the tree's order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return tree_.index(at); }
    [[nodiscard]] const geometry::CellGrid& grid() const noexcept { return grid_; }
    [[nodiscard]] const geometry::CellSet& kept() const noexcept { return kept_; }
    [[nodiscard]] const geometry::CellSet& ends() const noexcept { return ends_; }
    [[nodiscard]] std::int64_t samples() const noexcept { return tree_.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct NearSamples;

    // Calls visit(packed cell) for the cells of the grid in a cube, until it returns false. Returns false if visit()
    // did, or if there are too many cells.
    template <class Visit>
    [[nodiscard]] bool for_cells(const glm::dvec3& place, double half, Visit&& visit) const;
    void measure_spacing(const base::Work& work, double closest);
    // Returns the vector from a sample to a point, in units of the width of the sample's kernel.
    [[nodiscard]] glm::dvec3 scaled_offset(std::int64_t j, const glm::dvec3& place) const noexcept;
    [[nodiscard]] NearSamples find_near_samples(const glm::dvec3& place, const glm::dvec3& normal) const noexcept;

    geometry::PointTree tree_;
    geometry::VecArray normal_;     // in the tree's order, like the arrays below
    base::Array<double> spacing_;   // the spacing h around each sample
    base::Array<double> sharpness_; // 1 / r^2, where r is the width of the kernel
    double least_sharpness_ = 0.0;
    base::Array<std::uint8_t> surrounded_;
    geometry::CellGrid grid_;
    geometry::CellSet kept_, ends_; // where the surface continues and where it may end; used if limit_ > 0
    double limit_ = 0.0;
};

} // namespace hrbfnpr::surface
