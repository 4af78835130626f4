// SPDX-License-Identifier: MIT
// A fit that is under way, as an implicit, and what is said of it in the end.
#pragma once

#include "fit/distance.h"
#include "fit/fit_centres.h"
#include "mesh/fit/fit_mesh.h"

#include <memory>

namespace hrbfnpr::mesh {

// The data must outlive it.
class FitData final : public implicit::Implicit {
public:
    FitData(base::InstructionSet set, const implicit::HrbfData& data) noexcept : set_(set), data_(data) {}

    void evaluate(const implicit::PointBatch& points, const implicit::FieldBatch& fields) const override {
        implicit::evaluate(set_, data_, points, fields);
    }
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data_.bounds; }

private:
    base::InstructionSet set_;
    const implicit::HrbfData& data_;
};

// The data at many places, as near as a search for what is off needs.
class FitField {
public:
    // precision: in diagonals.  The data must outlive it.
    FitField(base::InstructionSet set, const implicit::HrbfData& data, double precision) noexcept
        : data_(data), plain_(set, data), precision_(precision) {}

    // Before it is asked at so many places: prepares for that, where it takes less time.
    void expect(const base::Runtime& runtime, std::int64_t places, const base::Progress& progress);

    [[nodiscard]] const implicit::Implicit& operator*() const noexcept {
        if (prepared_ != nullptr) return *prepared_;
        return plain_;
    }

private:
    const implicit::HrbfData& data_;
    FitData plain_;
    double precision_;
    std::unique_ptr<implicit::Implicit> prepared_;
};

// The root of the mean square, unit: a length, so that squares of small ones do not underflow.
[[nodiscard]] double root_mean_square(const base::Array<double>& distance, double unit) noexcept;

// Fills in the fit's report, but for the candidates' distances. `chosen` are the centres of the fit.
void describe(const base::Runtime& runtime, const fit::Samples& chosen, const FitMeshReport& report,
              fit::CentreFit& fit, const base::Progress& progress);

} // namespace hrbfnpr::mesh
