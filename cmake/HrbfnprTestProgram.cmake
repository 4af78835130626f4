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
    hrbfnpr_built_objects(sources ${name})
  endif()
  add_executable(${name} ${sources})
  hrbfnpr_compile(${name})
  if(HRBFNPR_TEST_OBJECTS)
    set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
    return()
  endif()
  if(arg_PLAIN)
    hrbfnpr_compile_test(${name} PLAIN)
    hrbfnpr_precompile(${name} plain_tests)
  else()
    hrbfnpr_compile_test(${name})
    hrbfnpr_precompile(${name} tests)
  endif()
  if(HRBFNPR_UNITY_TESTS)
    hrbfnpr_unite(${name} ${sources})
  endif()
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.objects" CONTENT "$<JOIN:$<TARGET_OBJECTS:${name}>,\n>\n")
endfunction()

# Eight files are compiled as one: templates are then made and optimized once for all, in a third of the time.  What a file
# names itself is in a namespace of the file's name; files that are no tests stay by themselves.
function(hrbfnpr_unite name)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  foreach(source IN LISTS ARGN)
    if(NOT source MATCHES "_test[.]cpp$")
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

# The objects that the other build made for its target of this name.
function(hrbfnpr_built_objects result name)
  file(RELATIVE_PATH folder "${PROJECT_BINARY_DIR}" "${CMAKE_CURRENT_BINARY_DIR}")
  set(list "${HRBFNPR_TEST_OBJECTS}/${folder}/${name}.objects")
  if(NOT EXISTS "${list}")
    message(FATAL_ERROR "HRBFNPR_TEST_OBJECTS: there is no ${list}; build that folder first")
  endif()
  file(STRINGS "${list}" objects)
  foreach(object IN LISTS objects)
    if(NOT EXISTS "${object}")
      message(FATAL_ERROR "HRBFNPR_TEST_OBJECTS: there is no ${object}; build that folder first")
    endif()
  endforeach()
  set(${result} ${objects} PARENT_SCOPE)
endfunction()
