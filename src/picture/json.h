// SPDX-License-Identifier: MIT
// Stores a JSON document as a single list of values in document order, in the context's memory.
#pragma once

#include "picture/memory.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace hrbfnpr::picture {

enum class JsonKind : std::uint8_t { null, boolean, whole, real, text, list, object };

// A value of a document. The members of a list or object follow the list or object itself in the document's list of
// values.
struct JsonItem {
    JsonKind kind = JsonKind::null;
    bool is_negative = false;    // Only set for whole numbers.
    std::uint32_t end = 0;       // The index of the first item after this item and all items nested in it.
    std::uint32_t key_begin = 0; // Where the key begins in the document's texts, if the item is a member of an object.
    std::uint32_t key_size = 0;
    std::uint64_t magnitude = 0;  // The magnitude of a whole number, or 1 for true.
    double number = 0.0;          // The value of a real or whole number.
    std::uint32_t text_begin = 0; // Where the content of a text begins in the document's texts.
    std::uint32_t text_size = 0;
};

class JsonValue;

class JsonDocument {
public:
    explicit JsonDocument(Pool& pool) : items_(&pool), texts_(&pool), open_(&pool) {}
    // Parses a document. Throws Error{invalid_argument} that names the place of a syntax error.
    JsonDocument(std::string_view json, Pool& pool);

    [[nodiscard]] JsonValue root() const noexcept;

    // These functions append values. In an object, key() must be called before each value.
    JsonDocument& key(std::string_view key);
    void add_null();
    void add_bool(bool value);
    void add_number(double value); // `value` must be finite.
    void add_whole(bool is_negative, std::uint64_t magnitude);
    void add_text(std::string_view value);
    void begin(JsonKind kind); // `kind` is list or object.
    void end();

    // Writes an item as Python's json.dumps does by default: in one line, in ASCII.
    void write_line(String& to, std::size_t item) const;
    // Writes an item. If its members include lists or objects, and its indent is not too large, each member begins a
    // new line. Otherwise write_line() writes the item.
    void write(String& to, std::size_t item, std::size_t indent) const;

private:
    friend class JsonValue;
    JsonItem& push(JsonKind kind);
    void write_scalar(String& to, const JsonItem& item) const;
    void write_key(String& to, const JsonItem& item) const;
    [[nodiscard]] std::string_view key_of(const JsonItem& item) const noexcept;
    [[nodiscard]] std::string_view text_of_item(const JsonItem& item) const noexcept;

    Vector<JsonItem> items_;
    String texts_;
    Vector<std::uint32_t> open_; // The lists and objects that are not complete yet.
    std::uint32_t next_key_begin_ = 0;
    std::uint32_t next_key_size_ = 0;
};

// A value of a complete document.
class JsonValue {
public:
    JsonValue(const JsonDocument& document, std::size_t item) noexcept : document_(&document), item_(item) {}

    [[nodiscard]] JsonKind kind() const noexcept { return item().kind; }
    [[nodiscard]] bool is_number() const noexcept { return kind() == JsonKind::whole || kind() == JsonKind::real; }
    [[nodiscard]] double number() const noexcept { return item().number; }
    [[nodiscard]] bool is_negative() const noexcept { return item().is_negative; }
    [[nodiscard]] std::uint64_t magnitude() const noexcept { return item().magnitude; }
    [[nodiscard]] std::string_view text() const noexcept { return document_->text_of_item(item()); }
    [[nodiscard]] std::string_view key() const noexcept { return document_->key_of(item()); }
    [[nodiscard]] std::size_t size() const noexcept; // Returns the number of members of a list or object.
    // Finds the last member of an object with this key.
    [[nodiscard]] std::optional<JsonValue> find(std::string_view key) const noexcept;
    // Returns the value in one line, truncated to `most` bytes.
    [[nodiscard]] String in_short(std::size_t most, Pool& pool) const;

    class Iterator {
    public:
        Iterator(const JsonDocument& document, std::size_t item) noexcept : document_(&document), item_(item) {}
        JsonValue operator*() const noexcept { return {*document_, item_}; }
        Iterator& operator++() noexcept {
            item_ = document_->items_[item_].end;
            return *this;
        }
        bool operator!=(const Iterator& other) const noexcept { return item_ != other.item_; }

    private:
        friend class JsonValue;
        const JsonDocument* document_;
        std::size_t item_;
    };
    // These iterate over the members of a list or an object.
    [[nodiscard]] Iterator begin() const noexcept { return {*document_, item_ + 1}; }
    [[nodiscard]] Iterator end() const noexcept { return {*document_, item().end}; }

private:
    [[nodiscard]] const JsonItem& item() const noexcept { return document_->items_[item_]; }

    const JsonDocument* document_;
    std::size_t item_;
};

inline JsonValue JsonDocument::root() const noexcept { return {*this, 0}; }

} // namespace hrbfnpr::picture
