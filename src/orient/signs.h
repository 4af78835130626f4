// SPDX-License-Identifier: MIT
// The solver of signs: which of each direction's two ways it points, by the energy of all of them together.
//
// Places join into clusters along the strongest couplings of the energy; then clusters, from coarse to fine, and single
// places are turned wherever that lowers the energy.
#pragma once

#include "base/runtime.h"
#include "fit/hermite_energy.h"
#include "orient/cloud.h"

#include <array>
#include <vector>

namespace hrbfnpr::orient {

using Signs = base::Array<std::int8_t>; // 1 or -1 for each place

[[nodiscard]] Signs all_positive(base::Memory& memory, std::int64_t size);
void turn(const Signs& signs, geometry::VecArray& normal) noexcept;

// The clusters of places, from fine to coarse: a cluster is named for its first place.
using Levels = std::vector<base::Array<std::int32_t>>;

class SignEnergy {
public:
    // normal: the directions, in the energy that outlives this.
    SignEnergy(const base::Runtime& runtime, const fit::HermiteEnergy& energy, const geometry::VecArray& normal,
               const base::Progress& progress = {});

    [[nodiscard]] double of(const Signs& signs, const base::Progress& progress = {}) const;

    // Joins places, two clusters at a time that are each other's nearest by |coupling| / sqrt(self energies), with the
    // sign that lowers the energy; the couplings of joined clusters add up. The first level, if there is one, holds
    // the clusters to begin with, and `signs` the signs in them.
    void agglomerate(Levels& levels, Signs& signs, const base::Progress& progress) const;

    // Turns clusters, from coarse to fine, and single places wherever that lowers the energy. Returns the number of
    // places that were turned.
    std::int64_t improve(const Levels& levels, Signs& signs, const base::Progress& progress) const;

    // Turns each of these groups if that raises the energy by less than `most` of the group's own.
    // Returns 1 for each that was turned.
    [[nodiscard]] base::Array<std::uint8_t> turn(const Groups& groups, double most, Signs& signs) const;

private:
    class Agglomeration;
    class Turning;
    using Four = std::array<double, 4>;

    [[nodiscard]] Four part(std::int64_t element, const Signs& signs) const noexcept {
        const float* a = terms_.add.data() + 4 * element;
        const auto s = static_cast<float>(signs[terms_.blocks.set[element]]);
        return {double{s * a[0]}, double{s * a[1]}, double{s * a[2]}, double{s * a[3]}};
    }
    // Calls visit(element) for the elements of a term.
    template <class Visit>
    void for_elements(std::int64_t term, Visit&& visit) const {
        const std::int64_t size = terms_.blocks.set_size;
        for (std::int64_t e = term * size; e < (term + 1) * size; ++e) visit(e);
    }
    // What a sample of the dense term adds to it, with the sign +1.
    [[nodiscard]] const double* dense_part(std::int64_t sample) const noexcept {
        return terms_.coarse_add.data() + sample * terms_.blocks.coarse_columns;
    }

    const base::Runtime& runtime_;
    fit::HermiteEnergy::Terms terms_;
    std::int64_t size_;
    base::Array<std::int64_t> dense_; // of each place: 1 + its number in the dense term, or 0
};

// Returns signs of least energy for these directions, and whether any was turned relative to the others. `levels` keeps
// the clusters; a large cloud begins with patches of neighbours, and reuses the clusters that are there.
bool find_signs(const base::Runtime& runtime, const Places& places, const Near& near, const fit::HermiteEnergy& energy,
                Levels& levels, geometry::VecArray& normal, const base::Progress& progress);

} // namespace hrbfnpr::orient
