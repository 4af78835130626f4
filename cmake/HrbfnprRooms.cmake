# SPDX-License-Identifier: MIT
# The rooms of the house (docs/design.md): each folder of src/ is an object library, so that a
# test of one room links that room and the rooms below it, and nothing else.
#
#   hrbfnpr_room(fit DEPENDS implicit)     makes hrbfnpr_fit from src/fit/*.cpp
#   hrbfnpr_link_room(some_test fit ...)   links these and all that they depend on

function(hrbfnpr_room name)
  cmake_parse_arguments(arg "" "FOLDER" "DEPENDS;SOURCES" ${ARGN})
  if(NOT arg_FOLDER)
    set(arg_FOLDER ${name})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${arg_FOLDER}/*.cpp")
  if(HRBFNPR_COVERAGE)
    list(REVERSE sources) # united the other way round than in the release build, a header that a file forgot is missed
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
      # Threads may lose counts, but not whether a line was reached; atomic counters are far slower.
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

# Two dozen files are compiled as one, in half of the time, so no two files of a room name the same thing.  Files stay by
# themselves that are compiled once for each instruction set; CMake leaves out those with options of their own.  What a
# file's own names are in the way of is no fault then; builds of single files, such as `check` and `debug`, warn of it.
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
