# SPDX-License-Identifier: MIT
# Runs arm64 programs under qemu's user emulation. It does not keep the sequential consistency of atomic operations between
# threads, so programs get a single processor.
find_program(HRBFNPR_QEMU NAMES qemu-aarch64-static qemu-aarch64 NO_CMAKE_FIND_ROOT_PATH)
mark_as_advanced(HRBFNPR_QEMU)
if(HRBFNPR_QEMU AND NOT CMAKE_HOST_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  set(CMAKE_CROSSCOMPILING_EMULATOR "env;QEMU_LD_PREFIX=/usr/aarch64-linux-gnu;taskset;-c;0;${HRBFNPR_QEMU}")
endif()
