# SPDX-License-Identifier: GPL-3.0-or-later
# find_peer(RESULT HEADER [TARGET]): whether a program with that header can be compiled and linked with that target.
# That a package was found is not enough: Debian's libgeos-dev has the CMake files of GEOS, and libgeos++-dev the
# headers. Only a success is remembered, so that a package which is installed later is found.
include(CheckIncludeFileCXX)
function(find_peer result header)
  set(${result} FALSE PARENT_SCOPE)
  foreach(target IN LISTS ARGN)
    if(NOT TARGET ${target})
      return()
    endif()
  endforeach()
  string(MAKE_C_IDENTIFIER "PEER_HAS_${header}" known)
  if(NOT ${known})
    unset(${known} CACHE)
  endif()
  set(CMAKE_REQUIRED_QUIET ON)
  set(CMAKE_REQUIRED_LIBRARIES ${ARGN})
  check_include_file_cxx(${header} ${known})
  if(${known})
    set(${result} TRUE PARENT_SCOPE)
  endif()
endfunction()
