# SPDX-License-Identifier: MIT
# With BUILD_SHARED_LIBS: only what the public headers declare can be called (abi.h), and the name that programs look
# for, libclipping.so.0.1, has the minor version, because each one may change the compiled interface before 1.0.
function(hide_all_but_the_api target)
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(BUILD_SHARED_LIBS)
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  endif()
endfunction()
