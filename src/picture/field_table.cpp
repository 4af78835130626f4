// SPDX-License-Identifier: MIT
#include "picture/field_table.h"

#include "base/assert.h"
#include "picture/field_names.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace hrbfnpr::picture {
namespace {

constexpr std::size_t most_digits = 64; // A longer text is not a number.

[[nodiscard]] char small_letter(char letter) noexcept {
    if (letter >= 'A' && letter <= 'Z') return static_cast<char>(letter - 'A' + 'a');
    return letter == '-' ? '_' : letter;
}

[[nodiscard]] std::string_view without_spaces(std::string_view text) noexcept {
    constexpr std::string_view spaces = " \t\n\r";
    const std::size_t first = text.find_first_not_of(spaces);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(spaces) - first + 1);
}

// Returns the part of the text before the next comma, and removes it from the text.
[[nodiscard]] std::string_view next_part(std::string_view& text) noexcept {
    const std::size_t comma = text.find(',');
    const std::string_view part = without_spaces(text.substr(0, comma));
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    return part;
}

[[nodiscard]] std::size_t parts_of(std::string_view text) noexcept {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) + 1;
}

// Parses exactly `count` numbers, separated by commas. Returns false for any other text.
[[nodiscard]] bool parse_numbers(std::string_view text, double* numbers, std::size_t count) noexcept {
    if (parts_of(text) != count) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> number = parse_number(next_part(text));
        if (!number) return false;
        numbers[i] = *number;
    }
    return true;
}

[[nodiscard]] int hex_digit(char digit) noexcept {
    const char letter = small_letter(digit);
    if (letter >= '0' && letter <= '9') return letter - '0';
    return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

[[nodiscard]] bool parse_colour(std::string_view text, std::array<double, 4>& numbers) noexcept {
    numbers[3] = 1.0;
    if (text.empty() || text.front() != '#') {
        const std::size_t count = parts_of(text);
        return (count == 3 || count == 4) && parse_numbers(text, numbers.data(), count);
    }
    const std::string_view digits = text.substr(1);
    if (digits.size() != 6 && digits.size() != 8) return false;
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        const int high = hex_digit(digits[i]);
        const int low = hex_digit(digits[i + 1]);
        if (high < 0 || low < 0) return false;
        numbers[i / 2] = static_cast<double>(16 * high + low) / 255.0;
    }
    return true;
}

// Parses a direction: "x", "-y", or three numbers that are not all 0.
[[nodiscard]] bool parse_direction(std::string_view text, std::array<double, 4>& numbers) noexcept {
    std::string_view axis = text;
    const double sign = !text.empty() && text.front() == '-' ? -1.0 : 1.0;
    if (!axis.empty() && (axis.front() == '-' || axis.front() == '+')) axis.remove_prefix(1);
    if (axis.size() == 1 && axis.front() >= 'x' && axis.front() <= 'z') {
        numbers = {};
        numbers[static_cast<std::size_t>(axis.front() - 'x')] = sign;
        return true;
    }
    return parse_numbers(text, numbers.data(), 3) && (numbers[0] != 0.0 || numbers[1] != 0.0 || numbers[2] != 0.0);
}

// Returns the largest magnitude of a negative or positive whole number that a type can hold.
[[nodiscard]] std::uint64_t largest_of(Scalar scalar, bool is_negative) noexcept {
    switch (scalar) {
    case Scalar::int32: return (std::uint64_t{1} << 31U) - (is_negative ? 0U : 1U);
    case Scalar::int64: return (std::uint64_t{1} << 63U) - (is_negative ? 0U : 1U);
    case Scalar::uint32: return is_negative ? 0U : std::numeric_limits<std::uint32_t>::max();
    default: return is_negative ? 0U : std::numeric_limits<std::uint64_t>::max();
    }
}

[[nodiscard]] bool is_whole(Scalar scalar) noexcept {
    return scalar != Scalar::float32 && scalar != Scalar::float64 && scalar != Scalar::text;
}

[[nodiscard]] FieldValue whole_value(bool is_negative, std::uint64_t magnitude) noexcept {
    FieldValue value;
    value.whole = is_negative ? 0U - magnitude : magnitude;
    const auto size = static_cast<double>(magnitude);
    value.numbers[0] = is_negative ? -size : size;
    return value;
}

