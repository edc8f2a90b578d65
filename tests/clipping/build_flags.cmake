# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=… -DWORK=… -DCXX=… -P build_flags.cmake
# How the library is compiled by those who say nothing about it, and by those who say too much. Configures only.
cmake_minimum_required(VERSION 3.25)
set(ENV{CMAKE_GENERATOR} Ninja) # it writes compile_commands.json

# `commands`: how the library's files are compiled in a build tree of that source.
function(configure name source)
  file(REMOVE_RECURSE ${WORK}/${name})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${WORK}/${name} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${ARGN}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${WORK}/${name}/compile_commands.json json)
  string(REGEX MATCHALL "\"command\": \"[^\n]*clipping\\.dir[^\n]*" commands "${json}")
  list(LENGTH commands count)
  if(count LESS 20)
    message(FATAL_ERROR "${name}: only ${count} files of the library are compiled")
  endif()
  set(commands "${commands}" PARENT_SCOPE)
endfunction()

function(every_command name pattern)
  foreach(command IN LISTS commands)
    if(NOT command MATCHES "${pattern}")
      message(FATAL_ERROR "${name}: \"${pattern}\" does not match ${command}")
    endif()
  endforeach()
endfunction()

# The two ways that clipping/cpp.md names, word for word: optimised.
configure(folder_alone ${SOURCE}/clipping)
every_command(folder_alone " -O3 -DNDEBUG ")
configure(library_alone ${SOURCE} -DCLEARCUT_APP=OFF)
every_command(library_alone " -O3 -DNDEBUG ")
# What is asked for is done.
configure(debug ${SOURCE}/clipping -DCMAKE_BUILD_TYPE=Debug)
every_command(debug " -g ")
# Inside another project that project decides, but for the numbers.
configure(outside_project ${SOURCE}/tests/clipping/outside_project -DCLIPPING=${SOURCE}/clipping
  -DCMAKE_CXX_FLAGS=-ffast-math)
every_command(outside_project " -ffast-math .* -fno-fast-math ")
foreach(command IN LISTS commands)
  if(command MATCHES " -O[0-9s]")
    message(FATAL_ERROR "Optimised without being asked: ${command}")
  endif()
endforeach()

# And where CMake has no say, the compiler stops at each file.
file(GLOB_RECURSE files ${SOURCE}/clipping/*.cpp)
list(LENGTH files count)
if(count LESS 20)
  message(FATAL_ERROR "Only ${count} files in ${SOURCE}/clipping")
endif()
foreach(file IN LISTS files)
  execute_process(COMMAND ${CXX} -std=c++20 -ffast-math -E -I${SOURCE} ${file} -o /dev/null
    RESULT_VARIABLE code ERROR_VARIABLE error)
  if(code EQUAL 0 OR NOT error MATCHES "-fno-fast-math")
    message(FATAL_ERROR "${file} can be compiled with -ffast-math: include clipping/ieee_numbers.h")
  endif()
endforeach()
message(STATUS "${count} files: optimised by default, never with -ffast-math")
