// SPDX-License-Identifier: MIT
// Judges given normals by comparing them with the normals of least energy.
#pragma once

#include "base/view.h"
#include "orient/signs.h"

namespace hrbfnpr::orient {

// The values equal the HRBFNPR_NORMALS_ constants of hrbfnpr.h.
enum class NormalMode : std::uint32_t { given = 0, none = 1, unoriented = 2, mixed = 3, inward = 4, automatic = 5 };

struct GivenNormals {
    explicit GivenNormals(base::Memory& memory) noexcept : normal(memory), known(memory) {}

    // For each place: the first given normal, normalized, or any direction if no normal is given.
    geometry::VecArray normal;
    base::Array<std::uint8_t> known; // for each place: 1 if a normal is given
    std::int64_t known_count = 0;
};

[[nodiscard]] glm::dvec3 given_normal(const base::InView& normals, std::int64_t point) noexcept;

// Throws Error{invalid_argument} that names "normals" and the index of the first normal that is not finite.
[[nodiscard]] GivenNormals read_given(const base::Work& work, const base::InView& normals, const Cloud& cloud,
                                      const NeighbourLists& near);

// The evidence by which given normals are judged.
struct Evidence {
    const geometry::VecArray& least_energy_normals; // normals of least energy, outward
    // Winding numbers do not show which side is outside, so a rule chooses it.
    bool open = false;
    // The confidence of `least_energy_normals` is low, so given normals are kept if the judgement is in doubt.
    bool doubtful = false;
};

struct Judgement {
    explicit Judgement(base::Memory& memory) noexcept : signs(memory), replaced(memory) {}

    NormalMode found = NormalMode::none;
    Signs signs;                // for each place: -1 if its given normals must be turned
    double made_sign = 1.0;     // the sign that turns the normals of least energy where no normal is given
    bool follows_given = false; // The given normals decide which side of the surface is outward.
    // All given normals of a place are turned to agree with the first given normal of the place.
    bool by_place = false;
    // For each place: 1 if its given normals are replaced by the normal of least energy. Empty if none is.
    base::Array<std::uint8_t> replaced;
};

[[nodiscard]] Judgement judge(const base::Work& work, const Cloud& cloud, const NeighbourLists& near,
                              const GivenNormals& given, const Evidence& evidence, NormalMode mode);

} // namespace hrbfnpr::orient