[[nodiscard]] FieldValue constant_value(std::int32_t constant) noexcept {
    // No constant is negative, so the sign is always plus.
    return whole_value(false, static_cast<std::uint64_t>(constant));
}

[[nodiscard]] std::optional<FieldValue> parse_whole(const NamedField& field, std::string_view text) noexcept {
    const bool is_negative = !text.empty() && text.front() == '-';
    std::string_view digits = text;
    if (!digits.empty() && (digits.front() == '-' || digits.front() == '+')) digits.remove_prefix(1);
    std::uint64_t magnitude = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), magnitude);
    if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) {
        const std::optional<double> number = parse_number(text); // Whole numbers may also be written like "1e6".
        constexpr double exact = 9007199254740992.0;             // Up to 2^53, doubles hold all whole numbers exactly.
        if (!number || *number != std::trunc(*number) || std::abs(*number) > exact) return std::nullopt;
        magnitude = static_cast<std::uint64_t>(std::abs(*number));
    }
    if (!holds(field, is_negative, magnitude)) return std::nullopt;
    return whole_value(is_negative, magnitude);
}

[[nodiscard]] std::optional<FieldValue> parse_choice(const NamedField& field, std::string_view text) noexcept {
    if (const NamedConstant* const found = find_choice(field, text)) return constant_value(found->value);
    const std::optional<FieldValue> number = parse_whole(field, text);
    if (!number || name_of_choice(field, static_cast<std::uint32_t>(number->whole)).empty()) return std::nullopt;
    return number;
}

[[nodiscard]] std::optional<FieldValue> parse_bits(const NamedField& field, std::string_view text) noexcept {
    std::uint64_t all = 0;
    for (const NamedConstant& choice : choices_of(field)) all |= static_cast<std::uint64_t>(choice.value);
    if (const std::optional<FieldValue> number = parse_whole(field, text)) {
        if ((number->whole & ~all) != 0) return std::nullopt;
        return number;
    }
    std::uint64_t bits = 0;
    for (std::size_t left = parts_of(text); left > 0; --left) {
        const NamedConstant* const found = find_choice(field, next_part(text));
        if (found == nullptr) return std::nullopt;
        bits |= static_cast<std::uint64_t>(found->value);
    }
    return whole_value(false, bits);
}

[[nodiscard]] std::optional<FieldValue> parse_yes_no(std::string_view text) noexcept {
    if (text == "1" || same_name(text, "true")) return whole_value(false, 1);
    if (text == "0" || same_name(text, "false")) return whole_value(false, 0);
    return std::nullopt;
}

[[nodiscard]] std::optional<FieldValue> parse_reals(const NamedField& field, std::string_view text) noexcept {
    FieldValue value;
    const bool is_read = field.meaning == Meaning::colour      ? parse_colour(text, value.numbers)
                         : field.meaning == Meaning::direction ? parse_direction(text, value.numbers)
                                                               : parse_numbers(text, value.numbers.data(), field.count);
    if (!is_read) return std::nullopt;
    for (std::size_t i = 0; i < field.count; ++i)
        if (!holds(field, value.numbers[i])) return std::nullopt;
    return value;
}

template <class T>
[[nodiscard]] T load_as(const NamedField& field, const void* record, std::size_t i) noexcept {
    T value;
    std::memcpy(&value, static_cast<const std::byte*>(record) + field.offset + i * sizeof(T), sizeof value);
    return value;
}

template <class T>
void store_as(const NamedField& field, T value, void* record, std::size_t i) noexcept {
    std::memcpy(static_cast<std::byte*>(record) + field.offset + i * sizeof(T), &value, sizeof value);
}

template <class T>
[[nodiscard]] FieldValue load_whole(const NamedField& field, const void* record) noexcept {
    const T value = load_as<T>(field, record, 0);
    const bool is_negative = value < 0;
    const auto bits = static_cast<std::uint64_t>(value);
    return whole_value(is_negative, is_negative ? 0U - bits : bits);
}

