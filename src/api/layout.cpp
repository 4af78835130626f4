// SPDX-License-Identifier: MIT
// Implements hrbfnpr_layout. The texts are made at compile time, so the function allocates nothing and cannot fail.
#include "api/struct_fields.h"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace hrbfnpr::api {
namespace {

struct StructLayout {
    std::string_view name;
    std::size_t size, align;
    std::span<const FieldLayout> fields;
};

constexpr std::array layouts{
#define HRBFNPR_LAYOUT(record)                                                                                         \
    StructLayout{#record, sizeof(record), alignof(record), std::span<const FieldLayout>(fields_of_##record)},
    HRBFNPR_STRUCTS(HRBFNPR_LAYOUT)
#undef HRBFNPR_LAYOUT
};

// Writes characters to `to`. If `to` is NULL, it only counts them.
class Text {
public:
    constexpr explicit Text(char* to) noexcept : _to(to) {}

    constexpr Text& operator<<(std::string_view text) noexcept {
        for (const char c : text) put(c);
        return *this;
    }

    constexpr Text& operator<<(std::size_t number) noexcept {
        if (number >= 10) *this << number / 10;
        put(static_cast<char>('0' + number % 10));
        return *this;
    }

    constexpr std::size_t size() const noexcept { return _size; }

private:
    constexpr void put(char c) noexcept {
        if (_to != nullptr) _to[_size] = c;
        ++_size;
    }

    char* _to;
    std::size_t _size = 0;
};

constexpr void write(Text& text, const StructLayout& layout) noexcept {
    text << R"({"name": ")" << layout.name << R"(", "size": )" << layout.size << R"(, "align": )" << layout.align
         << R"(, "fields": [)";
    bool first = true;
    for (const FieldLayout& field : layout.fields) {
        text << (first ? "" : ", ") << R"({"name": ")" << field.name << R"(", "type": ")" << field.type
             << R"(", "offset": )" << field.offset << R"(, "size": )" << field.size << "}";
        first = false;
    }
    text << "]}";
}

constexpr std::size_t length_of(const StructLayout& layout) noexcept {
    Text text(nullptr);
    write(text, layout);
    return text.size();
}

// Returns the text of a struct, with a NUL at its end.
template <std::size_t index>
constexpr auto make_text() noexcept {
    std::array<char, length_of(layouts[index]) + 1> characters{};
    Text text(characters.data());
    write(text, layouts[index]);
    return characters;
}

// Each text is a constant, because Clang limits the work for a single constant.
template <std::size_t index>
constexpr auto text_of = make_text<index>();

// Returns the text with the list of all structs, with a NUL at its end.
template <std::size_t... index>
constexpr auto make_list(std::index_sequence<index...> /*all*/) noexcept {
    // The list has ",\n" in place of the NUL of each text but the last, and "[", "]" and its own NUL.
    std::array<char, (text_of<index>.size() + ...) + sizeof...(index) + 1> list{};
    char* to = list.data();
    const auto add = [&to](std::string_view text) {
        for (const char c : text) *to++ = c;
    };
    add("[");
    ((add(index == 0 ? "" : ",\n"), add({text_of<index>.data(), text_of<index>.size() - 1})), ...);
    add("]");
    return list;
}

constexpr auto list = make_list(std::make_index_sequence<layouts.size()>());

template <std::size_t... index>
constexpr std::array<const char*, layouts.size()> begins_of(std::index_sequence<index...> /*all*/) noexcept {
    return {text_of<index>.data()...};
}

constexpr std::array begins = begins_of(std::make_index_sequence<layouts.size()>());

} // namespace
} // namespace hrbfnpr::api

extern "C" const char* hrbfnpr_layout(const char* name) {
    using namespace hrbfnpr::api;
    if (name == nullptr) return list.data();
    for (std::size_t i = 0; i < layouts.size(); ++i)
        if (layouts[i].name == name) return begins[i];
    return nullptr;
}
