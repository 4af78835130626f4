# SPDX-License-Identifier: MIT
# cmake --install: the library, its header, a CMake package and a pkg-config file. None of them contains a path of the
# build machine.
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/hrbfnpr")

install(TARGETS hrbfnpr EXPORT hrbfnprTargets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  PUBLIC_HEADER DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
if(TARGET hrbfnpr_import_library) # see HrbfnprExports.cmake
  install(FILES "${hrbfnpr_import_library}" DESTINATION "${CMAKE_INSTALL_LIBDIR}")
endif()
install(EXPORT hrbfnprTargets NAMESPACE hrbfnpr:: DESTINATION "${package_dir}")

# A shared library brings all its dependencies. A static library needs the C++ runtime, libm and threads from the
# program, so these become public dependencies.
set(hrbfnpr_runtime "")
set(pc_cflags "")
set(pc_libs "")
if(NOT BUILD_SHARED_LIBS)
  set(hrbfnpr_runtime ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
  list(FILTER hrbfnpr_runtime INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+|c\\+\\+abi|m)$")
  list(REMOVE_DUPLICATES hrbfnpr_runtime)
  list(TRANSFORM hrbfnpr_runtime PREPEND " -l" OUTPUT_VARIABLE pc_libs)
  string(JOIN "" pc_libs ${pc_libs})
  set(pc_cflags " -DHRBFNPR_STATIC")
  string(APPEND pc_libs " -pthread")
  foreach(library IN LISTS CMAKE_DL_LIBS)
    string(APPEND pc_libs " -l${library}")
  endforeach()
  if(HRBFNPR_OPENMP)
    string(APPEND pc_libs " ${OpenMP_CXX_FLAGS}")
  endif()
endif()
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/hrbfnprConfig.cmake.in" "${PROJECT_BINARY_DIR}/hrbfnprConfig.cmake"
  INSTALL_DESTINATION "${package_dir}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Before 1.0 a minor version may break the interface. From 1.0 on this becomes SameMajorVersion.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hrbfnprConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/hrbfnprConfig.cmake" "${PROJECT_BINARY_DIR}/hrbfnprConfigVersion.cmake"
  DESTINATION "${package_dir}")

# The relative path from <prefix>/<libdir>/pkgconfig to <prefix>, for any depth of libdir.
file(RELATIVE_PATH pc_prefix "/prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/prefix")
string(REGEX REPLACE "/$" "" pc_prefix "${pc_prefix}")
configure_file("${PROJECT_SOURCE_DIR}/cmake/hrbfnpr.pc.in" "${PROJECT_BINARY_DIR}/hrbfnpr.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/hrbfnpr.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# For bindings: the header's declarations, and a description of them with layouts and comments.
install(FILES
  "${PROJECT_SOURCE_DIR}/bindings/cdef/hrbfnpr_cdef.h" "${PROJECT_SOURCE_DIR}/bindings/api.json"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/hrbfnpr")
