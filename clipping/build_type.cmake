# SPDX-License-Identifier: MIT
# Without a build type CMake does not optimise, and `exact` takes twenty times as long. A project that includes
# the library chooses its own build type.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo, Debug or MinSizeRel" FORCE)
endif()
