// SPDX-License-Identifier: MIT
#include "fields.h"

#include "fuzz.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace fuzz {
namespace {

struct Field {
    std::string name;
    std::string type; // type of an element
    std::size_t offset;
    std::size_t count; // number of elements
};

// Returns the text that follows "KEY": in a JSON object of the library, from `at` on, without the quotes of a string.
std::string value_of(std::string_view text, std::string_view key, std::size_t at) {
    const std::size_t from = text.find(key, at) + key.size();
    const bool quoted = text[from] == '"';
    const std::size_t begin = quoted ? from + 1 : from;
    return std::string(text.substr(begin, text.find_first_of(quoted ? "\"" : ",}", begin) - begin));
}

bool ends_with(std::string_view name, std::string_view end) {
    return name.size() >= end.size() && name.substr(name.size() - end.size()) == end;
}

// Addresses, counts and strides of lists must not be changed.
bool is_changeable(const Field& field) {
    static constexpr std::string_view types[] = {"uint32_t",   "int32_t", "uint64_t",      "int64_t",
                                                 "float",      "double",  "hrbfnpr_array", "hrbfnpr_array_out",
                                                 "const char*"};
    return std::find(std::begin(types), std::end(types), field.type) != std::end(types) &&
           !ends_with(field.name, "_count") && !ends_with(field.name, "stride");
}

std::vector<Field> read_fields(const char* name) {
    const char* const layout = hrbfnpr_layout(name);
    require(layout != nullptr, "every struct has a layout");
    const std::string_view text(layout);
    std::vector<Field> fields;
    for (std::size_t at = text.find("\"fields\""); (at = text.find("{\"name\"", at)) != std::string_view::npos; ++at) {
        Field field{value_of(text, "\"name\": ", at), value_of(text, "\"type\": ", at),
                    std::stoull(value_of(text, "\"offset\": ", at)), 1};
        if (const std::size_t bracket = field.type.find('['); bracket != std::string::npos) {
            field.count = std::stoull(field.type.substr(bracket + 1));
            field.type.resize(bracket);
        }
        if (is_changeable(field)) fields.push_back(field);
    }
    require(!fields.empty(), "a layout names fields");
    return fields;
}

const std::vector<Field>& fields_of(const char* name) {
    static std::mutex mutex; // references stay valid when entries are added
    static std::map<std::string, std::vector<Field>, std::less<>> known;
    const std::lock_guard lock(mutex);
    const auto found = known.find(name);
    return found != known.end() ? found->second : known.emplace(name, read_fields(name)).first->second;
}

template <class T>
T some_float(T now, Input& input) {
    static constexpr double usual[] = {0, 1, 0.5, 2, 3, 10, 0.1, 0.01, 1e-3, 100, 45, 90, 180, -1, -0.5, 1e4};
    switch (input.below(4)) {
    case 0: return static_cast<T>(input.one_of(usual));
    case 1: return static_cast<T>(input.unit());
    case 2: return static_cast<T>(static_cast<double>(now) * input.between(0.0, 4.0));
    default: return odd_float(now, static_cast<T>(input.unit()), input);
    }
}

template <class T>
T some_integer(T now, Input& input) {
    if (input.below(4) != 3) return static_cast<T>(input.below(20)); // most are enumerators, flags and small numbers
    return odd_integer(now, T(0), input);
}

template <class T, class Change>
void change_in_place(void* at, Change change) {
    T now;
    std::memcpy(&now, at, sizeof now);
    now = change(now);
    std::memcpy(at, &now, sizeof now);
}

// Never makes the library read past the array: more components are refused, and doubles may be read as floats.
template <class Array>
Array smaller_array(Array array, Input& input) {
    switch (input.below(9)) {
    case 0: array.count -= std::min<std::int64_t>(array.count, static_cast<std::int64_t>(input.below(8))); break;
    case 1: array.count = 0; break;
    case 2: array = {}; break;
    case 3: array.data = nullptr; break;
    case 4: array.count = -static_cast<std::int64_t>(input.below(3)) - 1; break;
    case 5: array.count = std::numeric_limits<std::int64_t>::max() - static_cast<std::int64_t>(input.below(3)); break;
    case 6: array.components = static_cast<std::uint32_t>(input.below(6)); break;
    case 7: array.scalar = input.once_in(2) ? 99U : 0U; break;
    default:
        if (array.scalar == HRBFNPR_SCALAR_FLOAT64) array.scalar = HRBFNPR_SCALAR_FLOAT32;
    }
    return array;
}

// Returns the size of an older struct, of one without _init, or of one that ends within a field.
std::uint32_t shorter_struct(std::uint32_t size, Input& input) {
    const std::uint32_t sizes[] = {0, 4, 7, 8, 16, size / 2, size / 2 / 8 * 8, size - 8, size - 4, 1U << 30U};
    const std::uint32_t chosen = input.one_of(sizes);
    return chosen > size && chosen < 1U << 17U ? size : chosen;
}

void change_field(const Field& field, unsigned char* desc, Input& input) {
    unsigned char* const first = desc + field.offset;
    if (field.name == "struct_size") {
        if (input.once_in(2))
            change_in_place<std::uint32_t>(first, [&](auto now) { return shorter_struct(now, input); });
        return;
    }
    const std::size_t element = input.below(field.count);
    const auto edit = [&]<class T>(T) {
        change_in_place<T>(first + element * sizeof(T), [&](T now) {
            if constexpr (std::is_floating_point_v<T>)
                return some_float(now, input);
            else
                return some_integer(now, input);
        });
    };
    if (field.type == "uint32_t") edit(std::uint32_t{});
    if (field.type == "int32_t") edit(std::int32_t{});
    if (field.type == "uint64_t") edit(std::uint64_t{});
    if (field.type == "int64_t") edit(std::int64_t{});
    if (field.type == "float") edit(float{});
    if (field.type == "double") edit(double{});
    if (field.type == "const char*") change_in_place<const char*>(first, [&](auto) { return odd_words(input); });
    if (field.type == "hrbfnpr_array")
        change_in_place<hrbfnpr_array>(first, [&](auto now) { return smaller_array(now, input); });
    if (field.type == "hrbfnpr_array_out")
        change_in_place<hrbfnpr_array_out>(first, [&](auto now) { return smaller_array(now, input); });
}

} // namespace

