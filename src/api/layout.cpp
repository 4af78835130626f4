// SPDX-License-Identifier: MIT
// Implements hrbfnpr_layout. The texts are made at compile time, so the function allocates nothing and cannot fail.
#include "api/struct_fields.h"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

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

constexpr void write_all(Text& text) noexcept {
    text << "[";
    bool first = true;
    for (const StructLayout& layout : layouts) {
        text << (first ? "" : ",\n");
        write(text, layout);
        first = false;
    }
    text << "]";
}

constexpr std::size_t length() noexcept {
    Text text(nullptr);
    write_all(text);
    for (const StructLayout& layout : layouts) write(text, layout);
    return text.size() + 1 + layouts.size(); // Each text ends with a NUL, which is counted, too.
}

// The text with the list of all structs, followed by a text for each struct.
struct Texts {
    std::array<char, length()> characters;
    std::array<std::size_t, layouts.size() + 1> begins;
};

constexpr Texts make_texts() noexcept {
    Texts texts{};
    Text text(texts.characters.data());
    const auto end = [&] { text << std::string_view("\0", 1); };
    write_all(text);
    end();
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        texts.begins[i + 1] = text.size();
        write(text, layouts[i]);
        end();
    }
    return texts;
}

constexpr Texts texts = make_texts();

} // namespace
} // namespace hrbfnpr::api

extern "C" const char* hrbfnpr_layout(const char* name) {
    using namespace hrbfnpr::api;
    if (name == nullptr) return texts.characters.data();
    for (std::size_t i = 0; i < layouts.size(); ++i)
        if (layouts[i].name == name) return texts.characters.data() + texts.begins[i + 1];
    return nullptr;
}
