# `cmake --build --preset release --target package` makes a .deb: the tool with its man pages and the completion of bash,
# configurations, the package for Python, and the kernel's headers and libraries. Called last: it packs what is installed.
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN changes EXCLUDE)
install(FILES scripts/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME faster-sim)

# The man pages are what --help says.
find_program(FASTER_HELP2MAN help2man)
if(FASTER_HELP2MAN)
  set(faster_man ${PROJECT_BINARY_DIR}/man)
  install(CODE "execute_process(COMMAND bash ${PROJECT_SOURCE_DIR}/scripts/man-pages.sh $<TARGET_FILE:faster-sim> ${faster_man} COMMAND_ERROR_IS_FATAL ANY)")
  install(DIRECTORY ${faster_man}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME faster-sim)
set(CPACK_PACKAGE_CONTACT "the faster-sim authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# For graphs on pages and the package for Python; for designs of one's own, which link the kernel.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "graphviz, python3, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libsystemc-dev, libyaml-cpp-dev, libfmt-dev, libcli11-dev, nlohmann-json3-dev, libzstd-dev, libpng-dev")
include(CPack)
