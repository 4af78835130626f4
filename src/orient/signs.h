// SPDX-License-Identifier: MIT
// Which way given directions point, by the energy: clusters that grow along its strongest couplings, and are turned
// where that lowers it.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "fit/hermite_energy.h"

#include <array>
#include <span>
#include <vector>

namespace hrbfnpr::orient {

using Signs = base::Array<std::int8_t>; // 1 or -1 of each place

// Clusters of places, from fine to coarse.
struct Levels {
    std::vector<base::Array<std::int32_t>> cluster; // of each place: the place it is named for
};

// Sets of places, one after the other.
struct Groups {
    explicit Groups(base::Memory& memory) : member(memory), begin(memory) { begin.push_back(0); }

    [[nodiscard]] std::int64_t size() const noexcept { return begin.size() - 1; }
    [[nodiscard]] std::span<const std::int32_t> of(std::int64_t k) const noexcept {
        return member.span().subspan(static_cast<std::size_t>(begin[k]),
                                     static_cast<std::size_t>(begin[k + 1] - begin[k]));
    }
    // Ends a group that members have been added for.
    void close() { begin.push_back(member.size()); }

    base::Array<std::int32_t> member;
    base::Array<std::int64_t> begin;
};

class SignEnergy {
public:
    // normal: what terms were made of, in the energy that outlives this.
    SignEnergy(const base::Runtime& runtime, const fit::HermiteEnergy& energy, const geometry::VecArray& normal,
               const base::Progress& progress = {});

    [[nodiscard]] double of(const Signs& signs, const base::Progress& progress = {}) const;

    // Places join, two clusters at a time that are each other's nearest by |coupling| / sqrt(self energies), with the
    // sign that lowers the energy; the couplings of what has joined are added up.  first: clusters to begin with (of
    // equal names), and the signs in them; may be null.
    [[nodiscard]] Signs agglomerate(const base::Array<std::int32_t>* first, const Signs* signs, Levels& levels,
                                    const base::Progress& progress) const;

    // Turns clusters, from coarse to fine, and single places wherever that lowers the energy.  Returns how many places
    // were turned.
    std::int64_t improve(const Levels& levels, Signs& signs, const base::Progress& progress) const;

    // Turns each of these groups if that raises the energy by less than `most` of what the group has alone.
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

    const base::Runtime& runtime_;
    fit::HermiteEnergy::Terms terms_;
    std::int64_t size_;
};

} // namespace hrbfnpr::orient
