#include "geometry/cell_map.h"

#include "geometry/cell_set.h"

#include <bit>

namespace hrbfnpr::geometry {

CellMap::CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes) : CellMap(memory) {
    const auto places = static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(2 * codes.size() + 2)));
    code_.resize(places);
    number_.resize(places);
    for (std::int64_t i = 0; i < codes.size(); ++i) {
        const std::int64_t at = place(codes[i]);
        code_[at] = codes[i] + 1;
        number_[at] = static_cast<std::int32_t>(i);
    }
}

// Where the code stands, or the free place where it would.
std::int64_t CellMap::place(std::uint64_t code) const noexcept {
    const auto mask = static_cast<std::uint64_t>(code_.size() - 1);
    std::uint64_t at = mixed_bits(code) & mask;
    while (code_[static_cast<std::int64_t>(at)] != 0 && code_[static_cast<std::int64_t>(at)] != code + 1)
        at = (at + 1) & mask;
    return static_cast<std::int64_t>(at);
}

std::int32_t CellMap::find(std::uint64_t code) const noexcept {
    if (code_.empty()) return -1;
    const std::int64_t at = place(code);
    return code_[at] == 0 ? -1 : number_[at];
}

} // namespace hrbfnpr::geometry
