// SPDX-License-Identifier: MIT
// Numbers that arbitrary bytes seldom contain, and that code seldom expects. A source has below(n), a number in 0 .. n
// - 1, and next(), 64 bits.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

namespace fuzz {

template <class T, class Source>
T odd_float(T now, T other, Source& source) {
    using limits = std::numeric_limits<T>;
    const T special[] = {T(0),
                         T(-0.0),
                         T(1),
                         T(-1),
                         limits::denorm_min(),
                         limits::min(),
                         limits::epsilon(),
                         limits::max(),
                         -limits::max(),
                         limits::infinity(),
                         limits::quiet_NaN(),
                         static_cast<T>(3.5e38),
                         static_cast<T>(1e99),
                         static_cast<T>(1e-99),
                         static_cast<T>(1e19),
                         static_cast<T>(1e-19)};
    switch (source.below(6)) {
    case 0: return std::nextafter(now, source.below(2) == 0 ? limits::max() : limits::lowest());
    case 1: return std::ldexp(now, static_cast<int>(source.below(129)) - 64);
    case 2: return -now;
    case 3: return other;
    default: return special[source.below(std::size(special))];
    }
}

template <class T, class Source>
T odd_integer(T now, T other, Source& source) {
    switch (source.below(5)) {
    case 0: return static_cast<T>(now + 1);
    case 1: return static_cast<T>(now - 1);
    case 2: return other;
    case 3: return static_cast<T>(source.next());
    default: return static_cast<T>(~T(0) >> source.below(8 * sizeof(T)));
    }
}

} // namespace fuzz
