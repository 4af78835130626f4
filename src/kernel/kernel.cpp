// SPDX-License-Identifier: MIT
#include "kernel/kernel.h"

#include "kernel/radial.h"

namespace hrbfnpr::kernel {

Radial radial(Kind kind, double radius, double r) noexcept {
    return with_kernel(kind, radius, [r](const auto& kernel) { return kernel.template at<2>(r * r, r); });
}

const char* name(Kind kind) noexcept {
    switch (kind) {
    case Kind::triharmonic: return "triharmonic";
    case Kind::gaussian: return "gaussian";
    case Kind::wendland_c2: return "wendland_c2";
    }
    return "unknown";
}

} // namespace hrbfnpr::kernel
