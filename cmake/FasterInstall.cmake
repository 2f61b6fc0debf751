# What `cmake --install` puts where: the tool, its configurations, budgets and traces, and the package that
# find_package(faster-sim) finds.
include(CMakePackageConfigHelpers)
set(faster_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/faster-sim)
install(TARGETS faster-sim EXPORT faster-sim-targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY configs traces DESTINATION ${CMAKE_INSTALL_DATADIR}/faster-sim)
install(EXPORT faster-sim-targets NAMESPACE faster-sim:: DESTINATION ${faster_package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/faster-sim-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES cmake/faster-sim-config.cmake cmake/FasterBudget.cmake
  ${PROJECT_BINARY_DIR}/faster-sim-config-version.cmake DESTINATION ${faster_package_folder})
