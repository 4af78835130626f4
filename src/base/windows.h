// SPDX-License-Identifier: MIT
// The header of Windows, without most of its macros. Only files of src/base include it.
#pragma once

#define WIN32_LEAN_AND_MEAN
#if !defined(NOMINMAX)
#define NOMINMAX
#endif
#include <windows.h>
