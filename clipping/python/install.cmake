# SPDX-License-Identifier: MIT
# `cmake --install BUILD --component python --prefix /usr` installs the package where Debian's Python looks for it. pip
# knows it, too, and vpype finds its plug-in, by the folder .dist-info.
set(modules_folder lib/python3/dist-packages)
set(info clearcut-${PROJECT_VERSION}.dist-info)
file(STRINGS pyproject.toml plug_in REGEX "^clearcut = \"")
string(REPLACE "\"" "" plug_in "${plug_in}")
file(READ pyproject.toml project)
string(REGEX MATCH "\\[project.optional-dependencies\\]\n([^\n]+\n)+" optional "${project}")
string(REGEX MATCHALL "[a-z]+ = [^\n]+" extras "${optional}")
set(extras_of_project "")
foreach(extra IN LISTS extras)
  string(REGEX MATCH "^[a-z]+" name "${extra}")
  string(APPEND extras_of_project "Provides-Extra: ${name}\n")
  string(REGEX MATCHALL "\"[^\"]+\"" requirements "${extra}")
  foreach(requirement IN LISTS requirements)
    string(REPLACE "\"" "" requirement "${requirement}")
    string(APPEND extras_of_project "Requires-Dist: ${requirement} ; extra == '${name}'\n")
  endforeach()
endforeach()
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${info}/METADATA "Metadata-Version: 2.1
Name: clearcut
Version: ${PROJECT_VERSION}
Summary: Clips line segments at windows, exactly, over NumPy arrays
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
${extras_of_project}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${info}/INSTALLER "cmake\n")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${info}/entry_points.txt "[vpype.plugins]\n${plug_in}\n")

math(EXPR next "${Python3_VERSION_MINOR} + 1")
set(CLEARCUT_PYTHON_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy"
  CACHE INTERNAL "For the Debian package")

set(quietly COMPONENT python EXCLUDE_FROM_ALL)
install(TARGETS clearcut_python LIBRARY DESTINATION ${modules_folder}/clearcut ${quietly})
install(DIRECTORY clearcut DESTINATION ${modules_folder} ${quietly} FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed
  PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${info} DESTINATION ${modules_folder} ${quietly})
install(FILES README.md cluster.md examples.md DESTINATION share/doc/python3-clearcut ${quietly})
install(DIRECTORY examples DESTINATION share/doc/python3-clearcut ${quietly})
install(FILES copyright DESTINATION share/doc/python3-clearcut ${quietly})
