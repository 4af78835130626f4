// SPDX-License-Identifier: MIT
// What given normals are worth, held against those of least energy.
#pragma once

#include "orient/cloud.h"
#include "orient/orient.h"

namespace hrbfnpr::orient {

struct Judgement {
    explicit Judgement(base::Memory& memory) noexcept : signs(memory) {}

    NormalMode found = NormalMode::given;
    Signs signs;                // -1: the given normals of this place are to be turned
    double made_sign = 1.0;     // of those that are made in place of missing ones
    bool follows_given = false; // which side is outward
    bool by_place = false;      // a place's given normals are turned to agree with its first
};

// What given normals are held against.
struct Evidence {
    const geometry::VecArray& least; // normals of least energy, outward
    const fit::HermiteEnergy* form;  // their energy, or null
    bool open = false;               // outward is by a rule only
    bool doubtful = false;           // of low confidence: in doubt given normals stay
};

class GivenNormals {
public:
    // Throws Error{invalid_argument} naming "normals" and the index.
    GivenNormals(const base::Runtime& runtime, const base::InView& normals, const Cloud& cloud, const Near& near,
                 bool used, const base::Progress& progress);

    // Of each place: the first that is given there, made unit; where none is, some direction.
    [[nodiscard]] const geometry::VecArray& normal() const noexcept { return normal_; }
    // As given.
    [[nodiscard]] glm::dvec3 of(std::int64_t point) const noexcept;

    [[nodiscard]] Judgement judge(const Evidence& evidence, NormalMode mode, const base::Progress& progress) const;

private:
    [[nodiscard]] bool are_inward(double alike, bool doubtful, const base::Progress& progress) const;
    struct Likeness {
        double same_sign = 0.0; // share
        double far = 0.0;       // share with a cosine below 0.5
        double median = 0.0;    // of cosines of the angle between lines
    };
    [[nodiscard]] Likeness compare(const geometry::VecArray& least) const;
    void follow_most(const Evidence& evidence, bool inward, bool may_differ, Judgement& judgement) const;
    [[nodiscard]] bool are_tossed(const Evidence& evidence) const;
    [[nodiscard]] Groups patches_against(const Evidence& evidence, const Signs& signs) const;
    void repair(const Evidence& evidence, Signs& signs) const;

    const base::Runtime& runtime_;
    base::InView given_;
    const geometry::PointTree& tree_;
    const Near& near_;
    geometry::VecArray normal_;
    base::Array<std::uint8_t> known_;
    std::int64_t known_count_ = 0;
};

} // namespace hrbfnpr::orient
