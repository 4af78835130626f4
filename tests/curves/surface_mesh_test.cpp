// SPDX-License-Identifier: MIT
#include "curves/surface_mesh.h"

#include <gtest/gtest.h>
