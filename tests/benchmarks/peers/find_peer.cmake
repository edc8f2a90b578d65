# SPDX-License-Identifier: GPL-3.0-or-later
# find_peer(RESULT HEADER PACKAGE LIBRARY): whether a program with that header can be compiled, and linked with that
# library of that package (empty: none). A package can be installed by half: Debian's libgeos-dev has the CMake files of
# GEOS, and libgeos++-dev the headers. The program has a project of its own, because a package may end the
# configuration, and try_compile does not know every target: CGAL::CGAL is another name of one that is not imported.
# Only a success is remembered, so that a package which is installed later is found.
set(find_peer_project ${CMAKE_CURRENT_LIST_DIR}/program)
function(find_peer result header package library)
  string(MAKE_C_IDENTIFIER "PEER_HAS_${header}" known)
  if(NOT ${known})
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/find_peer)
    execute_process(COMMAND ${CMAKE_COMMAND} -G ${CMAKE_GENERATOR} -S ${find_peer_project} -B ${folder}
        -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
        "-DCMAKE_PREFIX_PATH=${CMAKE_PREFIX_PATH}" "-DHEADER=${header}" "-DPACKAGE=${package}" "-DLIBRARY=${library}"
      RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(NOT failed)
      execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder} RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    endif()
    if(NOT failed)
      set(${known} TRUE CACHE INTERNAL "A program with this header can be built")
    endif()
  endif()
  set(${result} "${${known}}" PARENT_SCOPE)
endfunction()
