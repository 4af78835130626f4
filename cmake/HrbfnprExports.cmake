# SPDX-License-Identifier: MIT
# hrbfnpr_limit_exports(target) makes a shared library export exactly the header's functions.

if(HRBFNPR_LINK_RULE) # from a toolchain file, which CMake's own modules would overrule
  set(CMAKE_CXX_CREATE_SHARED_LIBRARY "${HRBFNPR_LINK_RULE}")
endif()

function(hrbfnpr_limit_exports target)
  if(NOT BUILD_SHARED_LIBS)
    return()
  endif()
  if(WIN32)
    hrbfnpr_prepare_dll(${target})
  elseif(APPLE)
    set(list "${PROJECT_SOURCE_DIR}/src/hrbfnpr.exports")
    target_link_options(${target} PRIVATE "LINKER:-exported_symbols_list,${list}")
    set_target_properties(${target} PROPERTIES LINK_DEPENDS "${list}" INSTALL_NAME_DIR "@rpath"
      BUILD_WITH_INSTALL_NAME_DIR ON)
  elseif(UNIX)
    set(script "${CMAKE_CURRENT_BINARY_DIR}/hrbfnpr.map")
    configure_file("${PROJECT_SOURCE_DIR}/src/hrbfnpr.map.in" "${script}" @ONLY)
    target_link_options(${target} PRIVATE "LINKER:--version-script,${script}") # Zig's driver refuses the form with =
    if(NOT HRBFNPR_SANITIZE)
      target_link_options(${target} PRIVATE "LINKER:--no-undefined")
    endif()
    set_target_properties(${target} PROPERTIES LINK_DEPENDS "${script}")
  endif()
endfunction()

# On Windows __declspec(dllexport) chooses the exports. The file is libhrbfnpr.dll with every compiler, because hrbfnpr.dll
# would be the file name of the C# assembly HrbfNpr.dll. With MinGW the C++ runtime goes into the library, and
# hrbfnpr.lib is an import library for Microsoft's linker.
function(hrbfnpr_prepare_dll target)
  set_target_properties(${target} PROPERTIES PREFIX "lib")
  if(NOT MINGW)
    return()
  endif()
  target_link_options(${target} PRIVATE -static "LINKER:--no-insert-timestamp" "LINKER:--output-def,${CMAKE_CURRENT_BINARY_DIR}/hrbfnpr.def"
    $<$<CONFIG:Release>:-s>) # strip would insert a time
  find_program(HRBFNPR_DLLTOOL NAMES llvm-dlltool llvm-dlltool-14 llvm-dlltool-15 llvm-dlltool-16 NO_CMAKE_FIND_ROOT_PATH)
  mark_as_advanced(HRBFNPR_DLLTOOL)
  if(NOT HRBFNPR_DLLTOOL)
    message(STATUS "There is no llvm-dlltool, so no import library for Microsoft's linker is made")
    return()
  endif()
  set(library "${CMAKE_CURRENT_BINARY_DIR}/hrbfnpr.lib")
  add_custom_command(OUTPUT "${library}" DEPENDS ${target} VERBATIM
    COMMAND "${HRBFNPR_DLLTOOL}" -m i386:x86-64 -d "${CMAKE_CURRENT_BINARY_DIR}/hrbfnpr.def" -D libhrbfnpr.dll -l "${library}")
  add_custom_target(hrbfnpr_import_library ALL DEPENDS "${library}")
  set(hrbfnpr_import_library "${library}" CACHE INTERNAL "The import library for Microsoft's linker")
endfunction()
