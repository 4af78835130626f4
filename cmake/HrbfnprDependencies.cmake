# SPDX-License-Identifier: MIT
# Header-only packages, used inside the library only: nothing of them is exported.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)

# GLM by its folder, not by Debian's glm::glm target, which injects -isystem /usr/include
# and so breaks cross builds.
find_path(HRBFNPR_GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
mark_as_advanced(HRBFNPR_GLM_INCLUDE_DIR)

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
if(HRBFNPR_OPENMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
endif()

# Highway's headers only: which instruction set is used is decided by the library itself.
find_path(HRBFNPR_HIGHWAY_INCLUDE_DIR hwy/highway.h REQUIRED)
mark_as_advanced(HRBFNPR_HIGHWAY_INCLUDE_DIR)

# The parser of settings (src/picture/json.cpp, and nothing else): numbers in any locale, escapes, UTF-8 and the place of
# a mistake, where every other part of a reader for JSON is a dozen lines.  It is headers only, tested far more widely
# than one of our own would be, and the viewer needs it anyway.
find_path(HRBFNPR_JSON_INCLUDE_DIR nlohmann/json.hpp REQUIRED)
mark_as_advanced(HRBFNPR_JSON_INCLUDE_DIR)

if(CMAKE_CROSSCOMPILING)
  # A system's folder of headers is no place for another system to look into: links to these alone.
  foreach(package IN ITEMS GLM:glm HIGHWAY:hwy JSON:nlohmann)
    string(REPLACE ":" ";" package "${package}")
    list(GET package 0 variable)
    list(GET package 1 folder)
    file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/headers/${folder}")
    file(CREATE_LINK "${HRBFNPR_${variable}_INCLUDE_DIR}/${folder}"
      "${PROJECT_BINARY_DIR}/headers/${folder}/${folder}" SYMBOLIC)
    set(HRBFNPR_${variable}_INCLUDE_DIR "${PROJECT_BINARY_DIR}/headers/${folder}")
  endforeach()
endif()
