// SPDX-License-Identifier: MIT
// Loads a point set and uses it: drawn, written as vertices, saved and loaded again.
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fuzz;
    const Bytes file = signed_file(data, size);
    Context context;
    auto* const set = load<hrbfnpr_point_set>(context, file, hrbfnpr_point_set_load_memory);
    if (set == nullptr) return 0;
    require_sound_marks(set);
    require_same_set(context, set);
    draw(context, set, choice_of(file));
    hrbfnpr_point_set_release(set);
    return 0;
}
