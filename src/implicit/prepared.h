// SPDX-License-Identifier: MIT
// An HRBF whose evaluation time hardly depends on the number of its centres. Near the surface it uses the local field
// of local_field.h; elsewhere it sums all centres.
#pragma once

#include "implicit/hrbf.h"
#include "implicit/local_field.h"

#include <memory>

namespace hrbfnpr::implicit {

class Prepared final : public Implicit {
public:
    // The largest errors of the sums near the centres: of f, in diagonals, and of the gradient.
    struct Error {
        double value = 0.0;
        double gradient = 0.0;
    };

    // Returns null if there is no local field for this kernel, or if it would be inaccurate because weights contradict
    // each other. The data must outlive the result. options.spacing is ignored; the spacing comes from the data.
    [[nodiscard]] static std::unique_ptr<Prepared> make(const base::Work& work, const HrbfData& data,
                                                        const LocalFieldOptions& options = {});
    // Returns whether preparation takes less time than it saves for this number of points.
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
