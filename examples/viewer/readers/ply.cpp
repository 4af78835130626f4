// SPDX-License-Identifier: MIT
// PLY: ASCII, and binary in both byte orders.
#include "shape.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <sstream>

namespace viewer {

namespace {

enum class Form { ascii, little, big };

struct Property {
    std::string name;
    std::size_t size = 0; // bytes
    char kind = 'f';      // i signed, u unsigned, f floating
    bool is_list = false;
    std::size_t count_size = 0; // bytes of a list's unsigned length
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    Form form = Form::ascii;
    std::vector<Element> elements;
    std::size_t end = 0;   // offset of the data
    std::size_t lines = 0; // number of lines of the header
};

bool set_type(Property& property, std::string_view type, Lines& lines) {
    static const struct {
        const char *name, *other;
        std::size_t size;
        char kind;
    } types[] = {{"char", "int8", 1, 'i'},     {"uchar", "uint8", 1, 'u'},   {"short", "int16", 2, 'i'},
                 {"ushort", "uint16", 2, 'u'}, {"int", "int32", 4, 'i'},     {"uint", "uint32", 4, 'u'},
                 {"float", "float32", 4, 'f'}, {"double", "float64", 8, 'f'}};
    for (const auto& each : types)
        if (type == each.name || type == each.other) {
            property.size = each.size;
            property.kind = each.kind;
            return true;
        }
    lines.refuse("\"" + std::string(type) + "\" is not a type of PLY");
}

Property property_of(const std::vector<std::string_view>& words, Lines& lines) {
    Property property;
    property.is_list = words.size() == 5 && words[1] == "list";
    if (!property.is_list && words.size() != 3) lines.refuse("a property must have a type and a name");
    if (property.is_list) {
        set_type(property, words[2], lines);
        property.count_size = property.size;
        if (property.kind == 'f') lines.refuse("the length of a list must have a whole-number type");
    }
    set_type(property, words[words.size() - 2], lines);
    property.name = words.back();
    return property;
}

Header header_of(const std::string& data) {
    Header header;
    Lines lines(data);
    std::string_view line;
    while (lines.next(line)) {
        const auto words = words_of(line);
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info" || words[0] == "ply") continue;
        if (words[0] == "end_header") {
            header.end = lines.offset();
            header.lines = lines.number();
            return header;
        }
        if (words[0] == "format" && words.size() >= 2) {
            if (words[1] == "ascii")
                header.form = Form::ascii;
            else if (words[1] == "binary_little_endian")
                header.form = Form::little;
            else if (words[1] == "binary_big_endian")
                header.form = Form::big;
            else
                lines.refuse("\"" + std::string(words[1]) + "\" is not a format of PLY");
        } else if (words[0] == "element" && words.size() == 3) {
            std::int64_t count = -1;
            if (!parse_number(words[2], count) || count < 0) lines.refuse("an element must have a name and a number");
            header.elements.push_back({std::string(words[1]), static_cast<std::size_t>(count), {}});
        } else if (words[0] == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(property_of(words, lines));
        } else {
            lines.refuse("\"" + std::string(words[0]) + "\" is not understood in the header");
        }
    }
    throw Failure("its header has no end; the file is cut off");
}

// Reads numbers one after the other, from text or bytes.
class Source {
public:
    Source(const std::string& data, const Header& header)
        : data_(data), form_(header.form), at_(header.end), lines_(std::string_view(data).substr(header.end)),
          header_lines_(header.lines) {}

    void begin_row(const std::string& what, std::size_t number) {
        what_ = &what;
        row_ = number;
        if (form_ != Form::ascii) return;
        std::string_view line;
        do {
            if (!lines_.next(line)) refuse("the file ends before it");
            words_ = words_of(line);
        } while (words_.empty());
        word_ = 0;
    }

    double number(std::size_t size, char kind) {
        if (form_ != Form::ascii) return bytes(size, kind);
        double value = 0;
        if (word_ >= words_.size()) refuse("the line is too short");
        if (!parse_number(words_[word_], value)) refuse("\"" + std::string(words_[word_]) + "\" is not a number");
        ++word_;
        return value;
    }

    [[noreturn]] void refuse(const std::string& what) const {
        std::ostringstream where;
        if (form_ == Form::ascii) where << "line " << header_lines_ + lines_.number() << ", ";
        where << *what_ << " " << row_ << ": " << what;
        throw Failure(where.str());
    }

private:
    double bytes(std::size_t size, char kind) {
        if (data_.size() - at_ < size) refuse("the file ends before it");
        std::array<unsigned char, 8> raw{};
        std::memcpy(raw.data(), data_.data() + at_, size);
        at_ += size;
        const bool turns = (form_ == Form::big) == (std::endian::native == std::endian::little);
        if (turns) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
        const auto as = [&](auto value) {
            std::memcpy(&value, raw.data(), sizeof value);
            return static_cast<double>(value);
        };
        if (kind == 'f') return size == 4 ? as(float{}) : as(double{});
        if (size == 1) return kind == 'i' ? as(std::int8_t{}) : as(std::uint8_t{});
        if (size == 2) return kind == 'i' ? as(std::int16_t{}) : as(std::uint16_t{});
        return kind == 'i' ? as(std::int32_t{}) : as(std::uint32_t{});
    }

    const std::string& data_;
    Form form_;
    std::size_t at_;
    Lines lines_;
    std::size_t header_lines_;
    const std::string* what_ = nullptr;
    std::size_t row_ = 0, word_ = 0;
    std::vector<std::string_view> words_;
};

std::vector<std::int64_t> list_of(Source& source, const Property& property) {
    const double count = source.number(property.count_size, 'u');
    if (!(count >= 0 && count <= 1e6)) source.refuse("a list can have at most 1000000 elements");
    std::vector<std::int64_t> list;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const double value = source.number(property.size, property.kind);
        list.push_back(std::isfinite(value) && std::abs(value) < 1e15 ? static_cast<std::int64_t>(value) : -1);
    }
    return list;
}

void read_row(Source& source, const Element& element, Shape& shape, std::size_t vertices) {
    static const char* const names[] = {"x", "y", "z", "nx", "ny", "nz"};
    std::array<double, 6> values{};
    unsigned found = 0;
    for (const Property& property : element.properties) {
        if (property.is_list) {
            const auto list = list_of(source, property);
            if (element.name == "face" && property.name.rfind("vertex_ind", 0) == 0)
                add_polygon(shape, list, vertices, [&](const std::string& what) { source.refuse(what); });
            continue;
        }
        const double value = source.number(property.size, property.kind);
        for (unsigned k = 0; k < 6; ++k)
            if (property.name == names[k]) values[k] = value, found |= 1U << k;
    }
    if (element.name != "vertex") return;
    if ((found & 7U) != 7U) source.refuse("vertices need the properties x, y and z");
    shape.points.push_back({values[0], values[1], values[2]});
    if (found == 63U) shape.normals.push_back({values[3], values[4], values[5]});
}

} // namespace

Shape read_ply(const std::string& data) {
    const Header header = header_of(data);
    Source source(data, header);
    Shape shape;
    shape.format = "PLY";
    std::size_t vertices = 0;
    for (const Element& element : header.elements)
        if (element.name == "vertex") vertices = element.count;
    for (const Element& element : header.elements)
        for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row) {
            source.begin_row(element.name, row);
            read_row(source, element, shape, vertices);
        }
    return shape;
}

} // namespace viewer
