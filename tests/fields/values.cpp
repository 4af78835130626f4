// SPDX-License-Identifier: MIT
#include "values.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace fields_test {
namespace {

using hrbfnpr::api::FieldLayout;

template <class T>
void add(std::vector<Change>& changes, std::size_t offset, const std::string& place, T value) {
    std::string text = std::to_string(value);
    if constexpr (std::is_floating_point_v<T>) {
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "%.4g", static_cast<double>(value));
        text = buffer;
    }
    changes.push_back(
        {place, text, [offset, value](std::byte* field) { std::memcpy(field + offset, &value, sizeof value); }});
}

template <class T>
void add_numbers(std::vector<Change>& changes, std::size_t offset, const std::string& place) {
    using Limits = std::numeric_limits<T>;
    const T huge = static_cast<T>(sizeof(T) == 4 ? 1e30 : 1e200);
    for (const T value : {Limits::quiet_NaN(), Limits::infinity(), Limits::max(), huge, T{1e9}, Limits::denorm_min(),
                          T{1} / huge, static_cast<T>(1e-9), T{1}, T{0.5}})
        for (const T sign : {T{1}, T{-1}}) add(changes, offset, place, sign * value);
    add(changes, offset, place, T{0});
}

// Tries more values than any enumeration has, and every fifth flag.
template <class T>
void add_integers(std::vector<Change>& changes, std::size_t offset, const std::string& place) {
    for (T value = 0; value < 20; ++value) add(changes, offset, place, value);
    for (unsigned bit = 5; bit < 8 * sizeof(T) - 1; bit += bit == 5 ? 1 : 5)
        add(changes, offset, place, static_cast<T>(T{1} << bit));
    add(changes, offset, place, std::numeric_limits<T>::max());
    if constexpr (std::is_signed_v<T>) {
        add(changes, offset, place, T{-1});
        add(changes, offset, place, std::numeric_limits<T>::min());
    }
}

void add_chosen(std::vector<Change>& changes, std::size_t offset, const std::string& place,
                std::initializer_list<std::int64_t> values) {
    for (const std::int64_t value : values) add(changes, offset, place, value);
}

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

void add_sizes(std::vector<Change>& changes, std::size_t offset, const std::string& place) {
    for (const std::uint32_t size : {0U, 4U, 7U, 8U, 9U, 12U, 65537U, 0xffffffffU}) add(changes, offset, place, size);
}

void add_pointers(std::vector<Change>& changes, std::size_t offset, const std::string& place) {
    add(changes, offset, place, std::uintptr_t{0});
}

void add_texts(std::vector<Change>& changes, std::size_t offset, const std::string& place) {
    static const std::string texts[] = {"", "\xff\xfe", "\xed\xa0\x80", "<&\"'>", "]]>\x01", std::string(100000, 'a')};
    for (const std::string& text : texts)
        changes.push_back({place, text.substr(0, 8), [offset, &text](std::byte* field) {
                               const char* c = text.c_str();
                               std::memcpy(field + offset, &c, sizeof c);
                           }});
}

// A stride below 0 or above the element's size would read elsewhere, so the values here are ones that no array can
// have.
void add_array(std::vector<Change>& changes, std::size_t offset, const std::string& place) {
    add_pointers(changes, offset + offsetof(hrbfnpr_array, data), place + ".data");
    add_chosen(changes, offset + offsetof(hrbfnpr_array, count), place + ".count", {0, 1, -1, least, most});
    add_chosen(changes, offset + offsetof(hrbfnpr_array, stride), place + ".stride", {1, 2, least, most});
    for (std::uint32_t kind = 0; kind < 9; ++kind)
        add(changes, offset + offsetof(hrbfnpr_array, scalar), place + ".scalar", kind);
    for (const std::uint32_t count : {0U, 1U, 2U, 3U, 4U, 5U, 0x55555555U, 0xffffffffU})
        add(changes, offset + offsetof(hrbfnpr_array, components), place + ".components", count);
}

void add_element(std::vector<Change>& changes, const FieldLayout& field, std::string_view type, std::size_t offset,
                 const std::string& place) {
    const std::string_view name = field.name;
    if (name == "struct_size")
        add_sizes(changes, offset, place);
    else if (type == "hrbfnpr_array" || type == "hrbfnpr_array_out")
        add_array(changes, offset, place);
    else if (type == "const char*") {
        add_pointers(changes, offset, place);
        add_texts(changes, offset, place);
    } else if (ends_with(name, "user"))
        return; // the argument of the caller's own functions
    else if (type.find('*') != std::string_view::npos || ends_with(type, "_fn"))
        add_pointers(changes, offset, place);
    else if (type == "int64_t" && ends_with(name, "_count"))
        add_chosen(changes, offset, place, {0, -1, least, most});
    else if (type == "int64_t" && ends_with(name, "stride"))
        add_chosen(changes, offset, place, {1, least, most});
    else if (type == "double")
        add_numbers<double>(changes, offset, place);
    else if (type == "float")
        add_numbers<float>(changes, offset, place);
    else if (name == "width" || name == "height") // the size of an image, whose pixels must exist
        for (const std::int32_t size : {0, 1, 2, -1, 32769, std::numeric_limits<std::int32_t>::min()})
            add(changes, offset, place, size);
    else if (type == "int32_t")
        add_integers<std::int32_t>(changes, offset, place);
    else if (type == "uint32_t")
        add_integers<std::uint32_t>(changes, offset, place);
    else if (type == "int64_t")
        add_integers<std::int64_t>(changes, offset, place);
    else if (type == "uint64_t")
        add_integers<std::uint64_t>(changes, offset, place);
}

std::string bracketed(std::size_t index) {
    std::string text = "[";
    text += std::to_string(index);
    text += ']';
    return text;
}

} // namespace

std::vector<Change> changes_of(const FieldLayout& field) {
    const std::string_view type = field.type;
    const std::size_t bracket = type.find('[');
    std::vector<Change> changes;
    if (bracket == std::string_view::npos) {
        add_element(changes, field, type, 0, "");
        return changes;
    }
    const std::size_t count = std::stoul(std::string(type.substr(bracket + 1)));
    for (std::size_t i = 0; i < count; ++i)
        add_element(changes, field, type.substr(0, bracket), i * field.size / count, bracketed(i));
    return changes;
}

} // namespace fields_test
