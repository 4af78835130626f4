// SPDX-License-Identifier: MIT
// Fields from any source, and point sets that have their values.
#pragma once

#include "input.h"

#include <hrbfnpr.h>

#include <array>
#include <vector>

namespace fuzz {

// The name of the field of each kind, HRBFNPR_FIELD_KIND_.
inline constexpr std::array<const char*, 3> field_names{"number", "colour", "way"};

// A field of each kind. Some may be refused.
class Paint {
public:
    explicit Paint(Input& input);
    Paint(const Paint&) = delete;
    Paint& operator=(const Paint&) = delete;
    ~Paint();

    // Returns a set with the values of all fields, which lives as long as this object. Returns `set` if it is refused.
    const hrbfnpr_point_set* on(const hrbfnpr_point_set* set, Input& input);

    // What a function of the caller does.
    struct Function {
        std::uint32_t components;
        std::size_t oddity; // 0 to 3: it gives weights, a value that is not finite, a wrong weight, or fails
    };

private:
    std::array<Function, 3> functions_{};
    std::array<const hrbfnpr_field*, 3> fields_{};
    std::vector<const hrbfnpr_point_set*> sets_;
};

} // namespace fuzz
