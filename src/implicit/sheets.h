// SPDX-License-Identifier: MIT
// The smooth functions (sheets) of an implicit function with creases. The maximum or minimum of two functions equals
// one function on one side of the crease where they meet, and the other function on the other side.
#pragma once

#include "implicit/implicit.h"

#include <cmath>
#include <cstdint>

namespace hrbfnpr::implicit {

// Returns whether the minimum of a and b is b. The minimum is NaN if either is NaN.
[[nodiscard]] inline bool takes_lower(double a, double b) noexcept { return b < a || std::isnan(b); }

class Sheets {
public:
    Sheets() = default;
    Sheets(const Sheets&) = delete;
    Sheets& operator=(const Sheets&) = delete;
    virtual ~Sheets() = default;

    [[nodiscard]] virtual std::int32_t count() const noexcept = 0;
    // Writes, for each point, the index in [0, count()) of the sheet that f equals there. Runs on the calling thread.
    virtual void active(const PointBatch& points, std::int32_t* sheet) const = 0;
    // Evaluates one sheet at any points, even where f equals another sheet. A sheet is smooth and has the sign
    // convention of f.
    virtual void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const = 0;
};

// One sheet as a separate implicit.
class OneSheet final : public Implicit {
public:
    // `sheets` belong to `whole`. The object keeps references to both.
    OneSheet(const Implicit& whole, const Sheets& sheets, std::int32_t sheet) noexcept
        : whole_(whole), sheets_(sheets), sheet_(sheet) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override {
        sheets_.evaluate(sheet_, points, fields);
    }
    [[nodiscard]] bool concurrent() const noexcept override { return whole_.concurrent(); }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return whole_.bounds(); }
    [[nodiscard]] std::int32_t sheet() const noexcept { return sheet_; }

private:
    const Implicit& whole_;
    const Sheets& sheets_;
    std::int32_t sheet_;
};

} // namespace hrbfnpr::implicit
