# What `cmake --install` puts where: the tool, its configurations, budgets and traces; the dataflow kernel, as static
# libraries and headers; and the package that find_package(faster-sim) finds.
include(CMakePackageConfigHelpers)
set(faster_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/faster-sim)
install(TARGETS faster-sim EXPORT faster-sim-targets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY configs traces DESTINATION ${CMAKE_INSTALL_DATADIR}/faster-sim)
install(EXPORT faster-sim-targets NAMESPACE faster-sim:: DESTINATION ${faster_package_folder})

# The kernel: dataflow::commands brings all of it.
set_target_properties(faster_options PROPERTIES EXPORT_NAME options)
set(faster_kernel faster_options)
foreach(library IN LISTS faster_kernel_libraries)
  list(APPEND faster_kernel dataflow_${library})
endforeach()
install(TARGETS ${faster_kernel} EXPORT faster-sim-kernel ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/faster-sim)
install(EXPORT faster-sim-kernel NAMESPACE dataflow:: DESTINATION ${faster_package_folder})
install(DIRECTORY src/dataflow src/channels src/hls DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/faster-sim
  FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h" PATTERN page EXCLUDE)

write_basic_package_version_file(${PROJECT_BINARY_DIR}/faster-sim-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/faster-sim-config.cmake cmake/FasterBudget.cmake cmake/FindSystemC.cmake
  ${PROJECT_BINARY_DIR}/faster-sim-config-version.cmake DESTINATION ${faster_package_folder})
