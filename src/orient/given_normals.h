// SPDX-License-Identifier: MIT
// Judges given normals by those of least energy.
#pragma once

#include "base/view.h"
#include "orient/signs.h"

namespace hrbfnpr::orient {

// The values equal those of the constants HRBFNPR_NORMALS_ of hrbfnpr.h.
enum class NormalMode : std::uint32_t { given = 0, none = 1, unoriented = 2, mixed = 3, inward = 4, automatic = 5 };

struct GivenNormals {
    explicit GivenNormals(base::Memory& memory) noexcept : normal(memory), known(memory) {}

    geometry::VecArray normal;       // of each place: the first that is given there, made unit, or some direction
    base::Array<std::uint8_t> known; // 1 where one is given
    std::int64_t known_count = 0;
};

[[nodiscard]] glm::dvec3 given_normal(const base::InView& normals, std::int64_t point) noexcept;

// Throws Error{invalid_argument} naming "normals" and the index of one that is not finite.
[[nodiscard]] GivenNormals read_given(const base::Work& work, const base::InView& normals, const Cloud& cloud,
                                      const Near& near);

// The evidence that given normals are judged by.
struct Evidence {
    const geometry::VecArray& least; // normals of least energy, outward
    bool open = false;               // a rule only says what is outward
    bool doubtful = false;           // its confidence is low: in doubt given normals stay
};

struct Judgement {
    explicit Judgement(base::Memory& memory) noexcept : signs(memory) {}

    NormalMode found = NormalMode::none;
    Signs signs;                // -1: the given normals of this place are to be turned
    double made_sign = 1.0;     // of those that are made in place of missing ones
    bool follows_given = false; // the given normals say which side is outward
    bool by_place = false;      // all normals of a place are turned to agree with its first
};

[[nodiscard]] Judgement judge(const base::Work& work, const Cloud& cloud, const Near& near, const GivenNormals& given,
                              const Evidence& evidence, NormalMode mode);

} // namespace hrbfnpr::orient
