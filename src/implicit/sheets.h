// SPDX-License-Identifier: MIT
// The smooth functions (sheets) that an implicit with creases is made of. A maximum or minimum of two functions is one
// of them on either side of the crease in which they meet.
#pragma once

#include "implicit/implicit.h"

#include <cmath>
#include <cstdint>

namespace hrbfnpr::implicit {

// Whether the minimum of a and b is b. If either is NaN, the minimum is NaN.
[[nodiscard]] inline bool takes_lower(double a, double b) noexcept { return b < a || std::isnan(b); }

class Sheets {
public:
    Sheets() = default;
    Sheets(const Sheets&) = delete;
    Sheets& operator=(const Sheets&) = delete;
    virtual ~Sheets() = default;

    [[nodiscard]] virtual std::int32_t count() const noexcept = 0;
    // Writes the index of the sheet that f is at each point, in [0, count()). Runs on the calling thread.
    virtual void active(const PointBatch& points, std::int32_t* sheet) const = 0;
    // Evaluates one sheet, also where f is another one. It is smooth, and signed as f is.
    virtual void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const = 0;
};

// One sheet as a separate implicit.
class OneSheet final : public Implicit {
public:
    // `sheets` belong to `whole`, which must outlive this.
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