// The parts of a number in scientific notation, as std::to_chars or printf writes it.
struct Decimal {
    bool is_negative = false;
    std::array<char, 24> digits{};
    std::size_t count = 0;
    int exponent = 0; // The power of ten of the first digit.
};

// Writes the shortest "d.ddde±xx" that reads back as the same number. Returns the end of the text.
template <class T>
[[nodiscard]] char* write_shortest(char* begin, char* end, T number) noexcept {
#if defined(__cpp_lib_to_chars)
    return std::to_chars(begin, end, number, std::chars_format::scientific).ptr;
#else // Emscripten's std::to_chars takes no floating-point numbers yet. Its single locale makes printf safe.
    int size = 0;
    for (int digits = 0; digits <= std::numeric_limits<T>::max_digits10; ++digits) {
        size = std::snprintf(begin, static_cast<std::size_t>(end - begin), "%.*e", digits, static_cast<double>(number));
        if (static_cast<T>(std::strtod(begin, nullptr)) == number) break;
    }
    return begin + size;
#endif
}

template <class T>
[[nodiscard]] Decimal decimal_of(T number) noexcept {
    HRBFNPR_ASSERT(std::isfinite(number));
    std::array<char, most_digits> text{};
    const char* const end = write_shortest(text.data(), text.data() + text.size() - 1, number);
    Decimal decimal;
    const char* at = text.data();
    if (*at == '-') decimal.is_negative = true, ++at;
    for (; at != end && *at != 'e'; ++at)
        if (*at != '.') decimal.digits[decimal.count++] = *at;
    decimal.exponent = std::atoi(at + 1);
    while (decimal.count > 1 && decimal.digits[decimal.count - 1] == '0') --decimal.count;
    return decimal;
}

// Returns how similar two names are: the length of their common beginning, plus 100 if `name` contains `like`.
[[nodiscard]] std::size_t likeness(std::string_view name, std::string_view like) noexcept {
    std::size_t same = 0;
    while (same < name.size() && same < like.size() && name[same] == small_letter(like[same])) ++same;
    constexpr std::size_t holds_it = 100;
    return same + (!like.empty() && name.find(like) != std::string_view::npos ? holds_it : 0);
}

} // namespace

const char* name_of(Record record) noexcept {
    switch (record) {
#define HRBFNPR_NAME(name)                                                                                             \
    case Record::name: return "hrbfnpr_" #name;
        HRBFNPR_NAMED_STRUCTS(HRBFNPR_NAME)
#undef HRBFNPR_NAME
    }
    return "";
}

std::span<const NamedField> fields_of(Record record) noexcept {
    switch (record) {
#define HRBFNPR_FIELDS(name)                                                                                           \
    case Record::name: return names_of_hrbfnpr_##name;
        HRBFNPR_NAMED_STRUCTS(HRBFNPR_FIELDS)
#undef HRBFNPR_FIELDS
    }
    return {};
}

std::span<const NamedConstant> choices_of(const NamedField& field) noexcept {
    return std::span(named_constants).subspan(field.first_constant, field.constants);
}

bool same_name(std::string_view a, std::string_view b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return small_letter(x) == small_letter(y); });
}

String plain_name(std::string_view name, Pool& pool) {
    String plain(name, &pool);
    std::transform(plain.begin(), plain.end(), plain.begin(), small_letter);
    return plain;
}

const NamedField* find_field(Record record, std::string_view name) noexcept {
    const std::span<const NamedField> fields = fields_of(record);
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const NamedField& field) { return same_name(field.name, name); });
    return found != fields.end() ? &*found : nullptr;
}

const NamedConstant* find_choice(const NamedField& field, std::string_view name) noexcept {
    const std::span<const NamedConstant> choices = choices_of(field);
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const NamedConstant& choice) { return same_name(choice.name, name); });
    return found != choices.end() ? &*found : nullptr;
}

std::string_view name_of_choice(const NamedField& field, std::uint32_t value) noexcept {
    for (const NamedConstant& choice : choices_of(field))
        if (static_cast<std::uint32_t>(choice.value) == value) return choice.name;
    return {};
}

bool holds(const NamedField& field, double number) noexcept {
    if (field.scalar != Scalar::float32) return std::isfinite(number);
    return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
}

