// SPDX-License-Identifier: MIT
// A libFuzzer mutator for files. Half of the time it makes one number of a section odd, since arbitrary bytes seldom
// do; otherwise libFuzzer mutates the file. Mostly the length of the payload is then corrected.
#include "fuzz.h"
#include "odd.h"
#include "random.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);

namespace {

using namespace hrbfnpr::io;
using fuzz::Random;

struct Section {
    std::size_t begin; // start of its elements
    std::size_t count;
    ElementType type;
};

std::size_t size_of(ElementType type) {
    switch (type) {
    case ElementType::float32:
    case ElementType::uint32: return 4;
    case ElementType::float64:
    case ElementType::int64: return 8;
    case ElementType::uint8: return 1;
    }
    return 0;
}

std::vector<Section> sections_of(std::span<const std::uint8_t> file) {
    std::vector<Section> sections;
    std::size_t at = header_size;
    while (at + section_header_size < file.size()) {
        const auto type = static_cast<ElementType>(fetch<std::uint32_t>(&file[at + 4]));
        const auto count = fetch<std::uint64_t>(&file[at + 8]);
        const std::size_t size = size_of(type);
        at += section_header_size;
        if (size == 0 || count > (file.size() - at) / size) break;
        if (count > 0) sections.push_back({at, static_cast<std::size_t>(count), type});
        at += static_cast<std::size_t>(count) * size;
    }
    return sections;
}

template <class T>
void change(std::uint8_t* elements, std::size_t count, Random& random) {
    std::uint8_t* const at = elements + random.below(count) * sizeof(T);
    const T now = fetch<T>(at);
    const T other = fetch<T>(elements + random.below(count) * sizeof(T));
    if constexpr (std::is_floating_point_v<T>)
        store(at, fuzz::odd_float(now, other, random));
    else
        store(at, fuzz::odd_integer(now, other, random));
}

void change(std::uint8_t* file, const Section& section, Random& random) {
    std::uint8_t* const elements = file + section.begin;
    switch (section.type) {
    case ElementType::float32: change<float>(elements, section.count, random); break;
    case ElementType::float64: change<double>(elements, section.count, random); break;
    case ElementType::uint8: change<std::uint8_t>(elements, section.count, random); break;
    case ElementType::uint32: change<std::uint32_t>(elements, section.count, random); break;
    case ElementType::int64: change<std::uint64_t>(elements, section.count, random); break;
    }
}

} // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
    Random random(seed);
    const std::vector<Section> sections = sections_of({data, size});
    if (!sections.empty() && random.below(2) == 0) {
        for (std::size_t edits = 1 + random.below(3); edits > 0; --edits)
            change(data, sections[random.below(sections.size())], random);
        return size;
    }
    size = LLVMFuzzerMutate(data, size, max_size);
    if (size >= header_size + 4 && random.below(8) != 0)
        store(data + 24, static_cast<std::uint64_t>(size - header_size - 4));
    return size;
}
