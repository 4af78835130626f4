// SPDX-License-Identifier: MIT
// An HRBF whose evaluation hardly depends on the number of its centres: with the local field of local_field.h near the
// surface, and all centres elsewhere.
#pragma once

#include "implicit/hrbf.h"
#include "implicit/local_field.h"

#include <memory>

namespace hrbfnpr::implicit {

class Prepared final : public Implicit {
public:
    // What the sums are off by at most, measured beside the centres: f in diagonals, its gradient.
    struct Error {
        double value = 0.0;
        double gradient = 0.0;
    };

    // Null where it is not for this kind of function, or would not be accurate: weights that contradict each other.
    // The data must outlive it.  Of the options, the spacing is the data's.
    [[nodiscard]] static std::unique_ptr<Prepared> make(const base::Work& work, const HrbfData& data,
                                                        const LocalFieldOptions& options = {});
    // Whether for so many points preparing takes less time than it saves.
    [[nodiscard]] static bool pays(const HrbfData& data, double points) noexcept;

    Prepared(const base::Work& work, const HrbfData& data, const LocalFieldOptions& options);

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data_.bounds; }
    [[nodiscard]] std::int64_t cells() const noexcept override { return field_.cubes() + 1; }
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& point) const noexcept override;

    [[nodiscard]] Error error() const noexcept { return error_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return field_.bytes(); }

private:
    void evaluate_cell(std::int32_t cell, const PointBatch& points, const FieldBatch& fields) const noexcept;
    void measure_error(const base::Work& work);

    base::InstructionSet set_;
    const HrbfData& data_;
    LocalField field_;
    Error error_;
};

} // namespace hrbfnpr::implicit