bool holds(const NamedField& field, bool is_negative, std::uint64_t magnitude) noexcept {
    return magnitude <= largest_of(field.scalar, is_negative);
}

std::optional<FieldValue> parse_value(const NamedField& field, std::string_view text) noexcept {
    HRBFNPR_ASSERT(field.meaning != Meaning::text);
    text = without_spaces(text);
    switch (field.meaning) {
    case Meaning::choice: return parse_choice(field, text);
    case Meaning::bits: return parse_bits(field, text);
    case Meaning::yes_no: return parse_yes_no(text);
    default: return is_whole(field.scalar) ? parse_whole(field, text) : parse_reals(field, text);
    }
}

String text_of(const NamedField& field, const FieldValue& value, Pool& pool) {
    String text(&pool);
    if (field.meaning == Meaning::choice) {
        text = name_of_choice(field, static_cast<std::uint32_t>(value.whole));
        if (!text.empty()) return text;
    }
    if (is_whole(field.scalar)) {
        std::array<char, most_digits> digits{};
        char* const end = digits.data() + digits.size();
        const bool is_signed = field.scalar == Scalar::int32 || field.scalar == Scalar::int64;
        char* const last = is_signed ? std::to_chars(digits.data(), end, static_cast<std::int64_t>(value.whole)).ptr
                                     : std::to_chars(digits.data(), end, value.whole).ptr;
        text.append(digits.data(), last);
        return text;
    }
    for (std::size_t i = 0; i < field.count; ++i) {
        if (i > 0) text += ',';
        append_decimals(text, value.numbers[i]);
    }
    return text;
}

String wanted_for(const NamedField& field, Pool& pool) {
    const auto names = [&](const char* before) {
        String text(before, &pool);
        for (const NamedConstant& choice : choices_of(field)) {
            if (&choice != choices_of(field).data()) text += ", ";
            text += choice.name;
        }
        return text;
    };
    switch (field.meaning) {
    case Meaning::choice: return names("one of ");
    case Meaning::bits: return names("with commas between, of ");
    case Meaning::yes_no: return String("true or false", &pool);
    case Meaning::colour: return String("#rrggbb, #rrggbbaa, or 3 or 4 numbers with commas between", &pool);
    case Meaning::direction:
        return String("x, y or z with a sign or not, or 3 numbers with commas between, not all 0", &pool);
    default: break;
    }
    switch (field.scalar) {
    case Scalar::float32:
    case Scalar::float64: return String("a finite number", &pool);
    case Scalar::uint32:
    case Scalar::uint64: return String("a whole number of at least 0", &pool);
    default: return String("a whole number", &pool);
    }
}

FieldValue load_value(const NamedField& field, const void* record) noexcept {
    FieldValue value;
    switch (field.scalar) {
    case Scalar::float32:
        for (std::size_t i = 0; i < field.count; ++i)
            value.numbers[i] = static_cast<double>(load_as<float>(field, record, i));
        return value;
    case Scalar::float64:
        for (std::size_t i = 0; i < field.count; ++i) value.numbers[i] = load_as<double>(field, record, i);
        return value;
    case Scalar::int32: return load_whole<std::int32_t>(field, record);
    case Scalar::uint32: return load_whole<std::uint32_t>(field, record);
    case Scalar::int64: return load_whole<std::int64_t>(field, record);
    case Scalar::uint64: return load_whole<std::uint64_t>(field, record);
    case Scalar::text: break;
    }
    HRBFNPR_ASSERT(field.scalar != Scalar::text);
    return value;
}

void store_value(const NamedField& field, const FieldValue& value, void* record) noexcept {
    switch (field.scalar) {
    case Scalar::float32:
        for (std::size_t i = 0; i < field.count; ++i) store_as(field, static_cast<float>(value.numbers[i]), record, i);
        return;
    case Scalar::float64:
        for (std::size_t i = 0; i < field.count; ++i) store_as(field, value.numbers[i], record, i);
        return;
    case Scalar::int32:
    case Scalar::uint32: return store_as(field, static_cast<std::uint32_t>(value.whole), record, 0);
    case Scalar::int64:
    case Scalar::uint64: return store_as(field, value.whole, record, 0);
    case Scalar::text: break;
    }
    HRBFNPR_ASSERT(field.scalar != Scalar::text);
}

