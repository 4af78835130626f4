// SPDX-License-Identifier: MIT
#include "kernel/kernel.h"

#include "kernel/radial.h"

namespace hrbfnpr::kernel {

Radial radial(Kind kind, double radius, double r) noexcept {
    return with_kernel(kind, radius, [r](const auto& kernel) { return kernel.template at<2>(r * r, r); });
}

double radial_fourth(Kind kind, double radius, double r) noexcept {
    if (kind == Kind::gaussian) return -kernel::radial(kind, radius, r).c / (radius * radius);
    const double inverse = 1.0 / r;
    const double inverse2 = inverse * inverse;
    const double inverse5 = inverse2 * inverse2 * inverse;
    if (kind == Kind::triharmonic) return 9.0 * inverse5;
    const double s = r / radius;
    return s < 1.0 ? 60.0 / (radius * radius * radius) * (3.0 - s * s) * inverse5 : 0.0;
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
