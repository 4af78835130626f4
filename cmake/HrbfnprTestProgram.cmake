# SPDX-License-Identifier: MIT
# hrbfnpr_test_program(NAME SOURCE...) adds a program of tests. Its own code is compiled with less optimization.
#
# HRBFNPR_TEST_OBJECTS is the folder of another build of the same sources. Its test objects are then linked with this
# build's library. This saves compiling the tests for a library with sanitizers, which takes longer than the library.

function(hrbfnpr_test_program name)
  set(sources ${ARGN})
  if(HRBFNPR_TEST_OBJECTS)
    hrbfnpr_built_objects(sources ${name})
  endif()
  add_executable(${name} ${sources})
  hrbfnpr_compile(${name})
  if(HRBFNPR_TEST_OBJECTS)
    set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
    return()
  endif()
  hrbfnpr_compile_test(${name})
  hrbfnpr_precompile(${name} tests)
  if(HRBFNPR_UNITY)
    hrbfnpr_unite(${name} ${sources})
  endif()
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.objects" CONTENT "$<JOIN:$<TARGET_OBJECTS:${name}>,\n>\n")
endfunction()

# hrbfnpr_discover_tests(NAME PREFIX [LONG ...] [LONG_UNCHECKED ...] [UNCHECKED ...] [PROPERTIES ...]) adds the tests of a
# program and labels them. The three lists are GoogleTest filters.
#   LONG             tests that take over a second, or over five with sanitizers: `long checked`
#   LONG_UNCHECKED   tests that take over a second, and minutes with sanitizers: `long`
#   UNCHECKED        tests that are too slow only with sanitizers: `short`
# All others are `short checked`. This is a single label, because gtest_discover_tests takes no list. `ctest -L short`
# matches it, because it searches for a part of a label. NAME.filters keeps the lists for scripts/test and labels_test.py.
function(hrbfnpr_discover_tests name prefix)
  set(kinds LONG_UNCHECKED LONG UNCHECKED)
  cmake_parse_arguments(arg "" "" "${kinds};PROPERTIES" ${ARGN})
  set(labels_of_LONG "long checked")
  set(labels_of_LONG_UNCHECKED long)
  set(labels_of_UNCHECKED short)
  set(named)
  set(lines)
  foreach(kind IN LISTS kinds)
    if(arg_${kind})
      list(JOIN arg_${kind} ":" filter)
      gtest_discover_tests(${name} TEST_PREFIX "${prefix}." DISCOVERY_MODE PRE_TEST TEST_LIST "${name}_${kind}"
        TEST_FILTER "${filter}-${named}" PROPERTIES LABELS "${labels_of_${kind}}" ${arg_PROPERTIES})
      string(APPEND named "${filter}:")
      list(TRANSFORM arg_${kind} PREPEND "${kind} ")
      list(APPEND lines ${arg_${kind}})
    endif()
  endforeach()
  gtest_discover_tests(${name} TEST_PREFIX "${prefix}." DISCOVERY_MODE PRE_TEST
    TEST_FILTER "-${named}" PROPERTIES LABELS "short checked" ${arg_PROPERTIES})
  list(JOIN lines "\n" lines)
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.filters" CONTENT "${lines}\n")
endfunction()

# hrbfnpr_label_tests([UNCHECKED] [LONG NAME...]) labels the tests that add_test has added in this folder. Tests named by
# LONG are `long`, the others `short`. All are `checked`, except with UNCHECKED.
function(hrbfnpr_label_tests)
  cmake_parse_arguments(arg "UNCHECKED" "" "LONG" ${ARGN})
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test IN LISTS tests)
    set(labels short)
    if(test IN_LIST arg_LONG)
      set(labels long)
    endif()
    if(NOT arg_UNCHECKED)
      list(APPEND labels checked)
    endif()
    set_property(TEST ${test} APPEND PROPERTY LABELS ${labels})
  endforeach()
endfunction()

# Compiles up to 24 files as one, in a third of the time, because templates are compiled once for all. Each file has its
# own namespace for its names. Files that are not tests stay separate.
function(hrbfnpr_unite name)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
  foreach(source IN LISTS ARGN)
    if(NOT source MATCHES "_test[.]cpp$")
      set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()

# The objects of the target with this name in the other build.
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

# All targets of a folder, and of the folders below, that a plain build makes.
function(hrbfnpr_targets_below result folder)
  get_property(found DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
  get_property(below DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
  foreach(other IN LISTS below)
    hrbfnpr_targets_below(more "${other}")
    list(APPEND found ${more})
  endforeach()
  set(targets)
  foreach(target IN LISTS found)
    get_target_property(type ${target} TYPE)
    get_target_property(left_out ${target} EXCLUDE_FROM_ALL)
    if(NOT left_out AND NOT type STREQUAL "UTILITY")
      list(APPEND targets ${target})
    endif()
  endforeach()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()
