# SPDX-License-Identifier: GPL-3.0-or-later
# Tests of the preset `deep` alone: they take minutes, and what they test changes rarely. All have the label `deep`.

# The library alone: from a project of somebody else's, and by CLEARCUT_APP=OFF, both where no Qt can be found; without information for a debugger, which takes time. folder_alone precompiles no header, so it finds a
# missing #include.
function(add_alone_test name source)
  add_test(NAME ${name} COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${source} ${CMAKE_CURRENT_BINARY_DIR}/${name} --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=
    ${ARGN})
  set_tests_properties(${name} PROPERTIES TIMEOUT 300)
endfunction()
add_alone_test(clipping.outside_project ${CMAKE_CURRENT_SOURCE_DIR}/clipping/outside_project
  -DCLIPPING=${PROJECT_SOURCE_DIR}/clipping -DCLEARCUT_PRECOMPILE=ON -DCMAKE_CXX_FLAGS=-ffast-math --test-command ${CMAKE_CTEST_COMMAND}
  --output-on-failure)
add_alone_test(clipping.library_alone ${PROJECT_SOURCE_DIR} -DCLEARCUT_APP=OFF -DCLEARCUT_PRECOMPILE=ON)
add_alone_test(clipping.folder_alone ${PROJECT_SOURCE_DIR}/clipping -DBUILD_SHARED_LIBS=ON)

foreach(build IN ITEMS library_alone folder_alone)
  set_tests_properties(clipping.${build} PROPERTIES FIXTURES_SETUP ${build})
endforeach()
add_installed_test(library_alone ${CMAKE_CURRENT_BINARY_DIR}/clipping.library_alone all)
add_installed_test(folder_alone ${CMAKE_CURRENT_BINARY_DIR}/clipping.folder_alone main)

# The Debian packages of this build, each extracted into an empty folder and used there.
if(NOT CLEARCUT_SANITIZE AND NOT CLEARCUT_SANITIZE_THREADS AND NOT BUILD_SHARED_LIBS)
  set(python_of_package "")
  if(TARGET clearcut_python)
    set(python_of_package ${CLEARCUT_PYTHON_PROGRAM})
  endif()
  add_test(NAME resources.packages COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR}
    -DPAGE=${PROJECT_SOURCE_DIR}/clipping/cpp.md -DPROGRAMS=main -DWORK=${CMAKE_CURRENT_BINARY_DIR}/resources.packages
    -DCXX=${CMAKE_CXX_COMPILER} -DGENERATOR=${CMAKE_GENERATOR} -DPYTHON=${python_of_package}
    -P ${CMAKE_CURRENT_SOURCE_DIR}/resources/packages/packages.cmake)
  set_tests_properties(resources.packages PROPERTIES TIMEOUT 300 SKIP_REGULAR_EXPRESSION "Skipped:")
endif()

# lupdate: of qt6-l10n-tools, which tests/run.sh installs for the presets with these tests.
find_program(LUPDATE lupdate HINTS ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS} REQUIRED)
add_test(NAME texts COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/texts.py ${LUPDATE} ${PROJECT_SOURCE_DIR})

set(deep_tests texts clipping.outside_project clipping.library_alone clipping.folder_alone clipping.watching_test
  clipping.installed_from_library_alone clipping.installed_from_folder_alone)
if(TEST resources.packages)
  list(APPEND deep_tests resources.packages)
endif()
set_property(TEST ${deep_tests} APPEND PROPERTY LABELS deep)
