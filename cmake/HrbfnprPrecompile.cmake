# SPDX-License-Identifier: MIT
# hrbfnpr_precompile(target SET) uses precompiled headers for a target. SET is src or tests.
#
# It applies only with HRBFNPR_PRECOMPILE=ON, as in the release preset, and with GCC or Clang. Other builds compile without
# precompiled headers, and so find missing includes.

set(HRBFNPR_PRECOMPILED_src <algorithm> <array> <atomic> <cmath> <cstdint> <cstring> <functional> <limits> <memory>
  <numeric> <optional> <span> <string> <vector> <glm/glm.hpp> <glm/gtc/matrix_transform.hpp>)
set(HRBFNPR_PRECOMPILED_tests ${HRBFNPR_PRECOMPILED_src} <map> <random> <set> <thread> <gmock/gmock.h> <gtest/gtest.h>)

function(hrbfnpr_precompile target set)
  if(NOT HRBFNPR_PRECOMPILE OR NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    return()
  endif()
  if(NOT TARGET hrbfnpr_precompiled_${set})
    if(set STREQUAL "tests") # compiled like programs
      add_executable(hrbfnpr_precompiled_${set} "${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp")
    else()
      add_library(hrbfnpr_precompiled_${set} OBJECT "${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp")
    endif()
    hrbfnpr_compile(hrbfnpr_precompiled_${set})
    target_precompile_headers(hrbfnpr_precompiled_${set} PRIVATE ${HRBFNPR_PRECOMPILED_${set}})
    if(set STREQUAL "tests")
      hrbfnpr_compile_test(hrbfnpr_precompiled_${set})
      target_compile_definitions(hrbfnpr_precompiled_${set} PRIVATE GTEST_HAS_PTHREAD=1)
    endif()
  endif()
  target_precompile_headers(${target} REUSE_FROM hrbfnpr_precompiled_${set})
endfunction()
