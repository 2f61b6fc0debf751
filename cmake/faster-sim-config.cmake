# find_package(faster-sim): the executable faster-sim::faster-sim, and faster_add_budget() (FasterBudget.cmake).
include(${CMAKE_CURRENT_LIST_DIR}/faster-sim-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/FasterBudget.cmake)
