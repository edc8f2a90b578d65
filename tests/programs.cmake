# SPDX-License-Identifier: GPL-3.0-or-later
# The programs of the tests. Each *_test.cpp is a QtTest with a `main` of its own (QTEST_MAIN). The tests of a room of app/ or
# ui/ are compiled into one program, because reading headers and linking take most of the time of a build: where
# headers are precompiled, six tests a file. Each is in a namespace of its own, so their names cannot clash.
include(${CMAKE_CURRENT_LIST_DIR}/test_names.cmake)

# Alone in its program is what a namespace does not bear: a function that replaces one of the standard library's, a specialisation
# of somebody else's template, a `main` that is written out, a header that is not for all machines.
function(is_alone source path result)
  file(READ ${source} text)
  set(alone FALSE)
  if(NOT path MATCHES "^(app|ui)/[^/]+/" OR path MATCHES "_gl_test.cpp$"
      OR text MATCHES "\n(int main|namespace [a-z]|extern \"C\"|Q_DECLARE_METATYPE|void\\* operator new)|\n#if[^\n]*\n#include|(failing_disk|slow_disk|busy_desk)[.]h")
    set(alone TRUE)
  endif()
  set(${result} ${alone} PARENT_SCOPE)
endfunction()

# What every program of tests needs, whichever tests are in it.
function(add_test_program program path)
  cmake_parse_arguments(PARSE_ARGV 2 of "" "" "SOURCES;TESTS")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/moc/${program})
  file(MAKE_DIRECTORY ${folder})
  foreach(test IN LISTS of_TESTS)
    get_filename_component(stem ${test} NAME_WE)
    qt_generate_moc(${test} ${folder}/${stem}.moc)
    list(APPEND of_SOURCES ${folder}/${stem}.moc)
  endforeach()
  qt_add_executable(${program} ${of_SOURCES})
  target_include_directories(${program} PRIVATE ${folder} ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${program} PRIVATE SOURCE_DIR="${PROJECT_SOURCE_DIR}" CLEARCUT_BINARY="$<TARGET_FILE:clearcut>")
  link_tests(${program} ${path})
  precompile_headers_of_tests(${program} ${path})
  if(build STREQUAL optimised AND path MATCHES "^(app|ui)/") # they call the program; what they compute is little
    target_compile_options(${program} PRIVATE -O1)
  endif()
endfunction()

function(link_tests program path)
  if(path MATCHES "^clipping/parallel/")
    target_link_libraries(${program} PRIVATE clipping_parallel TBB::tbb)
  elseif(path MATCHES "^clipping/")
    target_link_libraries(${program} PRIVATE clipping oracle)
  elseif(path MATCHES "^app/")
    target_link_libraries(${program} PRIVATE app oracle)
  elseif(path MATCHES "/") # without a folder: reads the sources, whether they compile or not
    target_link_libraries(${program} PRIVATE ui)
  endif()
  target_link_libraries(${program} PRIVATE Qt6::Test)
endfunction()

# Once for all tests of a layer, which are compiled alike; oneTBB does not bear Qt's `emit`.
function(precompile_headers_of_tests program path)
  if(NOT CLEARCUT_PRECOMPILE OR path MATCHES "^clipping/parallel/")
    return()
  endif()
  string(REGEX MATCH "^[a-z]*" layer ${path})
  get_property(first DIRECTORY PROPERTY first_tests_of_${layer})
  if(first)
    target_precompile_headers(${program} REUSE_FROM ${first})
  else()
    set_property(DIRECTORY PROPERTY first_tests_of_${layer} ${program})
    target_precompile_headers(${program} PRIVATE <QTest> ${headers_of_${layer}})
  endif()
endfunction()

# add_program_of_tests(PROGRAM PATH TEST...): several tests; the program's first argument names the one to run.
function(add_program_of_tests program path)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/together/${program})
  set(batch 1)
  if(CLEARCUT_PRECOMPILE)
    set(batch 6)
  endif()
  set(declared)
  set(listed)
  set(sources ${folder}/main.cpp)
  list(LENGTH ARGN count)
  math(EXPR last "${count} - 1")
  foreach(begin RANGE 0 ${last} ${batch})
    list(SUBLIST ARGN ${begin} ${batch} tests)
    list(LENGTH sources number)
    list(JOIN tests "|" joined)
    add_custom_command(OUTPUT ${folder}/tests_${number}.cpp VERBATIM
      COMMAND ${CMAKE_COMMAND} "-DTESTS=${joined}" -DROOT=${CMAKE_CURRENT_SOURCE_DIR} -DTO=${folder}/tests_${number}.cpp
        -P ${CMAKE_CURRENT_SOURCE_DIR}/together.cmake
      DEPENDS ${tests} together.cmake test_names.cmake)
    list(APPEND sources ${folder}/tests_${number}.cpp)
    foreach(test IN LISTS tests)
      name_of_test(${test} ${CMAKE_CURRENT_SOURCE_DIR} name)
      string(MAKE_C_IDENTIFIER ${name} space)
      string(APPEND declared "namespace ${space} {\nint mainOfTest(int, char**);\n}\n")
      string(APPEND listed "    {\"${name}\", ${space}::mainOfTest},\n")
    endforeach()
  endforeach()
  configure_file(program_of_tests.cpp.in ${folder}/main.cpp @ONLY)
  add_test_program(${program} ${path} SOURCES ${sources} TESTS ${ARGN})
  target_compile_options(${program} PRIVATE ${compiled_together})
endfunction()
