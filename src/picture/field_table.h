// SPDX-License-Identifier: MIT
// Finds fields of public structs by name, and converts their values from and to text, for hrbfnpr_change and settings.
//
// bindings/generate writes the tables (field_names.h). The tables hold names as arrays instead of pointers, so that
// they need no relocation and stay read-only.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace hrbfnpr::picture {

enum class Scalar : std::uint8_t { float32, float64, int32, uint32, int64, uint64, text };

// The kinds of values that a user may write for a field.
enum class Meaning : std::uint8_t {
    number,
    choice,    // the name of a constant
    bits,      // names of constants, separated by commas; their values are combined by bitwise or
    yes_no,    // true or false
    colour,    // four numbers, straight RGBA
    direction, // three numbers, not all of them 0
    text
};

struct NamedConstant {
    char name[20];
    std::int32_t value;
};

struct NamedField {
    char name[28];
    std::uint16_t offset; // offset in the struct, in bytes
    Scalar scalar;
    Meaning meaning;
    std::uint8_t count;          // The count of numbers in the field: 1, or the length of an array.
    std::uint8_t first_constant; // The index in named_constants of the field's first choice.
    std::uint8_t constants;
};

// A struct whose fields have a table in field_names.h.
enum class Record : std::uint8_t {
    style,
    layer_style,
    line_style,
    fit_desc,
    mesh_fit_desc,
    generate_desc,
    layer_desc,
    line_set_desc,
    shading_desc,
    light,
    line_desc,
    page_desc
};

[[nodiscard]] const char* name_of(Record record) noexcept; // Returns the C name of the struct, such as "hrbfnpr_style".
[[nodiscard]] std::span<const NamedField> fields_of(Record record) noexcept;
[[nodiscard]] std::span<const NamedConstant> choices_of(const NamedField& field) noexcept;
// Finds a field or a choice by name, or returns nullptr. Case does not matter, and '-' equals '_'.
[[nodiscard]] const NamedField* find_field(Record record, std::string_view name) noexcept;
[[nodiscard]] const NamedConstant* find_choice(const NamedField& field, std::string_view name) noexcept;
// Returns the name of the choice that has this value, or an empty text.
[[nodiscard]] std::string_view name_of_choice(const NamedField& field, std::uint32_t value) noexcept;
[[nodiscard]] bool same_name(std::string_view a, std::string_view b) noexcept;
// Returns the name in small letters, with '_' for '-'.
[[nodiscard]] String plain_name(std::string_view name, Pool& pool);

// The value of a field. Whole numbers are stored exactly.
struct FieldValue {
    std::array<double, 4> numbers{}; // All numbers of the field. An integer is also stored here, in numbers[0].
    std::uint64_t whole = 0;         // The value of an integer field, as two's complement.
};

// Parses a value that a user wrote. Returns nullopt if the field cannot hold it. Text fields are not allowed.
[[nodiscard]] std::optional<FieldValue> parse_value(const NamedField& field, std::string_view text) noexcept;
// Formats a value as text that parse_value() reads.
[[nodiscard]] String text_of(const NamedField& field, const FieldValue& value, Pool& pool);
// Describes the texts that parse_value() accepts, such as "a finite number" or "one of none, light".
[[nodiscard]] String wanted_for(const NamedField& field, Pool& pool);
// Returns whether a field can hold a real number, or a whole number of a given sign and magnitude.
[[nodiscard]] bool holds(const NamedField& field, double number) noexcept;
[[nodiscard]] bool holds(const NamedField& field, bool is_negative, std::uint64_t magnitude) noexcept;

[[nodiscard]] FieldValue load_value(const NamedField& field, const void* record) noexcept;
void store_value(const NamedField& field, const FieldValue& value, void* record) noexcept;
[[nodiscard]] const char* load_text(const NamedField& field, const void* record) noexcept; // The result may be null.
void store_text(const NamedField& field, const char* text, void* record) noexcept;

// Parses a text that consists of one decimal number, such as "1", "-2.5e3" or "+.5". The locale of the process does not
// matter. Returns nullopt for any other text, and for numbers that are not finite.
[[nodiscard]] std::optional<double> parse_number(std::string_view text) noexcept;
// Appends the shortest decimals that read back as the same number, in Python's notation: "1.0", "0.05", "1e-07". The
// number must be finite.
void append_decimals(String& text, double number);
// If the number is exactly a float, returns the double nearest to the float's shortest decimals: 0.1 for 0.1F.
// Otherwise returns the number.
[[nodiscard]] double shortest_decimals(double number) noexcept;

// Returns a list "a, b, c" with as many names as fit into `room` bytes. If they do not all fit, names similar to `like`
// come first.
[[nodiscard]] String listed_names(std::span<const std::string_view> names, std::string_view like, std::size_t room,
                                  Pool& pool);

} // namespace hrbfnpr::picture
