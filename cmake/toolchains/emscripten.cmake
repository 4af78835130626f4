# SPDX-License-Identifier: MIT
# Finds and includes Emscripten's toolchain file, and sets the flags that all code needs.
find_program(HRBFNPR_EM_CONFIG em-config REQUIRED NO_CMAKE_FIND_ROOT_PATH)
execute_process(COMMAND "${HRBFNPR_EM_CONFIG}" EMSCRIPTEN_ROOT
  OUTPUT_VARIABLE emscripten OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

# Header-only packages come from the build machine. By default Emscripten searches only its own folder.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
list(APPEND CMAKE_PREFIX_PATH /usr/local /usr)
include("${emscripten}/cmake/Modules/Platform/Emscripten.cmake")

# Use WebAssembly exceptions. Exceptions emulated in JavaScript would slow down every call in a function that has objects
# to destroy.
set(flags "-msimd128 -fwasm-exceptions")
if(HRBFNPR_WASM_THREADS)
  string(APPEND flags " -pthread")
endif()
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags}")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES HRBFNPR_WASM_THREADS)
