# make install: libraries for C++ and C, public headers, program, packages for find_package(wythe) and pkg-config.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS wythe EXPORT wythe_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS wythe_c LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS wythe_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/wythe DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
configure_file(cmake/wythe.pc.in ${CMAKE_BINARY_DIR}/wythe.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/wythe.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DATADIR}/wythe)
# the page to draw walls on, where `make studio` has built it
install(FILES ${CMAKE_SOURCE_DIR}/build/studio.html DESTINATION ${CMAKE_INSTALL_DATADIR}/wythe OPTIONAL)

set(wythe_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/wythe)
install(EXPORT wythe_targets NAMESPACE wythe:: DESTINATION ${wythe_package_dir})
configure_package_config_file(cmake/wytheConfig.cmake.in ${CMAKE_BINARY_DIR}/wytheConfig.cmake
  INSTALL_DESTINATION ${wythe_package_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/wytheConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/wytheConfig.cmake ${CMAKE_BINARY_DIR}/wytheConfigVersion.cmake
  DESTINATION ${wythe_package_dir})
