// SPDX-License-Identifier: MIT
// Fields that are changed by their names: hrbfnpr_change, and the fields of settings.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <optional>
#include <string_view>

namespace hrbfnpr::picture {

// A field's new value as text, by its path: "fit.kernel" and "gaussian".
struct Change {
    String path;
    String value;
};

class Changes {
public:
    // Reads and checks the caller's list.  Throws Error{invalid_argument} that names the path and what would be right.
    Changes(const hrbfnpr_change* first, std::int64_t count, std::int64_t stride, Pool& pool);

    // The last value that a path was given.
    [[nodiscard]] std::optional<std::string_view> value(std::string_view path) const noexcept;
    [[nodiscard]] bool has(std::string_view path) const noexcept { return value(path).has_value(); }
    // The same as a number; a name of a constant as its number.
    [[nodiscard]] std::optional<double> number(std::string_view path) const noexcept;

    // Sets the fields of a record that "section.FIELD" was given for, in the order of the list: apply("fit", desc).
    // T: a descriptor of hrbfnpr.h that starts with struct_size.  Strings of the record refer to this.
    template <class T>
    void apply(std::string_view section, T& record) const;

    // All of them, in order.
    [[nodiscard]] const Vector<Change>& list() const noexcept { return list_; }

private:
    Vector<Change> list_;
};

} // namespace hrbfnpr::picture
