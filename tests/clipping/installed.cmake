# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=… -DPAGE=… -DWORK=… -DCXX=… -DGENERATOR=… -DPROGRAMS=all|main -P installed.cmake
# Installs the library of a build tree, moves what was installed, and builds with it, where no Qt can
# be found, the project of clipping/cpp.md and, if asked, all other programs of this page: they must
# print what it says.
# (The blocks of the page end at the first backtick.)
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(extract language result)
  string(REGEX MATCH "\n```${language}\n([^`]*)```" block "${from}")
  if(NOT block)
    message(FATAL_ERROR "${PAGE} has no block of ${language}")
  endif()
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/made --component library)
file(RENAME ${WORK}/made ${WORK}/moved)

# Every installed header can be included first, needs none that is not installed, and compiles with
# -ffast-math.
file(GLOB_RECURSE headers ${WORK}/moved/include/*.h)
foreach(header IN LISTS headers)
  run(${CXX} -std=c++20 -ffast-math -Wall -Wextra -Werror -fsyntax-only -I${WORK}/moved/include -x c++ -include ${header} /dev/null)
endforeach()
# X11 has a macro of this name.
run(${CXX} -std=c++20 -DNone=0L -Wall -Wextra -Werror -fsyntax-only -I${WORK}/moved/include -x c++ -include clearcut/clip.h
  -include clipping/algorithm.h -include clipping/turned_window.h -include clipping/chunks.h /dev/null)

# Old names still compile, each with a note that says what to write.
file(WRITE ${WORK}/old_names.cpp "#include <clipping/algorithm.h>
  using namespace clipping;
  const Uses<Segment, Window>* old = usesOf(exactAlgorithm(), Form::Corrected);
  const void *floats = exactAlgorithm().single, *search = exactAlgorithm().searchedPolygon;
  Edge none = Edge::None;")
execute_process(COMMAND ${CXX} -std=c++20 -fsyntax-only -I${WORK}/moved/include ${WORK}/old_names.cpp
  COMMAND_ERROR_IS_FATAL ANY ERROR_VARIABLE notes)
foreach(name IN ITEMS Functions functionsOf floats polygonBySearch NoEdge)
  if(NOT notes MATCHES "deprecated: write ${name}")
    message(FATAL_ERROR "No note says \"write ${name}\":\n${notes}")
  endif()
endforeach()

file(READ ${PAGE} page)
string(FIND "${page}" "```cmake" at)
string(SUBSTRING "${page}" ${at} -1 from)
string(PREPEND from "\n")
extract(cmake lists)
extract(cpp program) # the main.cpp of this project
extract(text promised)
set(programs 0)
set(rest "${page}")
while(rest MATCHES "```cpp\n([^`]*)```\n+It prints\n```text\n([^`]*)```")
  math(EXPR programs "${programs} + 1")
  file(WRITE ${WORK}/project/${programs}.cpp "${CMAKE_MATCH_1}")
  set(promised_${programs} "${CMAKE_MATCH_2}")
  string(APPEND lists "add_executable(program_${programs} ${programs}.cpp)
    target_link_libraries(program_${programs} PRIVATE Clearcut::clipping)\n")
  string(FIND "${rest}" "${CMAKE_MATCH_0}" at)
  math(EXPR at "${at} + 6")
  string(SUBSTRING "${rest}" ${at} -1 rest)
endwhile()
string(REGEX MATCHALL "```cpp" blocks "${page}")
list(LENGTH blocks count)
if(NOT count EQUAL programs)
  message(FATAL_ERROR "Of the ${count} programs of ${PAGE} only ${programs} say what they print")
endif()
file(WRITE ${WORK}/project/CMakeLists.txt "${lists}")
file(WRITE ${WORK}/project/main.cpp "${program}")
run(${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
  -DCMAKE_PREFIX_PATH=${WORK}/moved -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Werror")
if(PROGRAMS STREQUAL "main")
  set(programs 0)
  run(${CMAKE_COMMAND} --build ${WORK}/build --target hatching)
else()
  run(${CMAKE_COMMAND} --build ${WORK}/build)
endif()
function(expect_promised program)
  run(${program})
  if(NOT output STREQUAL promised)
    message(FATAL_ERROR "${program} prints\n${output}but the page says\n${promised}")
  endif()
endfunction()
expect_promised(${WORK}/build/hatching)
set(promised_by_main "${promised}")
foreach(number RANGE ${programs})
  if(number EQUAL 0)
    continue()
  endif()
  set(promised "${promised_${number}}")
  expect_promised(${WORK}/build/program_${number})
endforeach()
set(promised "${promised_by_main}")

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
