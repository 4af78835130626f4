// SPDX-License-Identifier: MIT
// One table of a struct's fields replaces three lists: defaults, checks, and the copy into the settings of the room
// that uses them. A row has the name of a field, its member of the struct, the member of the settings that stores its
// value, and a rule:
//
//   constexpr auto project_fields() noexcept {
//       return FieldTable{
//           field("tolerance", &hrbfnpr_project_desc::tolerance, &ProjectionSettings::tolerance, rule::Positive{}),
//           reserved("reserved", &hrbfnpr_project_desc::reserved)};
//   }
//   static_assert(project_fields().covers<hrbfnpr_project_desc>());
//
// Rules that involve several fields are written as code beside the table. The table is a function, because GCC puts a
// constant tuple into writable memory.
#pragma once

#include "api/checks.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <tuple>
#include <type_traits>

namespace hrbfnpr::api {

// Rules for the values of a field.  A rule is called with the checks, the field's name, and its value.
namespace rule {

struct Any { // any value; also for values that are checked together with other fields
    template <class T>
    void operator()(const Checks& /*checks*/, const char* /*field*/, const T& /*value*/) const noexcept {}
};

struct Finite {
    template <class T>
    void operator()(const Checks& checks, const char* field, T value) const {
        checks.finite(field, static_cast<double>(value));
    }
};

struct AtLeast {
    double low;
    template <class T>
    void operator()(const Checks& checks, const char* field, T value) const {
        checks.at_least(field, static_cast<double>(value), low);
    }
};

inline constexpr AtLeast not_negative{0.0};

struct Positive {
    template <class T>
    void operator()(const Checks& checks, const char* field, T value) const {
        checks.positive(field, static_cast<double>(value));
    }
};

struct PositiveUpTo {
    double high;
    template <class T>
    void operator()(const Checks& checks, const char* field, T value) const {
        checks.positive(field, static_cast<double>(value));
        checks.between(field, static_cast<double>(value), 0.0, high);
    }
};

struct Between { // numbers from `low` to `high`, both included
    double low, high;
    template <class T>
    void operator()(const Checks& checks, const char* field, T value) const {
        checks.between(field, static_cast<double>(value), low, high);
    }
};

struct StrictlyBetween { // numbers between `low` and `high`, both excluded
    double low, high;
    template <class T>
    void operator()(const Checks& checks, const char* field, T value) const {
        checks.strictly_between(field, static_cast<double>(value), low, high);
    }
};

struct OneOf { // the enumerators 0 to last
    std::uint32_t last;
    const char* names;
    void operator()(const Checks& checks, const char* field, std::int64_t value) const {
        checks.one_of(field, value, last + 1, names);
    }
};

struct ZeroOrOne {
    void operator()(const Checks& checks, const char* field, std::int64_t value) const {
        checks.zero_or_one(field, value);
    }
};

struct Flags {
    std::uint32_t known;
    void operator()(const Checks& checks, const char* field, std::uint32_t value) const {
        checks.flags(field, value, known);
    }
};

struct Zero {
    void operator()(const Checks& checks, const char* field, std::uint32_t value) const { checks.zero(field, value); }
};

struct NotNull { // a pointer that must not be NULL
    template <class T>
    void operator()(const Checks& checks, const char* field, T* value) const {
        checks.not_null(field, value != nullptr);
    }
};

template <class Rule>
struct AllNumbers { // a rule for each element of an array; messages name the field
    Rule rule;
    template <class T, std::size_t count>
    void operator()(const Checks& checks, const char* field, const T (&values)[count]) const {
        for (const T& value : values) rule(checks, field, value);
    }
};
template <class Rule>
AllNumbers(Rule) -> AllNumbers<Rule>;

template <class Rule>
struct IndexedNumbers { // a rule for each element of an array; messages name the element, such as "field[2]"
    Rule rule;
    template <class T, std::size_t count>
    void operator()(const Checks& checks, const char* field, const T (&values)[count]) const {
        for (std::size_t i = 0; i < count; ++i) {
            char name[48];
            std::snprintf(name, sizeof name, "%s[%d]", field, static_cast<int>(i));
            rule(checks, name, values[i]);
        }
    }
};
template <class Rule>
IndexedNumbers(Rule) -> IndexedNumbers<Rule>;

} // namespace rule

// Copies a number, or an array of numbers, between a struct and the settings of a room.
template <class To, class From>
constexpr void assign_field(To& to, const From& from) noexcept {
    if constexpr (std::is_array_v<To> || std::is_array_v<From>) {
        constexpr auto count = static_cast<int>(std::is_array_v<To> ? std::extent_v<To> : std::extent_v<From>);
        for (int i = 0; i < count; ++i) to[i] = from[i];
    } else {
        to = static_cast<To>(from);
    }
}

// A field whose value is stored in the settings of a room.
template <class Struct, class Value, class Settings, class Kept, class Rule>
struct KeptField {
    static constexpr std::size_t bytes = sizeof(Value);
    const char* name;
    Value Struct::*member;
    Kept Settings::*kept;
    Rule rule;

