// SPDX-License-Identifier: MIT
// The fields of public structs by their names, and their values as text: for hrbfnpr_change and for settings.
//
// The tables are made from the header (field_names.h).  Names are kept in place, not as pointers, so that the tables
// need no relocation and stay read-only.
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

// What a user may write for a field.
enum class Meaning : std::uint8_t {
    number,
    choice,    // the name of a constant
    bits,      // names of constants with commas between, whose values are or-ed
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
    std::uint16_t offset; // bytes from the struct's beginning
    Scalar scalar;
    Meaning meaning;
    std::uint8_t count;          // of numbers: 1, or the length of an array
    std::uint8_t first_constant; // of those that are its choices
    std::uint8_t constants;
};

// A struct that has a table.
enum class Record : std::uint8_t {
    style,
    layer_style,
    line_style,
    fit_desc,
    mesh_fit_desc,
    generate_desc,
    layer_desc,
    line_set_desc,
    line_desc,
    page_desc
};

[[nodiscard]] const char* name_of(Record record) noexcept; // "hrbfnpr_style"
[[nodiscard]] std::span<const NamedField> fields_of(Record record) noexcept;
[[nodiscard]] std::span<const NamedConstant> choices_of(const NamedField& field) noexcept;
// '-' and '_' are alike in names, and so are capitals and small letters.  nullptr: there is none.
[[nodiscard]] const NamedField* find_field(Record record, std::string_view name) noexcept;
[[nodiscard]] const NamedConstant* find_choice(const NamedField& field, std::string_view name) noexcept;
// The name of the choice that has this value; empty: there is none.
[[nodiscard]] std::string_view name_of_choice(const NamedField& field, std::uint32_t value) noexcept;
[[nodiscard]] bool same_name(std::string_view a, std::string_view b) noexcept;
// With small letters and '_'.
[[nodiscard]] String plain_name(std::string_view name, Pool& pool);

// What a field holds.  Whole numbers are exact.
struct FieldValue {
    std::array<double, 4> numbers{}; // of float32 and float64; the first one of others, too
    std::uint64_t whole = 0;         // of integers, as two's complement
};

// Reads a value as a user writes it; nothing if the field cannot hold it.  Not for texts.
[[nodiscard]] std::optional<FieldValue> parse_value(const NamedField& field, std::string_view text) noexcept;
// A value that parse_value() reads.
[[nodiscard]] String text_of(const NamedField& field, const FieldValue& value, Pool& pool);
// What parse_value() takes: "a number", "one of none, light".
[[nodiscard]] String wanted_for(const NamedField& field, Pool& pool);
// Whether a number that is not whole in text can be held by the field.
[[nodiscard]] bool holds(const NamedField& field, double number) noexcept;
[[nodiscard]] bool holds(const NamedField& field, bool is_negative, std::uint64_t magnitude) noexcept;

[[nodiscard]] FieldValue load_value(const NamedField& field, const void* record) noexcept;
void store_value(const NamedField& field, const FieldValue& value, void* record) noexcept;
[[nodiscard]] const char* load_text(const NamedField& field, const void* record) noexcept; // nullable
void store_text(const NamedField& field, const char* text, void* record) noexcept;

// A decimal number in full, in any locale of the process: "1", "-2.5e3", "+.5".  Not finite, or anything else: nothing.
[[nodiscard]] std::optional<double> parse_number(std::string_view text) noexcept;
// The shortest decimals that read as the same number, as Python writes them: "1.0", "0.05", "1e-07".  A NaN has no
// such.
void append_decimals(String& text, double number);
// The number that the shortest decimals of a float stand for, where the number is one; else the number itself.
[[nodiscard]] double shortest_decimals(double number) noexcept;

// "a, b, c", as many as have room in a message; those like `name` come first where not all do.
[[nodiscard]] String listed_names(std::span<const std::string_view> names, std::string_view like, std::size_t room,
                                  Pool& pool);

} // namespace hrbfnpr::picture
