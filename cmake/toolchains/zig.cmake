# SPDX-License-Identifier: MIT
# Builds with the clang of Zig's toolchain, which brings the C library's interfaces and a static libc++ for many systems.
#   HRBFNPR_ZIG          the program `zig`; by default the one in the PATH
#   HRBFNPR_ZIG_TARGET   the target, such as x86_64-linux-gnu.2.17: glibc 2.17 or newer
if(NOT HRBFNPR_ZIG)
  find_program(HRBFNPR_ZIG zig REQUIRED NO_CMAKE_FIND_ROOT_PATH)
endif()
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES HRBFNPR_ZIG HRBFNPR_ZIG_TARGET)
string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR "${HRBFNPR_ZIG_TARGET}")
if(HRBFNPR_ZIG_TARGET MATCHES "macos")
  set(CMAKE_SYSTEM_NAME Darwin)
  set(CMAKE_SYSTEM_VERSION 20) # macOS 11
  set(HRBFNPR_LINK_RULE "\"${CMAKE_CURRENT_LIST_DIR}/link_macos\" \"${HRBFNPR_ZIG}\" ${HRBFNPR_ZIG_TARGET} \"${CMAKE_CURRENT_LIST_DIR}/../../src/hrbfnpr.exports\" <TARGET_INSTALLNAME_DIR><TARGET_SONAME> <TARGET> <OBJECTS>")
else()
  set(CMAKE_SYSTEM_NAME Linux)
endif()

# CMake and compiler caches expect a compiler to be one program.
set(wrappers "${CMAKE_BINARY_DIR}/zig")
foreach(tool IN ITEMS cc c++ ar ranlib)
  set(options "")
  if(tool MATCHES "^c")
    set(options "-target ${HRBFNPR_ZIG_TARGET} ")
  endif()
  file(CONFIGURE OUTPUT "${wrappers}/${tool}" @ONLY
    CONTENT "#!/bin/sh\nexec '${HRBFNPR_ZIG}' ${tool} ${options}\"\$@\"\n")
  file(CHMOD "${wrappers}/${tool}"
    PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
set(CMAKE_C_COMPILER "${wrappers}/cc")
set(CMAKE_CXX_COMPILER "${wrappers}/c++")
set(CMAKE_AR "${wrappers}/ar" CACHE FILEPATH "")
set(CMAKE_RANLIB "${wrappers}/ranlib" CACHE FILEPATH "")
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64" AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
  include("${CMAKE_CURRENT_LIST_DIR}/qemu_arm64.cmake")
endif()
include("${CMAKE_CURRENT_LIST_DIR}/header_only.cmake")
