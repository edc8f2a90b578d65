# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DBUILD=… -DPAGE=… -DPROGRAMS=main -DWORK=… -DCXX=… -DGENERATOR=… -DPYTHON=… -P packages.cmake
# Packs what a build tree has, extracts each Debian package into an empty folder, and uses it there: the main program of
# the page on the library, a program on the Python module, `clearcut --version`.
cmake_minimum_required(VERSION 3.25)
find_program(DPKG_DEB dpkg-deb)
find_program(SHLIBDEPS dpkg-shlibdeps)
if(NOT DPKG_DEB OR NOT SHLIBDEPS)
  message(STATUS "Skipped: dpkg-deb or dpkg-shlibdeps is missing (Debian: dpkg-dev)")
  return()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/../../clipping/programs_of_page.cmake)
file(REMOVE_RECURSE ${WORK})
cmake_path(GET CMAKE_COMMAND PARENT_PATH programs)
run(${programs}/cpack --config ${BUILD}/CPackConfig.cmake -B ${WORK})

function(expect_field package name pattern)
  run(${DPKG_DEB} --field ${package} ${name})
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${name} of ${package} is ${output}")
  endif()
endfunction()

# What every package says of itself; extracts it.
function(open package summary depends)
  file(GLOB found ${WORK}/${package}_*_*.deb)
  list(LENGTH found count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "${WORK} has ${count} packages ${package}")
  endif()
  expect_field(${found} Package "^${package}\n")
  expect_field(${found} Version "^[0-9]+[.][0-9]+[.][0-9]+\n")
  expect_field(${found} Maintainer "^[A-Z].* <.*@.*>\n")
  expect_field(${found} Description "^${summary}\n [A-Z]")
  expect_field(${found} Depends "${depends}")
  run(${DPKG_DEB} --extract ${found} ${WORK}/${package})
  if(NOT EXISTS ${WORK}/${package}/usr/share/doc/${package}/copyright)
    message(FATAL_ERROR "${found} does not say who may copy it")
  endif()
  run(gzip -dc ${WORK}/${package}/usr/share/doc/${package}/changelog.gz)
  if(NOT output MATCHES "^clearcut \\([0-9.]+\\) .*\n -- The Clearcut authors <")
    message(FATAL_ERROR "The changelog of ${found} is ${output}")
  endif()
  if(EXISTS ${WORK}/${package}/usr/share/licenses)
    message(FATAL_ERROR "${found} has licenses where Debian has none")
  endif()
endfunction()

open(libclearcut-dev "C[+][+]20 library that clips lines exactly" "^libglm-dev\n")
build_programs_of_page(${WORK}/libclearcut-dev/usr)
foreach(page IN ITEMS README.md cpp.md) # README.md names cpp.md
  if(NOT EXISTS ${WORK}/libclearcut-dev/usr/share/doc/libclearcut-dev/${page})
    message(FATAL_ERROR "The package libclearcut-dev lacks ${page}")
  endif()
endforeach()
find_program(PKG_CONFIG pkg-config REQUIRED)
file(GLOB folder ${WORK}/libclearcut-dev/usr/lib/pkgconfig ${WORK}/libclearcut-dev/usr/lib/*/pkgconfig)
set(ENV{PKG_CONFIG_PATH} ${folder})
run(${PKG_CONFIG} --cflags --libs clearcut)
separate_arguments(flags UNIX_COMMAND "${output}")
run(${CXX} -std=c++20 ${WORK}/project/main.cpp ${flags} -o ${WORK}/by_pkg_config)
expect_promised(${WORK}/by_pkg_config)

if(PYTHON)
  open(python3-clearcut "Clips line segments exactly, over NumPy arrays"
    "python3 \\(>= 3[.][0-9]+\\), python3 \\(<< 3[.][0-9]+\\), python3-numpy, .*libc6 ")
  file(READ ${WORK}/python3-clearcut/usr/share/doc/python3-clearcut/copyright copyright)
  if(NOT copyright MATCHES "Wenzel Jakob.*Redistributions in binary form must reproduce the above copyright notice")
    message(FATAL_ERROR "The package python3-clearcut lacks the notice of pybind11")
  endif()
  set(ENV{PYTHONPATH} ${WORK}/python3-clearcut/usr/lib/python3/dist-packages)
  set(ENV{PYTHONDONTWRITEBYTECODE} 1)
  file(WRITE ${WORK}/clip.py "
import importlib.metadata, sys
import numpy as np, clearcut
assert clearcut.__file__.startswith(sys.argv[1]), clearcut.__file__
assert importlib.metadata.version('clearcut') == clearcut.__version__
extras = {requirement for requirement in importlib.metadata.requires('clearcut') if 'extra' in requirement}
assert extras == {\"dask[array] ; extra == 'cluster'\", \"distributed ; extra == 'cluster'\",
                  \"shapely ; extra == 'shapely'\", \"vpype ; extra == 'vpype'\"}, extras
[plug_in] = [e for e in importlib.metadata.distribution('clearcut').entry_points if e.group == 'vpype.plugins']
assert plug_in.name == 'clearcut', plug_in
found = clearcut.clip(np.random.default_rng(1).uniform(-200, 200, (1_000_000, 4)), (-100, -75, 100, 75))
print(found.segments.shape, found.segments.dtype)
")
  set(promised "(656863, 4) float64\n")
  run(${PYTHON} ${WORK}/clip.py ${WORK})
  if(NOT output STREQUAL promised)
    message(FATAL_ERROR "The module prints ${output}")
  endif()
endif()

if(EXISTS ${BUILD}/clearcut) # the program
  open(clearcut "Editor for line art with a movable clip window" "libc6 .*libqt6")
  set(ENV{QT_QPA_PLATFORM} offscreen)
  run(${WORK}/clearcut/usr/bin/clearcut --version)
  foreach(file IN ITEMS applications/io.github.clearcut.Clearcut.desktop man/man1/clearcut.1.gz)
    if(NOT EXISTS ${WORK}/clearcut/usr/share/${file})
      message(FATAL_ERROR "The package clearcut lacks ${file}")
    endif()
  endforeach()
endif()
file(GLOB packages RELATIVE ${WORK} ${WORK}/*.deb)
message(STATUS "Packed, extracted and used: ${packages}")
