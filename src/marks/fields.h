// SPDX-License-Identifier: MIT
// Sets that share their marks, and the fields of a set.
#pragma once

#include "marks/point_set.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::marks {

// Copies the values of a field.
[[nodiscard]] MarkField copy_of(const MarkField& field, base::Memory& memory);

// Returns a set with the marks of another, which must outlive it. The arrays of marks are shared. The values of fields
// are copied, except those of fields whose names are in `replaced`.
[[nodiscard]] PointSet sharing_marks(base::Memory& memory, const PointSet& set, std::span<const LayerName> replaced);

// Returns the field with a number. Fields with the same name in several layers count once. Numbers follow the order of
// the layers, and in a layer that of its fields. Returns NULL if there is no such field.
[[nodiscard]] const MarkField* field_at(const PointSet& set, std::int64_t number) noexcept;
[[nodiscard]] std::int64_t field_count(const PointSet& set) noexcept;
// Returns the first field with a name, or NULL.
[[nodiscard]] const MarkField* field_of(const PointSet& set, const char* name) noexcept;

} // namespace hrbfnpr::marks
