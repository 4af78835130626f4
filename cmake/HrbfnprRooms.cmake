# SPDX-License-Identifier: MIT
# The rooms of the house (docs/design.md): each folder of src/ is an object library. The tests of a room link only that
# room and the rooms below it.
#
#   hrbfnpr_room(fit DEPENDS implicit)     makes hrbfnpr_fit from src/fit/*.cpp
#   hrbfnpr_link_room(some_test fit ...)   links these rooms and all their dependencies

function(hrbfnpr_room name)
  cmake_parse_arguments(arg "" "FOLDER" "DEPENDS;SOURCES" ${ARGN})
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${name})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${arg_FOLDER}/*.cpp")
  if(HRBFNPR_COVERAGE)
    list(REVERSE sources) # another order than in the release build finds files that lack an include
  endif()
  set(closure)
  if(sources)
    if(NOT TARGET hrbfnpr_${name})
      add_library(hrbfnpr_${name} OBJECT)
    endif()
    target_sources(hrbfnpr_${name} PRIVATE ${sources})
    hrbfnpr_compile(hrbfnpr_${name})
    hrbfnpr_precompile(hrbfnpr_${name} src)
    if(HRBFNPR_UNITY)
      hrbfnpr_unite_room(hrbfnpr_${name} ${sources})
    endif()
    if(HRBFNPR_COVERAGE)
      # Threads may lose counts, but not the fact that a line was reached. Atomic counters are far slower.
      target_compile_options(hrbfnpr_${name} PRIVATE --coverage -fprofile-update=single)
    endif()
    set(closure ${name})
  endif()
  foreach(dependency IN LISTS arg_DEPENDS)
    get_property(below GLOBAL PROPERTY HRBFNPR_ROOM_${dependency})
    list(APPEND closure ${below})
  endforeach()
  list(REMOVE_DUPLICATES closure)
  set_property(GLOBAL PROPERTY HRBFNPR_ROOM_${name} "${closure}")
endfunction()

# Compiles up to 24 files as one, in half of the time. So no two files of a room may define the same name. Files that are
# compiled once per instruction set stay separate; CMake itself excludes files with their own options. -Wshadow is off
# here, because names of another file are not an error. The presets `check` and `debug` compile single files and warn.
function(hrbfnpr_unite_room target)
  target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
  foreach(source IN LISTS ARGN)
    file(STRINGS "${source}" several REGEX "HWY_TARGET_INCLUDE" LIMIT_COUNT 1)
    if(several)
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

function(hrbfnpr_link_room target)
  set(closure)
  foreach(room IN LISTS ARGN)
    get_property(below GLOBAL PROPERTY HRBFNPR_ROOM_${room})
    list(APPEND closure ${below})
  endforeach()
  list(REMOVE_DUPLICATES closure)
  foreach(name IN LISTS closure)
    target_link_libraries(${target} PRIVATE hrbfnpr_${name})
  endforeach()
  target_link_libraries(${target} PRIVATE hrbfnpr_options Threads::Threads ${CMAKE_DL_LIBS})
  if(HRBFNPR_OPENMP)
    target_link_libraries(${target} PRIVATE $<LINK_ONLY:OpenMP::OpenMP_CXX>)
  endif()
endfunction()
