# The package: find_package(graze) gives graze::interval, graze::boost_rounding and graze::octree.
include(CMakePackageConfigHelpers)
install(TARGETS graze_interval graze_boost_rounding graze_octree graze_core_math EXPORT graze_targets)
if(TARGET graze_crlibm)
  install(TARGETS graze_crlibm EXPORT graze_targets)
endif()
install(DIRECTORY interval/include/ octree/geometry/include/ octree/tree/include/ octree/surface/include/
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT graze_targets NAMESPACE graze:: FILE graze-targets.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/graze)
configure_package_config_file(cmake/graze-config.cmake.in graze-config.cmake
        INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/graze)
write_basic_package_version_file(graze-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/graze-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/graze-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/graze)
