// SPDX-License-Identifier: MIT
#include "marks/crease_ends.h"

#include "surface/creased.h"
#include "surface/sheets_meet.h"

#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr double on_sheet = 1e-6; // diagonals

} // namespace

base::Array<std::uint8_t> find_crease_ends(const Site& site, const geometry::VecArray& position,
                                           geometry::VecArray& normal, double reach, const base::Progress& progress) {
    base::Array<std::int32_t> sheet = surface::sheets_at(site.runtime, site.implicit, position, progress);
    const implicit::Sheets* const sheets = site.implicit.sheets();
    base::Array<std::uint8_t> ends(site.memory(), sheet.size());
    if (sheets == nullptr) return ends;
    // Whether a place is on a sheet, to which it belongs then.
    const auto joins = [&](std::int64_t i, std::int32_t other) {
        const surface::SheetValue at = surface::sheet_at(*sheets, other, position[i]);
        const double slope = glm::length(at.gradient);
        if (!(std::abs(at.value) <= on_sheet * site.implicit.diagonal() * slope)) return false;
        normal.set(i, at.gradient / slope);
        sheet[i] = other;
        return true;
    };
    bool goes_on = false; // the place before does, from one before that
    for (std::int64_t i = 1; i < position.size(); ++i) {
        if (i % chunk_size == 0) progress.check();
        const bool beside = glm::distance(position[i - 1], position[i]) <= reach;
        const bool creased = beside && surface::is_creased(sheet[i - 1], sheet[i], normal[i - 1], normal[i]);
        ends[i] = creased && !joins(i, sheet[i - 1]) && (goes_on || !joins(i - 1, sheet[i])) ? 1 : 0;
        goes_on = beside && ends[i] == 0;
    }
    return ends;
}

} // namespace hrbfnpr::marks
