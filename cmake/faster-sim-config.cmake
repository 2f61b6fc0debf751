# find_package(faster-sim): the executable faster-sim::faster-sim, faster_add_budget() (FasterBudget.cmake), and, in a
# project with the language CXX, the dataflow kernel as libraries: dataflow::commands brings all of it.
include(${CMAKE_CURRENT_LIST_DIR}/faster-sim-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/FasterBudget.cmake)

get_property(faster_sim_languages GLOBAL PROPERTY ENABLED_LANGUAGES)
if(CXX IN_LIST faster_sim_languages)
  include(CMakeFindDependencyMacro)
  list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})  # FindSystemC.cmake
  find_dependency(Threads)
  find_dependency(SystemC)
  find_dependency(yaml-cpp)
  find_dependency(CLI11)
  find_dependency(fmt)
  find_dependency(nlohmann_json)
  find_dependency(zstd)
  find_dependency(pugixml)
  find_dependency(ZLIB)
  include(${CMAKE_CURRENT_LIST_DIR}/faster-sim-kernel.cmake)
  add_library(faster-sim::tool ALIAS dataflow::commands)  # its name before 0.2
endif()
