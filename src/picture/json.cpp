// SPDX-License-Identifier: MIT
// The library nlohmann/json parses the text: numbers, escapes, UTF-8, and the positions of errors. It reports each
// value by an event, and JsonEvents appends the value to the list. So only the current token is stored outside the
// context's memory.
#include "picture/json.h"

#include "base/assert.h"
#include "base/status.h"
#include "picture/field_table.h"
#include "picture/tuning_settings.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>

namespace hrbfnpr::picture {
namespace {

// Receives the parser's events. Each function returns true to continue.
class JsonEvents {
public:
    using Reader = nlohmann::json;

    explicit JsonEvents(JsonDocument& document) noexcept : document_(document) {}

    bool null() {
        document_.add_null();
        return true;
    }
    bool boolean(bool value) {
        document_.add_bool(value);
        return true;
    }
    bool number_integer(Reader::number_integer_t value) { // The parser calls this for negative numbers only.
        document_.add_whole(value < 0,
                            value < 0 ? 0U - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value));
        return true;
    }
    bool number_unsigned(Reader::number_unsigned_t value) {
        document_.add_whole(false, value);
        return true;
    }
    bool number_float(Reader::number_float_t value, const std::string& /*text*/) {
        document_.add_number(value);
        return true;
    }
    bool string(std::string& value) {
        document_.add_text(value);
        return true;
    }
    bool binary(Reader::binary_t& /*value*/) { return false; }
    bool start_object(std::size_t /*size*/) { return begin(JsonKind::object); }
    bool start_array(std::size_t /*size*/) { return begin(JsonKind::list); }
    bool end_object() { return end(); }
    bool end_array() { return end(); }
    bool key(std::string& value) {
        document_.key(value);
        return true;
    }
    [[noreturn]] bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                                  const Reader::exception& error) {
        // The useful part of the message begins after the name of the exception.
        const char* const at = std::strstr(error.what(), "line ");
        fail(Status::invalid_argument, "this is not JSON: %s", at != nullptr ? at : error.what());
    }

private:
    bool begin(JsonKind kind) {
        if (++depth_ > settings_tuning.most_depth)
            fail(Status::invalid_argument, "lists and objects are nested more than %zu deep",
                 settings_tuning.most_depth);
        document_.begin(kind);
        return true;
    }
    bool end() {
        --depth_;
        document_.end();
        return true;
    }

    JsonDocument& document_;
    std::size_t depth_ = 0;
};

void append_whole(String& to, bool is_negative, std::uint64_t magnitude) {
    std::array<char, 24> digits{};
    if (is_negative) to += '-';
    to.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), magnitude).ptr);
}

void append_escape(String& to, std::uint32_t unit) {
    constexpr std::string_view hex = "0123456789abcdef";
    to += "\\u";
    for (const std::uint32_t shift : {12U, 8U, 4U, 0U}) to += hex[unit >> shift & 0xFU];
}

// Removes the first UTF-8 character from a text and returns it.
[[nodiscard]] std::uint32_t take_utf8(std::string_view& text) noexcept {
    const auto lead = static_cast<std::uint8_t>(text.front());
    const std::size_t more = lead < 0xC0 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
    std::uint32_t code = more == 0 ? lead : lead & (0x3FU >> more);
    for (std::size_t i = 1; i <= more && i < text.size(); ++i)
        code = code << 6U | (static_cast<std::uint8_t>(text[i]) & 0x3FU);
    text.remove_prefix(std::min(more + 1, text.size()));
    return code;
}

// Appends a text in quotes. Characters that are not ASCII are escaped.
void append_quoted(String& to, std::string_view text) {
    constexpr std::string_view plain = "\"\\\n\r\t\b\f";
    constexpr std::string_view escaped = "\"\\nrtbf";
    to += '"';
    while (!text.empty()) {
        const std::uint32_t code = take_utf8(text);
        const std::size_t found = code < 0x80 ? plain.find(static_cast<char>(code)) : std::string_view::npos;
        if (found != std::string_view::npos)
            (to += '\\') += escaped[found];
        else if (code >= 0x20 && code < 0x7F)
            to += static_cast<char>(code);
        else if (code < 0x10000)
            append_escape(to, code);
        else {
            append_escape(to, 0xD800U + ((code - 0x10000U) >> 10U));
            append_escape(to, 0xDC00U + ((code - 0x10000U) & 0x3FFU));
        }
    }
    to += '"';
}

} // namespace

JsonDocument::JsonDocument(std::string_view json, Pool& pool) : JsonDocument(pool) {
    HRBFNPR_ASSERT(json.size() <= settings_tuning.most_bytes); // Positions in the texts have 32 bits.
    JsonEvents events(*this);
    nlohmann::json::sax_parse(json.begin(), json.end(), &events);
}

