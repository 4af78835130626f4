# SPDX-License-Identifier: MIT
# Windows on x86-64, by the cross compiler MinGW-w64 of Debian (g++-mingw-w64-x86-64-posix). Tests run under Wine.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
find_program(HRBFNPR_WINE NAMES wine wine64 NO_CMAKE_FIND_ROOT_PATH)
mark_as_advanced(HRBFNPR_WINE)
if(HRBFNPR_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR "env;WINEDEBUG=-all;${HRBFNPR_WINE}")
endif()
include("${CMAKE_CURRENT_LIST_DIR}/header_only.cmake")
