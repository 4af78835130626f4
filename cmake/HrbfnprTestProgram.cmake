# SPDX-License-Identifier: MIT
# hrbfnpr_test_program(NAME [PLAIN] SOURCE...): a program of tests, whose own code is neither what is tested nor what is
# measured; PLAIN: nor does it work on much, and is not optimized at all.
#
# HRBFNPR_TEST_OBJECTS is the folder of another build of the same sources, whose objects are then linked with the library
# of this one.  So a library under sanitizers is tested without compiling its tests, which takes longer than the library.

function(hrbfnpr_test_program name)
  cmake_parse_arguments(arg "PLAIN" "" "" ${ARGN})
  set(sources ${arg_UNPARSED_ARGUMENTS})
  if(HRBFNPR_TEST_OBJECTS)
    hrbfnpr_built_objects(sources ${name} ${sources})
  endif()
  add_executable(${name} ${sources})
  hrbfnpr_compile(${name})
  if(HRBFNPR_TEST_OBJECTS)
    set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  else()
    if(arg_PLAIN)
      hrbfnpr_compile_test(${name} PLAIN)
      hrbfnpr_precompile(${name} plain_tests)
    else()
      hrbfnpr_compile_test(${name})
      hrbfnpr_precompile(${name} tests)
    endif()
  endif()
endfunction()

# The objects that the other build made of these sources for the target of this name, as Ninja and make place them.
function(hrbfnpr_built_objects result name)
  file(RELATIVE_PATH folder "${PROJECT_BINARY_DIR}" "${CMAKE_CURRENT_BINARY_DIR}")
  set(objects)
  foreach(source IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    if(NOT source MATCHES "[.](c|cpp)$")
      continue()
    endif()
    file(RELATIVE_PATH source "${CMAKE_CURRENT_SOURCE_DIR}" "${source}")
    string(REPLACE "../" "__/" source "${source}")
    set(object "${HRBFNPR_TEST_OBJECTS}/${folder}/CMakeFiles/${name}.dir/${source}.o")
    if(NOT EXISTS "${object}")
      message(FATAL_ERROR "HRBFNPR_TEST_OBJECTS: there is no ${object}; build that folder first")
    endif()
    list(APPEND objects "${object}")
  endforeach()
  set(${result} ${objects} PARENT_SCOPE)
endfunction()
