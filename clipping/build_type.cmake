# SPDX-License-Identifier: MIT
# Without a build type CMake asks for no optimisation, and `exact` takes twenty times as long. A project that
# includes the library decides for itself.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo, Debug or MinSizeRel" FORCE)
endif()
