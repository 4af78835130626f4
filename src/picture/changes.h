// SPDX-License-Identifier: MIT
// Changes fields of descriptors by their names, as hrbfnpr_change and settings do.
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

// The path of a field and its new value as text, such as "fit.kernel" and "gaussian". Paths have small letters and '_'.
struct Change {
    String path;
    String value;
};

// A list of changes. Some paths name no field of a struct:
//   "style.ink"              the colour of all layers, lines and contours; plan.cpp reads it by colour()
//   "style.palette"          the inks of ink fields; plan.cpp reads them by colours()
//   "style.field"            uses of fields, such as "tone=quality,direction=flow". The list holds each use as a change
//                            of its own: "style.layers.tone_field" or "marks.direction_field"
//   "marks.direction_field"  the name of the values that hatching follows; field_plan.cpp reads it
class Changes {
public:
    // Reads and checks the caller's list. Throws Error{invalid_argument} that names the path and the allowed values.
    Changes(const hrbfnpr_change* first, std::int64_t count, std::int64_t stride, Pool& pool);
    // Makes a list of the changes from settings, followed by the caller's changes. Only the caller's changes are
    // checked. Later changes override earlier ones.
    Changes(const Vector<std::pair<String, String>>& of_settings, const hrbfnpr_change* first, std::int64_t count,
            std::int64_t stride, Pool& pool);
    Changes(Changes&&) noexcept = default;
    Changes(const Changes&) = delete; // A copy would allocate its texts outside the pool.
    Changes& operator=(const Changes&) = delete;
    ~Changes() = default;

    // Returns the last value for a path, or nullopt.
    [[nodiscard]] std::optional<std::string_view> value(std::string_view path) const noexcept;
    [[nodiscard]] bool has(std::string_view path) const noexcept { return value(path).has_value(); }
    // Returns the last value for a path as a number. The name of a constant is converted to the constant's value.
    // Returns nullopt for a field with several numbers, and for the value "auto" of fit.regularization.
    [[nodiscard]] std::optional<double> number(std::string_view path) const noexcept;
    // Returns the last value for a path as straight RGBA.
    [[nodiscard]] std::optional<std::array<float, 4>> colour(std::string_view path) const noexcept;
    // Returns the last value for a path as colours: up to 8, written #rrggbb or #rrggbbaa, with commas between.
    [[nodiscard]] std::optional<Vector<std::array<float, 4>>> colours(std::string_view path, Pool& pool) const;

    // Sets each field of a record for which the list has "section.FIELD", in the order of the list: apply("fit", desc).
    // T is a struct of Record that starts with struct_size. Texts of the record point into this object. Two sections
    // have special rules:
    //   "fit"            the value "auto" of regularization sets its mode to AUTO; normal_mode is skipped, because the
    //                    class Options reads it
    //   "style.layers"   the value of `share` is a factor, which multiplies the record's share
    template <class T>
    void apply(std::string_view section, T& record) const;

    // Returns all changes in the order of the list.
    [[nodiscard]] const Vector<Change>& list() const noexcept { return list_; }
    // Returns whether the caller's list, not the settings, gives the path a value.
    [[nodiscard]] bool is_callers(std::string_view path) const noexcept;
    // Returns the number of changes that come from settings. They are the first changes of the list.
    [[nodiscard]] std::size_t from_settings() const noexcept { return from_settings_; }

private:
    Vector<Change> list_;
    std::size_t from_settings_ = 0;
};

} // namespace hrbfnpr::picture
