# SPDX-License-Identifier: MIT
# Header-only packages that only the library's sources include. They are not exported.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)

# Find GLM's folder. Debian's target glm::glm adds -isystem /usr/include, which breaks cross builds.
find_path(HRBFNPR_GLM_INCLUDE_DIR glm/glm.hpp REQUIRED)
mark_as_advanced(HRBFNPR_GLM_INCLUDE_DIR)

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
if(HRBFNPR_OPENMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
endif()

# Only Highway's headers: the library itself chooses the instruction set.
find_path(HRBFNPR_HIGHWAY_INCLUDE_DIR hwy/highway.h REQUIRED)
mark_as_advanced(HRBFNPR_HIGHWAY_INCLUDE_DIR)

# The JSON parser of settings, included only by src/picture/json.cpp. It handles numbers in any locale, escapes, UTF-8 and
# the places of errors, and is widely tested. It is header-only, and the viewer needs it anyway.
find_path(HRBFNPR_JSON_INCLUDE_DIR nlohmann/json.hpp REQUIRED)
mark_as_advanced(HRBFNPR_JSON_INCLUDE_DIR)

if(CMAKE_CROSSCOMPILING)
  # A cross compiler must not search the host's folder of headers, so link only these packages into a new folder.
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
