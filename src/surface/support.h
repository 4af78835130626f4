// SPDX-License-Identifier: MIT
// How well the samples of a surface bear out a place of it: the surface of an implicit goes on where they end, and
// what lies there is an invention.
//
//   s(x) = 3 (|c|^2 - ln sum_j w_j),   w_j = exp(-|q_j|^2) ((1 + n_j . m) / 2)^2,   q_j = (x - p_j) / (0.9 h_j)
//
// over the samples p_j nearest to x, n_j their normals, h_j the spacing around each, m the unit normal at x, and
// c = sum_j w_j q_j / sum_j w_j: how far x is from the middle of its neighbours (Adamson and Alexa 2004), which does
// not go by how many there happen to be.  s is near -4.7 among samples, and grows away from them and where they face
// another way.
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

    // s at a place with a normal, and how it changes with both.
    struct Answer {
        double value;         // infinite where no sample is near or faces the same way
        glm::dvec3 by_place;  // its gradient for a normal that stays as it is
        glm::dvec3 by_normal; // by the normal, perpendicular to it
    };

    // position and normal (unit) of the same samples, one or more.  No spacing is taken to be less than the closest:
    // what a dense sample of a shape shall bear out is as near to it as that, and not as its samples to each other.
    Support(const base::Work& work, const geometry::VecArray& position, const geometry::VecArray& normal,
            double closest);

    // From here on s is below `limit` in the cells that are kept: holes that shall stay closed are.  ends: those that
    // the surface may end in, of all that it is known to pass.
    void keep(const geometry::CellGrid& grid, geometry::CellSet kept, geometry::CellSet ends, double limit);
    [[nodiscard]] bool may_end_at(const glm::dvec3& place) const noexcept {
        return !(limit_ > 0.0) || !kept_.contains(geometry::CellGrid::pack(grid_.cell_of(place)));
    }
    [[nodiscard]] bool has_kept() const noexcept { return limit_ > 0.0; }
    // Whether it may end in a cube around the place.
    [[nodiscard]] bool may_end_near(const glm::dvec3& place, double half) const noexcept;

    // On the calling thread; const, for any number of threads.
    [[nodiscard]] double value(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept;
    [[nodiscard]] Answer evaluate(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept;
    // At many places, by grad f there, which need not be unit; value: resized.  The same bits for any thread count.
    void evaluate_all(const base::Work& work, const geometry::VecArray& place, const geometry::VecArray& gradient,
                      base::Array<double>& value) const;

    // How far it is to the nearest sample, the spacing there, and whether others surround it (surface/surrounded.h).
    struct Nearest {
        double distance, spacing;
        bool surrounded;
    };
    [[nodiscard]] Nearest nearest_sample(const glm::dvec3& place) const noexcept;
    [[nodiscard]] double median_spacing() const;
    // Whether in all of a cube around the place s is above `limit` for any normal, and the surface may end: then there
    // is none of it.  False where that is not certain.
    [[nodiscard]] bool has_nothing_near(const glm::dvec3& place, double half, double limit) const noexcept;
    // Whether they stand along curves, with nothing between these.
    [[nodiscard]] bool along_curves() const { return geometry::along_curves(tree_); }
    // Those that are not surrounded.
    [[nodiscard]] geometry::VecArray not_surrounded() const;

    // Of the samples, in an order of its own.
    [[nodiscard]] const geometry::VecArray& positions() const noexcept { return tree_.points(); }
    [[nodiscard]] const geometry::VecArray& normals() const noexcept { return normal_; }
    // Which of the given samples stands at place `at` of that order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return tree_.index(at); }
    [[nodiscard]] const geometry::CellGrid& grid() const noexcept { return grid_; }
    [[nodiscard]] const geometry::CellSet& kept() const noexcept { return kept_; }
    [[nodiscard]] const geometry::CellSet& ends() const noexcept { return ends_; }
    [[nodiscard]] std::int64_t samples() const noexcept { return tree_.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct Near;

    // visit(packed cell) for the cells of the grid in a cube, until it returns false; false where they are many.
    template <class Visit>
    [[nodiscard]] bool for_cells(const glm::dvec3& place, double half, Visit&& visit) const;
    void measure_spacing(const base::Work& work, double closest);
    // From a sample to a place, in widths of its kernel.
    [[nodiscard]] glm::dvec3 away(std::int64_t j, const glm::dvec3& place) const noexcept;
    [[nodiscard]] Near look(const glm::dvec3& place, const glm::dvec3& normal) const noexcept;

    geometry::PointTree tree_;
    geometry::VecArray normal_;     // in the tree's order, as the next
    base::Array<double> spacing_;   // h
    base::Array<double> sharpness_; // 1 / r^2, r the width of the kernel
    double least_sharpness_ = 0.0;
    base::Array<std::uint8_t> surrounded_;
    geometry::CellGrid grid_;
    geometry::CellSet kept_, ends_; // where it goes on, and where it may end, if there is a limit
    double limit_ = 0.0;
};

} // namespace hrbfnpr::surface