void change_fields(Input& input, const char* name, void* desc, std::initializer_list<std::string_view> kept) {
    static constexpr int changes[] = {0, 0, 1, 1, 2, 3, 1, 6};
    const std::vector<Field>& fields = fields_of(name);
    for (int left = input.one_of(changes); left > 0; --left) {
        const Field& field = fields[input.below(fields.size())];
        if (std::find(kept.begin(), kept.end(), field.name) == kept.end())
            change_field(field, static_cast<unsigned char*>(desc), input);
    }
}

const char* odd_words(Input& input) {
    static const std::string lengths[] = {std::string(63, 'n'), std::string(64, 'n'),  std::string(95, 'n'),
                                          std::string(96, 'n'), std::string(300, 'n'), std::string(5000, 'n')};
    static constexpr const char* words[] = {nullptr,
                                            "",
                                            "a",
                                            "stipples",
                                            "*",
                                            "hatch*",
                                            "contour",
                                            "contour hidden 1",
                                            "annotations",
                                            "<g id=\"1\">&amp;</g>",
                                            "]]>--><!--",
                                            "(\\) Tj",
                                            "\x01\x02\x1f",
                                            "line\nline\r\ttab",
                                            "\xff\xfe",
                                            "\xc3",
                                            "\xed\xa0\x80",
                                            "\xf4\x90\x80\x80",
                                            "Tusche f\xc3\xbcr \xe2\x82\xac \xf0\x9f\x96\x8b",
                                            "\xef\xbf\xbf",
                                            "%n%s%f",
                                            ";PU0,0;SP2;"};
    const std::size_t which = input.below(std::size(words) + std::size(lengths));
    return which < std::size(words) ? words[which] : lengths[which - std::size(words)].c_str();
}

} // namespace fuzz
