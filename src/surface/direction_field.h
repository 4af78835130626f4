// SPDX-License-Identifier: MIT
// A smooth field of directions on a surface that is known by samples.
// [Hertzmann & Zorin 2000, 5.1; Knoeppel et al. 2013]
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/point_grid.h"
#include "geometry/vec_array.h"
#include "surface/creased.h"

namespace hrbfnpr::surface {

// A line has no sign; a cross is not even told from itself turned by 90 degrees.
enum class Symmetry : std::uint32_t { line = 2, cross = 4 };

// The samples that a field is made of.  Every prefix of their order is spread evenly.
struct FieldSamples {
    const geometry::VecArray& position;
    const geometry::VecArray& normal;    // unit
    const geometry::VecArray& direction; // unit, tangent: as measured
    const base::Array<double>& trust;    // in [0, 1]: of the measured direction
    double spacing;                      // sqrt(area per sample)
    // How much a fully trusted direction counts against all neighbours together: the smaller, the smoother.
    double fidelity = 1.0;
    // Of surface/creased.h, for each sample: creases are borders, over which nothing is smoothed.  Null: there are
    // none.
    const base::Array<std::int32_t>* sheet = nullptr;

    [[nodiscard]] bool are_creased(std::int64_t i, std::int64_t j) const noexcept {
        return sheet != nullptr && !sheet->empty() && is_creased((*sheet)[i], (*sheet)[j], normal[i], normal[j]);
    }
};

// Trusted samples keep their measured directions, and the others take the smoothest field between them.
class DirectionField {
public:
    DirectionField(const base::Runtime& runtime, const FieldSamples& samples, Symmetry symmetry,
                   const base::Progress& progress);

    // What the samples around a point near the surface tell.
    struct Local {
        glm::dvec3 normal{0.0};
        glm::dvec3 direction{0.0}; // unit, tangent
        double height = 0.0;       // of the point over the surface
        double agreement = 0.0;    // of the samples' directions: 1 = all alike, lower at singular points
        double distance = 0.0;     // to the nearest sample
        std::int64_t sample = -1;  // the nearest one; -1: there is none, and nothing else is told
    };
    // On the side that `normal` (unit) points to.  Of the field's directions the one nearest to `along`, which
    // need not be tangent; turned: the lines across those of a line field.  Of a surface with creases: on the sheet of
    // the nearest sample, and nothing beyond the crease there.
    [[nodiscard]] Local at(const glm::dvec3& p, const glm::dvec3& normal, const glm::dvec3& along,
                           bool turned) const noexcept;

    [[nodiscard]] std::int64_t size() const noexcept { return sample_.size(); }
    [[nodiscard]] Symmetry symmetry() const noexcept { return symmetry_; }
    [[nodiscard]] double spacing() const noexcept { return spacing_; }
    // Of sample i in the given order.
    [[nodiscard]] const glm::dvec3& position(std::int64_t i) const noexcept { return sample_[place_[i]].position; }
    [[nodiscard]] const glm::dvec3& normal(std::int64_t i) const noexcept { return sample_[place_[i]].normal; }
    [[nodiscard]] const glm::dvec3& direction(std::int64_t i) const noexcept { return sample_[place_[i]].first; }

private:
    struct Sample {
        glm::dvec3 position, normal;
        glm::dvec3 first, second; // second = normal x first
        std::int64_t index;
        std::int32_t sheet;
    };

    [[nodiscard]] const Sample* sheet_at(const glm::dvec3& p, const glm::dvec3& normal) const noexcept;
    [[nodiscard]] glm::dvec3 aligned(const Sample& sample, const glm::dvec3& along, bool turned) const noexcept;

    Symmetry symmetry_;
    double spacing_;
    double radius_; // of the samples' influence
    geometry::PointGrid grid_;
    base::Array<Sample> sample_;      // in the grid's order
    base::Array<std::int64_t> place_; // of sample i in it
    bool creased_;
};

} // namespace hrbfnpr::surface
