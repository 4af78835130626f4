# SPDX-License-Identifier: MIT
# Reads the version and the ABI version from the header, which alone sets them. CMakeLists.txt includes this file before
# project(). It sets hrbfnpr_version and HRBFNPR_ABI_VERSION.
set(hrbfnpr_header "${CMAKE_CURRENT_LIST_DIR}/../include/hrbfnpr.h")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${hrbfnpr_header}")
foreach(name IN ITEMS VERSION_MAJOR VERSION_MINOR VERSION_PATCH ABI_VERSION)
  file(STRINGS "${hrbfnpr_header}" line REGEX "^ *HRBFNPR_${name} = [0-9]+,?$")
  if(NOT line MATCHES "^ *HRBFNPR_${name} = ([0-9]+),?$") # also false for two lines
    message(FATAL_ERROR "include/hrbfnpr.h must set HRBFNPR_${name} once, on a line of its own")
  endif()
  set(HRBFNPR_${name} ${CMAKE_MATCH_1})
endforeach()
unset(line)
set(hrbfnpr_version "${HRBFNPR_VERSION_MAJOR}.${HRBFNPR_VERSION_MINOR}.${HRBFNPR_VERSION_PATCH}")
