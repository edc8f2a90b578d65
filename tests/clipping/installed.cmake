# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=… -DREADME=… -DWORK=… -DCXX=… -DGENERATOR=… -P installed.cmake
# Installs the library of a build tree, moves what was installed, and builds with it, where no Qt can
# be found, the project that stands in clipping/README.md: it must print what the README says.
# (The blocks of the README end at the first backtick.)
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(extract language result)
  string(REGEX MATCH "\n```${language}\n([^`]*)```" block "${readme}")
  if(NOT block)
    message(FATAL_ERROR "${README} has no block of ${language}")
  endif()
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/made --component library)
file(RENAME ${WORK}/made ${WORK}/moved)

# Every installed header can be included first, needs none that is not installed, and does not mind how its user
# computes.
file(GLOB_RECURSE headers ${WORK}/moved/include/*.h)
foreach(header IN LISTS headers)
  run(${CXX} -std=c++20 -ffast-math -Wall -Wextra -Werror -fsyntax-only -I${WORK}/moved/include -x c++ -include ${header} /dev/null)
endforeach()

file(READ ${README} readme)
extract(cmake lists)
extract(cpp program)
extract(text promised)
file(WRITE ${WORK}/project/CMakeLists.txt "${lists}")
file(WRITE ${WORK}/project/main.cpp "${program}")
run(${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
  -DCMAKE_PREFIX_PATH=${WORK}/moved -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Werror")
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/hatching)
if(NOT output STREQUAL promised)
  message(FATAL_ERROR "The example prints\n${output}but its README says\n${promised}")
endif()
list(LENGTH headers count)
message(STATUS "The README's example ran on ${count} installed headers and printed what it promises")
