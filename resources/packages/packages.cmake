# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages, by `cpack` in the build folder: what is built becomes clearcut (the program), libclearcut-dev and
# python3-clearcut.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL library)
if(TARGET clearcut_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
if(TARGET clearcut)
  list(APPEND CPACK_COMPONENTS_ALL Unspecified)
endif()

# The changelog of all three; that of the program is installed with its other pages.
find_program(GZIP gzip)
if(GZIP)
  set(changelog ${CMAKE_CURRENT_BINARY_DIR}/packages/changelog.gz)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/packages)
  execute_process(COMMAND ${GZIP} -9nc ${CMAKE_CURRENT_LIST_DIR}/../desktop/changelog OUTPUT_FILE ${changelog}
    COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/../desktop/changelog)
  install(FILES ${changelog} DESTINATION share/doc/libclearcut-dev COMPONENT library)
  install(FILES ${changelog} DESTINATION share/doc/python3-clearcut COMPONENT python EXCLUDE_FROM_ALL)
endif()

set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
set(CPACK_PACKAGE_VENDOR "The Clearcut authors")
set(CPACK_PACKAGE_CONTACT "The Clearcut authors <clearcut@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

# The program; the library is linked into it.
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME clearcut)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS qt6-wayland)
set(CPACK_DEBIAN_UNSPECIFIED_DESCRIPTION "Editor for line art with a movable clip window
Draw or open line art, lay a window over it, and see at every frame what
each published line-clipping algorithm leaves of it; then export the cut
drawing as real geometry for plotters, laser cutters, CAD and maps.")

# The library: headers and an archive.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libclearcut-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS libglm-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS "cmake | pkgconf")
if(TARGET clipping_parallel)
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS libtbb-dev)
endif()
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "C++20 library that clips lines exactly
Clips line segments, lines, rays, polylines and areas at windows, polygons
and areas of any shape, without a wrong decision, and with every published
algorithm of line clipping. With files for CMake and pkg-config.")

# The module, for the Python that it was compiled with.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-clearcut)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${CLEARCUT_PYTHON_DEPENDS}")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-dask, python3-distributed, python3-shapely")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/postinst ${CMAKE_CURRENT_LIST_DIR}/prerm)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Clips line segments exactly, over NumPy arrays
Clips arrays of line segments at windows and convex polygons without
copying them, polylines, and lines of shapely; with Dask also on a cluster. A
plug-in for vpype is included.")
include(CPack)
