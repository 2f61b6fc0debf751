# SystemC as Debian ships it: a header, a shared library and no CMake package file.
find_path(SystemC_INCLUDE_DIR systemc)
find_library(SystemC_LIBRARY systemc)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SystemC REQUIRED_VARS SystemC_LIBRARY SystemC_INCLUDE_DIR)
if(SystemC_FOUND AND NOT TARGET SystemC::systemc)
  add_library(SystemC::systemc UNKNOWN IMPORTED)
  set_target_properties(SystemC::systemc PROPERTIES
    IMPORTED_LOCATION ${SystemC_LIBRARY}
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${SystemC_INCLUDE_DIR})

  # The library has one symbol that is called after the C++ standard it was compiled with, and every object that uses it
  # asks for the one of its own standard: what is compiled as C++20 would not link to a library of C++17. Its header lets
  # that be said.
  file(STRINGS ${SystemC_LIBRARY} faster_systemc_version REGEX "sc_api_version_[0-9_]+_cxx[0-9]+L" LIMIT_COUNT 1)
  if(faster_systemc_version MATCHES "sc_api_version_[0-9_]+_cxx(20([0-9][0-9])[0-9][0-9]L)")
    set_target_properties(SystemC::systemc PROPERTIES INTERFACE_COMPILE_DEFINITIONS
      $<$<NOT:$<STREQUAL:$<TARGET_PROPERTY:CXX_STANDARD>,${CMAKE_MATCH_2}>>:SC_CPLUSPLUS=${CMAKE_MATCH_1}>)
  endif()
endif()
