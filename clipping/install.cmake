# SPDX-License-Identifier: MIT
# `cmake --install BUILD --component library` installs a relocatable package for find_package(Clearcut).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Clearcut)

install(TARGETS clipping EXPORT ClearcutClipping ARCHIVE COMPONENT library
  LIBRARY COMPONENT library NAMELINK_COMPONENT library
  FILE_SET HEADERS COMPONENT library FILE_SET clearcut COMPONENT library)
install(EXPORT ClearcutClipping NAMESPACE Clearcut:: DESTINATION ${package} COMPONENT library)
if(TARGET clipping_parallel)
  install(TARGETS clipping_parallel EXPORT ClearcutClippingParallel
    ARCHIVE COMPONENT library LIBRARY COMPONENT library NAMELINK_COMPONENT library
    FILE_SET HEADERS COMPONENT library)
  install(EXPORT ClearcutClippingParallel NAMESPACE Clearcut:: DESTINATION ${package} COMPONENT library)
endif()

configure_package_config_file(ClearcutConfig.cmake.in ClearcutConfig.cmake INSTALL_DESTINATION ${package}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(ClearcutConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ClearcutConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/ClearcutConfigVersion.cmake DESTINATION ${package} COMPONENT library)

# For pkg-config, which finds the installed folder by where clearcut.pc is.
set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH to_prefix /${pkgconfig} /)
configure_file(clearcut.pc.in clearcut.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/clearcut.pc DESTINATION ${pkgconfig} COMPONENT library)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libclearcut-dev RENAME copyright COMPONENT library)
install(FILES README.md cpp.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libclearcut-dev COMPONENT library)
