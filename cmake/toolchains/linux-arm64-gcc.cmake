# SPDX-License-Identifier: MIT
# Linux on arm64, by GCC's cross compiler of Debian (g++-aarch64-linux-gnu). Tests run under qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
include("${CMAKE_CURRENT_LIST_DIR}/qemu_arm64.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/header_only.cmake")
