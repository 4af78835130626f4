# SPDX-License-Identifier: MIT
# Emscripten's own toolchain file, wherever that is installed, and how all code has to be compiled for it.
find_program(HRBFNPR_EM_CONFIG em-config REQUIRED NO_CMAKE_FIND_ROOT_PATH)
execute_process(COMMAND "${HRBFNPR_EM_CONFIG}" EMSCRIPTEN_ROOT
  OUTPUT_VARIABLE emscripten OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

# Packages of headers are those of the machine that builds; Emscripten's file would look in its own folder only.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE BOTH)
list(APPEND CMAKE_PREFIX_PATH /usr/local /usr)
include("${emscripten}/cmake/Modules/Platform/Emscripten.cmake")

# WebAssembly's own exceptions: those that are emulated in JavaScript make a detour for every call in a function with
# something to destroy.
set(flags "-msimd128 -fwasm-exceptions")
if(HRBFNPR_WASM_THREADS)
  string(APPEND flags " -pthread")
endif()
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags}")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES HRBFNPR_WASM_THREADS)
