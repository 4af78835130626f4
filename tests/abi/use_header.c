/* SPDX-License-Identifier: MIT */
/* This file is compiled on its own in every C and C++ standard that the header supports. */
#include <hrbfnpr.h>

int main(void) {
    hrbfnpr_style style;
    hrbfnpr_array array = {0, 0, 0, HRBFNPR_SCALAR_FLOAT32, 3};
    return hrbfnpr_style_init(&style, (uint32_t)sizeof style) == HRBFNPR_STATUS_OK && array.count == 0 ? 0 : 1;
}
