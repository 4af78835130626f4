// SPDX-License-Identifier: MIT
// Fields that are changed by their names: hrbfnpr_change, and the fields of settings.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace hrbfnpr::picture {

// A field's new value as text, by its path: "fit.kernel" and "gaussian".  Paths have small letters and '_'.
struct Change {
    String path;
    String value;
};

// Paths that no field of a struct stands for, and that the step which knows them reads by value():
//   style.ink            a colour, of all layers, lines and contours
//   style.contours_of    kinds of layers with commas between: the marks of these draw contours, those of others do not
class Changes {
public:
    // Reads and checks the caller's list.  Throws Error{invalid_argument} that names the path and what would be right.
    Changes(const hrbfnpr_change* first, std::int64_t count, std::int64_t stride, Pool& pool);
    // The same after the fields of settings, which were checked when these were read; later ones win.
    Changes(const Vector<std::pair<String, String>>& of_settings, const hrbfnpr_change* first, std::int64_t count,
            std::int64_t stride, Pool& pool);
    Changes(Changes&&) noexcept = default;
    Changes(const Changes&) = delete; // a copy's texts would not be in the pool
    Changes& operator=(const Changes&) = delete;
    ~Changes() = default;

    // The last value that a path was given.
    [[nodiscard]] std::optional<std::string_view> value(std::string_view path) const noexcept;
    [[nodiscard]] bool has(std::string_view path) const noexcept { return value(path).has_value(); }
    // The same as a number; a name of a constant as its number.  Nothing of what is several numbers, and of "auto" of
    // fit.regularization.
    [[nodiscard]] std::optional<double> number(std::string_view path) const noexcept;
    // The same as straight RGBA.
    [[nodiscard]] std::optional<std::array<float, 4>> colour(std::string_view path) const noexcept;

    // Sets the fields of a record that "section.FIELD" was given for, in the order of the list: apply("fit", desc).
    // T: a struct of Record that starts with struct_size.  Texts of the record refer to this.
    //   "fit"            "auto" of regularization is its mode AUTO.  normal_mode stays: Options turn it into `normals`
    //   "style.layers"   `share` is multiplied
    template <class T>
    void apply(std::string_view section, T& record) const;

    // All of them, in order.
    [[nodiscard]] const Vector<Change>& list() const noexcept { return list_; }
    // Whether the caller gave the path a value, and not settings alone.
    [[nodiscard]] bool is_callers(std::string_view path) const noexcept;
    // How many of them, at the front, come from settings.
    [[nodiscard]] std::size_t from_settings() const noexcept { return from_settings_; }

private:
    Vector<Change> list_;
    std::size_t from_settings_ = 0;
};

} // namespace hrbfnpr::picture
