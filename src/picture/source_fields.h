// SPDX-License-Identifier: MIT
// Makes fields of the values that sources have at their points.
//
// A style names such values. The name may say how numbers become shares: "quality:0.2..0.9" makes 0.2 to 0 and 0.9 to
// 1, and "-quality" makes the greatest value to 0 and the least to 1. Without a range, the least number becomes 0 and
// the greatest becomes 1, but outliers do not count: a mirror that a scanner saw would leave all else dark.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/shape.h"

#include <hrbfnpr.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace hrbfnpr::picture {

// Values of one kind, one or three numbers for each point of a source.
struct SourceField {
    String name;
    std::uint32_t kind; // HRBFNPR_FIELD_KIND_*
    Vector<float> values;

    [[nodiscard]] std::size_t components() const noexcept { return kind == HRBFNPR_FIELD_KIND_SCALAR ? 1 : 3; }
};

// The points or the mesh of a source as they were given, with their values. Without values, it is empty.
struct SourceValues {
    explicit SourceValues(Pool& pool) : points(&pool), triangles(&pool), fields(&pool) {}

    Points points;
    Vector<std::array<std::uint32_t, 3>> triangles;
    Vector<SourceField> fields;
};

// Reads and checks the values of a source whose shape was read. Throws Error{invalid_argument} that names the wrong
// field.
[[nodiscard]] SourceValues read_source_values(const hrbfnpr_picture_source& given, const Shape& shape,
                                              const char* owner, Pool& pool);

// Marks know the luminance of a colour by the name of the colour after this.
inline constexpr std::string_view luminance_prefix = "luminance of ";

// The use of a field. It decides which kinds of values a field may have.
enum class FieldUse : std::uint8_t { number, colour, direction };

// A name in a style, taken apart.
struct FieldSpec {
    std::string_view name;                           // the name of the values
    bool is_reversed = false;                        // true if the greatest value becomes 0
    std::optional<std::array<double, 2>> range = {}; // the values that become 0 and 1, if they are given
};
// Takes a text apart. A text that is not of the form above is a name as a whole.
[[nodiscard]] FieldSpec field_spec_of(std::string_view text) noexcept;

// Values that a style wants from sources: those of the first source that has them, and how numbers become shares.
struct WantedField {
    std::string_view name; // the name of the values, in the sources
    FieldUse use = FieldUse::number;
    bool is_luminance = false; // true if numbers are taken from a colour
    // The values that become 0 and 1. Both are 0 if numbers stay as they are.
    std::array<double, 2> range{};
    String key; // the name that marks know the field by
};

// The values of all sources of a picture. Several threads may use it.
class SourceFields {
public:
    explicit SourceFields(Pool& pool) : pool_(&pool), sources_(&pool), made_(&pool) {}

    // Adds the values of the next source.
    void add(SourceValues&& values) { sources_.push_back(std::move(values)); }
    // Finds the values that a text names. Throws Error{invalid_argument} if they do not exist, with the names of those
    // that do, and if their kind does not suit the use.
    [[nodiscard]] WantedField find(const Call& call, std::string_view text, FieldUse use) const;
    // Makes a field of the values of a source. The result is null if the source has no such values.
    [[nodiscard]] Field make_field(const Call& call, const WantedField& wanted, std::size_t source) const;
    // Returns whether no source has values.
    [[nodiscard]] bool empty() const noexcept;

private:
    struct Made {
        std::size_t source;
        String key;
        Field field;
    };
    [[nodiscard]] const SourceField* find_in(std::size_t source, std::string_view name) const noexcept;
    [[nodiscard]] const SourceField* find_any(std::string_view name) const noexcept;
    [[nodiscard]] std::array<double, 2> range_of(std::string_view name, Pool& pool) const;
    [[noreturn]] void refuse_name(const Call& call, std::string_view text) const;

    Pool* pool_;
    Vector<SourceValues> sources_;
    mutable std::mutex making_; // guards made_
    mutable Vector<Made> made_; // fields that pictures of the same sources share
};

} // namespace hrbfnpr::picture
