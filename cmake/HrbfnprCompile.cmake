# SPDX-License-Identifier: MIT
# hrbfnpr_compile(target) sets how the library's code is compiled.

add_library(hrbfnpr_options INTERFACE)
target_compile_features(hrbfnpr_options INTERFACE cxx_std_20)
target_include_directories(hrbfnpr_options INTERFACE
  "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/src")
# GLM, Highway and nlohmann's JSON are system headers. Folders that the compiler searches anyway are left out, because
# -isystem /usr/include breaks #include_next.
foreach(folder IN ITEMS "${HRBFNPR_GLM_INCLUDE_DIR}" "${HRBFNPR_HIGHWAY_INCLUDE_DIR}" "${HRBFNPR_JSON_INCLUDE_DIR}")
  if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    target_include_directories(hrbfnpr_options SYSTEM INTERFACE "${folder}")
  endif()
endforeach()
target_link_libraries(hrbfnpr_options INTERFACE Eigen3::Eigen)
target_compile_definitions(hrbfnpr_options INTERFACE
  EIGEN_DONT_PARALLELIZE EIGEN_MPL2_ONLY)

# -ffp-contract=off: vector loops and their remainders give the same bits.
# -fno-math-errno: square roots are inlined; the library never reads errno.
target_compile_options(hrbfnpr_options INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off;-fno-math-errno;-fno-trapping-math>)

set(HRBFNPR_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  -Wnon-virtual-dtor -Wold-style-cast -Wcast-align -Woverloaded-virtual -Wnull-dereference
  -Wformat=2 -Wimplicit-fallthrough)
set(HRBFNPR_GCC_WARNINGS -Wdouble-promotion -Wduplicated-cond -Wlogical-op)
# Below 1 GiB, GCC's garbage collector stays off. It took a twelfth of the compile time.
set(HRBFNPR_GCC_MEMORY --param=ggc-min-heapsize=1048576)

function(hrbfnpr_compile target)
  target_link_libraries(${target} PRIVATE hrbfnpr_options)
  if(NOT EMSCRIPTEN) # WebAssembly modules are linked statically
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  set_target_properties(${target} PROPERTIES
    CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden
    C_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:${HRBFNPR_WARNINGS}>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:${HRBFNPR_GCC_WARNINGS}>
    $<$<AND:$<BOOL:${HRBFNPR_UNITY}>,$<COMPILE_LANG_AND_ID:CXX,GNU>>:${HRBFNPR_GCC_MEMORY}>
    $<$<BOOL:${HRBFNPR_WERROR}>:$<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Werror>>)
  hrbfnpr_instrument(${target})
endfunction()

# Test code is compiled with -Og, because full optimization would take half of the build time. The library under test is
# optimized in full. Tests run too slowly with -O0, and -O1 takes a fifth longer to compile.
function(hrbfnpr_compile_test target)
  target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-Og>)
endfunction()

# Sanitizers apply to the library and to everything that links it. Coverage is counted only in the rooms.
function(hrbfnpr_instrument target)
  if(HRBFNPR_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${HRBFNPR_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${HRBFNPR_SANITIZE})
  endif()
  if(HRBFNPR_COVERAGE)
    target_link_options(${target} PRIVATE --coverage)
  endif()
endfunction()
