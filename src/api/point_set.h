// SPDX-License-Identifier: MIT
// The handle of a point set.
#pragma once

#include "api/handles.h"
#include "marks/point_set.h"

struct hrbfnpr_point_set : hrbfnpr::api::Child {
    hrbfnpr_point_set(hrbfnpr_context& context, hrbfnpr::marks::PointSet&& marks) noexcept
        : Child(context), set(std::move(marks)) {}
    // Makes a set that shares the marks of another.
    hrbfnpr_point_set(hrbfnpr_context& context, hrbfnpr::marks::PointSet&& marks,
                      const hrbfnpr_point_set& owner) noexcept
        : Child(context), set(std::move(marks)), owner_(&owner.owner()) {
        owner_->add_reference();
    }
    ~hrbfnpr_point_set();

    // The set that owns the marks.
    [[nodiscard]] const hrbfnpr_point_set& owner() const noexcept { return owner_ != nullptr ? *owner_ : *this; }
    [[nodiscard]] bool has_marks_of(const hrbfnpr_point_set& other) const noexcept {
        return &owner() == &other.owner();
    }

    const hrbfnpr::marks::PointSet set;

private:
    const hrbfnpr_point_set* owner_ = nullptr; // null if this set owns its marks
};

namespace hrbfnpr::api {

// Returns a layer of a set. Throws Error{invalid_argument} if there is none of this number.
[[nodiscard]] const marks::Layer& layer_of(const marks::PointSet& set, std::int64_t layer);

// Prepares a new set for frames, and makes a handle of it.
[[nodiscard]] hrbfnpr_point_set* adopt(hrbfnpr_context& context, marks::PointSet&& set);

} // namespace hrbfnpr::api
