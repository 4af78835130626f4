// SPDX-License-Identifier: MIT
// One sheet of an implicit as an implicit: smooth, and the same surface where the sheet is active.
#pragma once

#include "implicit/sheets.h"

namespace hrbfnpr::implicit {

class OneSheet final : public Implicit {
public:
    // `sheets` are those of `whole`, which lives as long as this.
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
