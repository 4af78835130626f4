// SPDX-License-Identifier: MIT
// Which way given directions point, by the energy: clusters that grow along its strongest couplings, and are turned
// where that lowers it.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "fit/hermite_energy.h"

#include <array>
#include <vector>

namespace hrbfnpr::orient {

using Signs = base::Array<std::int8_t>; // 1 or -1 of each place

// Clusters of places, from fine to coarse.
struct Levels {
    std::vector<base::Array<std::int32_t>> cluster; // of each place: the place it is named for
};

class SignEnergy {
public:
    // normal: what terms were made of, in the energy that outlives this.
    SignEnergy(const base::Runtime& runtime, const fit::HermiteEnergy& energy, const geometry::VecArray& normal);

    [[nodiscard]] double of(const Signs& signs) const;

    // Places join, two clusters at a time that are each other's nearest by |coupling| / sqrt(self energies), with the
    // sign that lowers the energy; the couplings of what has joined are added up.  first: clusters to begin with (of
    // equal names), and the signs in them; may be null.
    [[nodiscard]] Signs agglomerate(const base::Array<std::int32_t>* first, const Signs* signs, Levels& levels,
                                    const base::Progress& progress) const;

    // Turns clusters, from coarse to fine, and single places wherever that lowers the energy.  Returns how many places
    // were turned.
    std::int64_t improve(const Levels& levels, Signs& signs, const base::Progress& progress) const;

    // Turns each of these sets of places if that raises the energy by less than `most` of what the set has alone.
    // Returns whether each was turned.
    [[nodiscard]] std::vector<bool> turn(const std::vector<std::vector<std::int32_t>>& sets, double most,
                                         Signs& signs) const;

private:
    class Agglomeration;
    class Turning;
    using Four = std::array<double, 4>;

    [[nodiscard]] Four part(std::int64_t element, const Signs& signs) const noexcept {
        const float* a = terms_.add.data() + 4 * element;
        const auto s = static_cast<float>(signs[terms_.blocks.set[element]]);
        return {double{s * a[0]}, double{s * a[1]}, double{s * a[2]}, double{s * a[3]}};
    }

    const base::Runtime& runtime_;
    fit::HermiteEnergy::Terms terms_;
    std::int64_t size_;
};

} // namespace hrbfnpr::orient