JsonItem& JsonDocument::push(JsonKind kind) {
    JsonItem item;
    item.kind = kind;
    item.key_begin = next_key_begin_;
    item.key_size = next_key_size_;
    next_key_begin_ = next_key_size_ = 0;
    item.end = static_cast<std::uint32_t>(items_.size()) + 1;
    return items_.emplace_back(item);
}

JsonDocument& JsonDocument::key(std::string_view key) {
    next_key_begin_ = static_cast<std::uint32_t>(texts_.size());
    next_key_size_ = static_cast<std::uint32_t>(key.size());
    texts_ += key;
    return *this;
}

void JsonDocument::add_null() { push(JsonKind::null); }

void JsonDocument::add_bool(bool value) { push(JsonKind::boolean).magnitude = value ? 1 : 0; }

void JsonDocument::add_number(double value) {
    HRBFNPR_ASSERT(std::isfinite(value));
    push(JsonKind::real).number = value;
}

void JsonDocument::add_whole(bool is_negative, std::uint64_t magnitude) {
    JsonItem& item = push(JsonKind::whole);
    item.is_negative = is_negative;
    item.magnitude = magnitude;
    item.number = is_negative ? -static_cast<double>(magnitude) : static_cast<double>(magnitude);
}

void JsonDocument::add_text(std::string_view value) {
    JsonItem& item = push(JsonKind::text);
    item.text_begin = static_cast<std::uint32_t>(texts_.size());
    item.text_size = static_cast<std::uint32_t>(value.size());
    texts_ += value;
}

void JsonDocument::begin(JsonKind kind) {
    HRBFNPR_ASSERT(kind == JsonKind::list || kind == JsonKind::object);
    open_.push_back(static_cast<std::uint32_t>(items_.size()));
    push(kind);
}

void JsonDocument::end() {
    HRBFNPR_ASSERT(!open_.empty());
    items_[open_.back()].end = static_cast<std::uint32_t>(items_.size());
    open_.pop_back();
}

std::string_view JsonDocument::key_of(const JsonItem& item) const noexcept {
    return std::string_view(texts_).substr(item.key_begin, item.key_size);
}

std::string_view JsonDocument::text_of_item(const JsonItem& item) const noexcept {
    return std::string_view(texts_).substr(item.text_begin, item.text_size);
}

void JsonDocument::write_scalar(String& to, const JsonItem& item) const {
    switch (item.kind) {
    case JsonKind::null: to += "null"; return;
    case JsonKind::boolean: to += item.magnitude != 0 ? "true" : "false"; return;
    case JsonKind::whole: return append_whole(to, item.is_negative, item.magnitude);
    case JsonKind::real: return append_decimals(to, item.number);
    default: return append_quoted(to, text_of_item(item));
    }
}

void JsonDocument::write_key(String& to, const JsonItem& item) const {
    append_quoted(to, key_of(item));
    to += ": ";
}

void JsonDocument::write_line(String& to, std::size_t number) const {
    const JsonItem& item = items_[number];
    if (item.kind != JsonKind::list && item.kind != JsonKind::object) return write_scalar(to, item);
    const bool is_object = item.kind == JsonKind::object;
    to += is_object ? '{' : '[';
    for (std::size_t part = number + 1; part < item.end; part = items_[part].end) {
        if (part > number + 1) to += ", ";
        if (is_object) write_key(to, items_[part]);
        write_line(to, part);
    }
    to += is_object ? '}' : ']';
}

void JsonDocument::write(String& to, std::size_t number, std::size_t indent) const {
    constexpr std::size_t deepest = 4; // Values whose indent is larger, in spaces, are written in one line.
    const JsonItem& item = items_[number];
    bool has_deep_parts = false;
    for (std::size_t part = number + 1; part < item.end; part = items_[part].end)
        has_deep_parts |= items_[part].kind == JsonKind::list || items_[part].kind == JsonKind::object;
    if (!has_deep_parts || indent > deepest) return write_line(to, number);
    const bool is_object = item.kind == JsonKind::object;
    to += is_object ? '{' : '[';
    for (std::size_t part = number + 1; part < item.end; part = items_[part].end) {
        to += part > number + 1 ? ",\n" : "\n";
        to.append(indent + 2, ' ');
        if (is_object) write_key(to, items_[part]);
        write(to, part, indent + 2);
    }
    to += '\n';
    to.append(indent, ' ');
    to += is_object ? '}' : ']';
}

std::size_t JsonValue::size() const noexcept {
    std::size_t count = 0;
    for (Iterator part = begin(); part != end(); ++part) ++count;
    return count;
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const noexcept {
    std::optional<JsonValue> found;
    if (kind() != JsonKind::object) return found;
    for (const JsonValue part : *this)
        if (part.key() == key) found = part;
    return found;
}

String JsonValue::in_short(std::size_t most, Pool& pool) const {
    String line(&pool);
    document_->write_line(line, item_);
    line.resize(std::min(line.size(), most));
    return line;
}

} // namespace hrbfnpr::picture
