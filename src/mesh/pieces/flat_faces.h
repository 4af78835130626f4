// SPDX-License-Identifier: MIT
// Flat regions of a mesh, of one face or many, that normals which are means over vertices would make bulge.
#pragma once

#include "mesh/pieces/creases.h"

namespace hrbfnpr::mesh {

class FlatFaces {
public:
    // mean: normals of corners.
    FlatFaces(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
              const base::Array<glm::dvec3>& mean, double tolerance);

    [[nodiscard]] bool any() const noexcept { return !area_.empty(); }
    // By more than the tolerance.
    [[nodiscard]] bool bulges(std::int32_t region) const noexcept { return bulge_[region] > tolerance_; }
    // How far the means make it bulge: the largest chord_error() of its faces.
    [[nodiscard]] double bulge(std::int32_t region) const noexcept { return bulge_[region]; }
    [[nodiscard]] std::int32_t region_of(std::int64_t face) const noexcept { return region_[face]; }
    [[nodiscard]] double area(std::int32_t region) const noexcept { return area_[region]; }
    [[nodiscard]] const glm::dvec3& normal(std::int32_t region) const noexcept { return normal_[region]; }
    // As it was given: several threads put the normals of flats in their place, and ask for those beside them.
    [[nodiscard]] const glm::dvec3& mean(std::int64_t corner) const noexcept { return mean_[corner]; }

private:
    void grow(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases);

    base::Array<std::int32_t> region_; // of faces
    base::Array<double> area_;         // of regions
    base::Array<glm::dvec3> normal_;
    base::Array<double> bulge_;
    base::Array<glm::dvec3> mean_;
    double tolerance_;
};

// Of the faces around a vertex.
class LargestFlat {
public:
    explicit LargestFlat(const FlatFaces& flats) noexcept : flats_(flats) {}
    void add(std::int64_t face) noexcept;
    // That would bulge, and is much larger than all others there; -1: there is none.
    [[nodiscard]] std::int32_t region() const noexcept;

private:
    const FlatFaces& flats_;
    std::int32_t largest_ = -1;
    double next_ = 0.0; // area of the second
};

} // namespace hrbfnpr::mesh