const char* load_text(const NamedField& field, const void* record) noexcept {
    HRBFNPR_ASSERT(field.scalar == Scalar::text);
    return load_as<const char*>(field, record, 0);
}

void store_text(const NamedField& field, const char* text, void* record) noexcept {
    HRBFNPR_ASSERT(field.scalar == Scalar::text);
    store_as(field, text, record, 0);
}

std::optional<double> parse_number(std::string_view text) noexcept {
    const bool has_plus = !text.empty() && text.front() == '+';
    if (has_plus) text.remove_prefix(1);
    // Only the characters of decimal numbers are allowed: "inf" and "0x1p3" are refused.
    if (text.empty() || text.size() >= most_digits || text.front() == '+' || (has_plus && text.front() == '-') ||
        text.find_first_not_of("0123456789+-.eE") != std::string_view::npos)
        return std::nullopt;
    double number = 0.0;
#if defined(__cpp_lib_to_chars)
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_read = error == std::errc() && end == text.data() + text.size();
#else // Emscripten's std::from_chars takes no floating-point numbers yet. Its single locale makes strtod safe.
    std::array<char, most_digits> copy{};
    std::copy(text.begin(), text.end(), copy.begin());
    char* end = nullptr;
    number = std::strtod(copy.data(), &end);
    const bool is_read = end == copy.data() + text.size();
#endif
    if (!is_read || !std::isfinite(number)) return std::nullopt;
    return number;
}

void append_decimals(String& text, double number) {
    const Decimal decimal = decimal_of(number);
    const std::string_view digits(decimal.digits.data(), decimal.count);
    if (decimal.is_negative) text += '-';
    constexpr int least_fixed = -4;  // Numbers with smaller exponents are written with "e".
    constexpr int end_of_fixed = 16; // Numbers with this exponent and larger ones are written with "e".
    if (decimal.exponent < least_fixed || decimal.exponent >= end_of_fixed) {
        text += digits[0];
        if (digits.size() > 1) (text += '.') += digits.substr(1);
        const int size = std::abs(decimal.exponent);
        text += decimal.exponent < 0 ? "e-" : "e+";
        if (size < 10) text += '0';
        std::array<char, 8> exponent{};
        text.append(exponent.data(), std::to_chars(exponent.data(), exponent.data() + exponent.size(), size).ptr);
        return;
    }
    if (decimal.exponent < 0) {
        text += "0.";
        text.append(static_cast<std::size_t>(-decimal.exponent - 1), '0') += digits;
        return;
    }
    const auto whole = static_cast<std::size_t>(decimal.exponent) + 1;
    text += digits.substr(0, whole);
    if (digits.size() < whole) text.append(whole - digits.size(), '0');
    text += '.';
    text += digits.size() > whole ? digits.substr(whole) : std::string_view("0");
}

double shortest_decimals(double number) noexcept {
    if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) return number;
    const auto narrow = static_cast<float>(number);
    if (static_cast<double>(narrow) != number) return number;
    std::array<char, most_digits> text{};
    const char* const end = write_shortest(text.data(), text.data() + text.size() - 1, narrow);
    return parse_number({text.data(), static_cast<std::size_t>(end - text.data())}).value_or(number);
}

String listed_names(std::span<const std::string_view> names, std::string_view like, std::size_t room, Pool& pool) {
    Vector<std::string_view> order(names.begin(), names.end(), &pool);
    std::size_t size = 0;
    for (const std::string_view name : names) size += name.size() + 2;
    constexpr std::string_view rest = ", ...";
    const bool has_room = size <= room + 2;
    if (!has_room)
        std::stable_sort(order.begin(), order.end(),
                         [&](std::string_view a, std::string_view b) { return likeness(a, like) > likeness(b, like); });
    String text(&pool);
    for (const std::string_view name : order) {
        if (!has_room && text.size() + 2 + name.size() + rest.size() > room) return text += rest;
        if (!text.empty()) text += ", ";
        text += name;
    }
    return text;
}

} // namespace hrbfnpr::picture