    constexpr void set_default(const Settings& from, Struct& to) const noexcept {
        assign_field(to.*member, from.*kept);
    }
    void check(const Checks& checks, const Struct& given) const { rule(checks, name, given.*member); }
    void copy(const Struct& from, Settings& to) const noexcept { assign_field(to.*kept, from.*member); }
};

// A field that is only checked, or that other code copies. Its default is 0.
template <class Struct, class Value, class Rule>
struct CheckedField {
    // NOLINTNEXTLINE(bugprone-sizeof-expression): the field may be a pointer
    static constexpr std::size_t bytes = sizeof(Value);
    const char* name;
    Value Struct::*member;
    Rule rule;

    template <class Settings>
    constexpr void set_default(const Settings& /*from*/, Struct& /*to*/) const noexcept {}
    void check(const Checks& checks, const Struct& given) const { rule(checks, name, given.*member); }
    template <class Settings>
    void copy(const Struct& /*from*/, Settings& /*to*/) const noexcept {}
};

template <class Struct, class Value, class Settings, class Kept, class Rule>
[[nodiscard]] constexpr KeptField<Struct, Value, Settings, Kept, Rule> field(const char* name, Value Struct::*member,
                                                                             Kept Settings::*kept, Rule rule) noexcept {
    return {name, member, kept, rule};
}

template <class Struct, class Value, class Rule>
[[nodiscard]] constexpr CheckedField<Struct, Value, Rule> field(const char* name, Value Struct::*member,
                                                                Rule rule) noexcept {
    return {name, member, rule};
}

template <class Struct>
[[nodiscard]] constexpr auto reserved(const char* name, std::uint32_t Struct::*member) noexcept {
    return field(name, member, rule::Zero{});
}

template <class... Fields>
class FieldTable {
public:
    static constexpr std::size_t bytes = (Fields::bytes + ... + 0); // the total size of all fields

    constexpr explicit FieldTable(Fields... fields) noexcept : fields_(fields...) {}

    // Checks that the table has all fields of the struct. Where pointers have 8 bytes, public structs have no gaps, so
    // the sizes must add up.
    template <class Struct>
    [[nodiscard]] constexpr bool covers() const noexcept {
        std::size_t size = bytes;
        if constexpr (requires(Struct given) { given.struct_size; }) size += sizeof(Struct::struct_size);
        return size == sizeof(Struct) || sizeof(void*) != 8;
    }

    // Sets the fields of the struct from the settings.
    template <class Settings, class Struct>
    constexpr void set_defaults(const Settings& from, Struct& to) const noexcept {
        std::apply([&](const auto&... row) { (row.set_default(from, to), ...); }, fields_);
    }

    // `owner` is the name of the struct, as in the class Checks.
    template <class Struct>
    void check(const char* owner, const Struct& given) const {
        const Checks checks(owner);
        std::apply([&](const auto&... row) { (row.check(checks, given), ...); }, fields_);
    }

    // Copies the fields into the settings. check() must be called first.
    template <class Struct, class Settings>
    void copy(const Struct& from, Settings& to) const noexcept {
        std::apply([&](const auto&... row) { (row.copy(from, to), ...); }, fields_);
    }

private:
    std::tuple<Fields...> fields_;
};

} // namespace hrbfnpr::api
