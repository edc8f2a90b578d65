# SPDX-License-Identifier: GPL-3.0-or-later
# For scripts with README, WORK, CXX and GENERATOR: builds the project in clipping/README.md, where no Qt can be found, on
# an installed library; it must print what the README says. (The blocks of the README end at the first backtick.)
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

function(expect_promised program)
  run(${program})
  if(NOT output STREQUAL promised)
    message(FATAL_ERROR "${program} prints\n${output}but its README says\n${promised}")
  endif()
endfunction()

macro(build_readme_example installed)
  file(READ ${README} readme)
  extract(cmake lists)
  extract(cpp program)
  extract(text promised)
  file(WRITE ${WORK}/project/CMakeLists.txt "${lists}")
  file(WRITE ${WORK}/project/main.cpp "${program}")
  run(${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${installed} -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Werror")
  run(${CMAKE_COMMAND} --build ${WORK}/build)
  expect_promised(${WORK}/build/hatching)
endmacro()
