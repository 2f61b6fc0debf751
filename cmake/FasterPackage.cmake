# `cmake --build --preset release --target package` makes a .deb: the tool with its man pages and the completion of bash,
# configurations, the package for Python, and the kernel's headers and libraries. Called last: it packs what is installed.
install(FILES README.md CHANGELOG.md CONTRIBUTING.md CODE_OF_CONDUCT.md SECURITY.md NOTICE Containerfile action.yml packaging/copyright
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
# What Debian's tools read; CHANGELOG.md says what changed.
set(faster_contact "The faster-sim authors <maintainers@faster-sim.invalid>")
string(TIMESTAMP faster_date "%a, %d %b %Y 00:00:00 +0000" UTC)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/changelog CONTENT
"faster-sim (${PROJECT_VERSION}) unstable; urgency=medium

  * CHANGELOG.md says what changed.

 -- ${faster_contact}  ${faster_date}
")
install(CODE "execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/packaging/changelog OUTPUT_FILE ${PROJECT_BINARY_DIR}/packaging/changelog.gz COMMAND_ERROR_IS_FATAL ANY)")
install(FILES ${PROJECT_BINARY_DIR}/packaging/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Pages link to what stands beside them in the sources, so it stands beside them here as well. Configurations and traces,
# which the tool's users need without the pages, are where FasterInstall.cmake puts them.
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN .gitignore EXCLUDE)
install(FILES rtl/resources.csv rtl/timing.csv DESTINATION ${CMAKE_INSTALL_DOCDIR}/rtl)
file(RELATIVE_PATH faster_data_from_pages ${CMAKE_INSTALL_FULL_DOCDIR} ${CMAKE_INSTALL_FULL_DATADIR}/faster-sim)
foreach(folder configs traces)
  file(CREATE_LINK ${faster_data_from_pages}/${folder} ${PROJECT_BINARY_DIR}/packaging/${folder} SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/packaging/${folder} DESTINATION ${CMAKE_INSTALL_DOCDIR})
endforeach()
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
set(CPACK_PACKAGE_CONTACT "${faster_contact}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "cycle-accurate simulator of dataflow designs for FPGAs
 Simulates FASTER, an accelerator that scores hypotheses of an object's
 pose against a depth image, and any design of pipelined loops, FIFOs and
 block RAMs: how many cycles it takes, where they go, and what a change
 would buy.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# For graphs on pages and the package for Python; for designs of one's own, which link the kernel.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "graphviz, python3, python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libsystemc-dev, libyaml-cpp-dev, libfmt-dev, libcli11-dev, nlohmann-json3-dev, libzstd-dev, libpugixml-dev, libpng-dev")
include(CPack)
