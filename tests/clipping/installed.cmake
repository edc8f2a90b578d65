# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=… -DPAGE=… -DWORK=… -DCXX=… -DGENERATOR=… -DPROGRAMS=all|main -P installed.cmake
# Installs the library of a build tree, moves what was installed, and builds with it, where no Qt can
# be found, the project of clipping/cpp.md and, if asked, all other programs of this page: they must
# print what it says.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

include(${CMAKE_CURRENT_LIST_DIR}/programs_of_page.cmake)

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/made --component library)
file(RENAME ${WORK}/made ${WORK}/moved)

# Every installed header can be included first, needs none that is not installed, and compiles with
# -ffast-math.
file(GLOB_RECURSE headers ${WORK}/moved/include/*.h)
if(PROGRAMS STREQUAL "all") # every build installs the same headers
  foreach(header IN LISTS headers)
    run(${CXX} -std=c++20 -ffast-math -Wall -Wextra -Werror -fsyntax-only -I${WORK}/moved/include -x c++ -include ${header} /dev/null)
  endforeach()
endif()
# X11 has a macro of this name.
run(${CXX} -std=c++20 -DNone=0L -Wall -Wextra -Werror -fsyntax-only -I${WORK}/moved/include -x c++ -include clearcut/clip.h
  -include clipping/algorithm.h -include clipping/turned_window.h -include clipping/chunks.h /dev/null)

build_programs_of_page(${WORK}/moved)

# The same by pkg-config instead of CMake, once more with other containers than the library was compiled with.
find_program(PKG_CONFIG pkg-config REQUIRED)
file(GLOB pc ${WORK}/moved/lib*/pkgconfig/clearcut.pc ${WORK}/moved/lib*/*/pkgconfig/clearcut.pc)
cmake_path(GET pc PARENT_PATH folder)
set(ENV{PKG_CONFIG_PATH} ${folder})
run(${PKG_CONFIG} --cflags --libs clearcut)
separate_arguments(flags UNIX_COMMAND "${output}")
file(GLOB library ${WORK}/moved/lib*/libclipping.* ${WORK}/moved/lib*/*/libclipping.*)
list(GET library 0 library)
cmake_path(GET library PARENT_PATH folder)
list(APPEND flags -Wl,-rpath,${folder})
run(${CXX} -std=c++20 ${WORK}/project/main.cpp ${flags} -o ${WORK}/by_pkg_config)
expect_promised(${WORK}/by_pkg_config)
run(${CXX} -std=c++20 -D_GLIBCXX_DEBUG ${WORK}/project/main.cpp ${flags} -o ${WORK}/with_debug_containers)
expect_promised(${WORK}/with_debug_containers)

# Where containers would cross the boundary, the linker says what to do.
file(WRITE ${WORK}/project/trace.cpp "#include <clipping/algorithm.h>
  int main() { return clipping::exactAlgorithm().corrected.trace({}, {}).steps.size() > 99; }")
run(${CXX} -std=c++20 ${WORK}/project/trace.cpp ${flags} -o ${WORK}/trace)
run(${WORK}/trace)
execute_process(COMMAND ${CXX} -std=c++20 -D_GLIBCXX_DEBUG ${WORK}/project/trace.cpp ${flags} -o ${WORK}/trace
  RESULT_VARIABLE code ERROR_VARIABLE error)
if(code EQUAL 0 OR NOT error MATCHES "compile_Clearcut_with_GLIBCXX_DEBUG_too")
  message(FATAL_ERROR "A program with other containers is not refused: ${error}")
endif()

# A shared library is found by a name with its minor version, and shows nothing internal.
file(GLOB shared ${WORK}/moved/lib*/libclipping.so.*.*.* ${WORK}/moved/lib*/*/libclipping.so.*.*.*)
foreach(library IN LISTS shared)
  run(nm -DC --defined-only ${library})
  if(NOT output MATCHES "clipping::clipAll" OR output MATCHES "clipping::(exactPolygon|clipOneByOne|prepared)")
    message(FATAL_ERROR "${library} shows the wrong names:\n${output}")
  endif()
  run(objdump -p ${library})
  if(NOT output MATCHES "SONAME +libclipping.so.[0-9]+.[0-9]+\n")
    message(FATAL_ERROR "${library} has no soname:\n${output}")
  endif()
endforeach()
list(LENGTH headers count)
math(EXPR programs "${programs} + 1")
message(STATUS "${programs} programs ran on ${count} installed headers and printed what the page promises")
