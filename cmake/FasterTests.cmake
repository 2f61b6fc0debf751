include(Catch)

# Real meshes and depth images (tests that want them warn and pass without).
set(faster_test_environment)
if(EXISTS ${PROJECT_SOURCE_DIR}/../shared/data)
  cmake_path(SET faster_shared_data NORMALIZE ${PROJECT_SOURCE_DIR}/../shared/data)
  set(faster_test_environment ENVIRONMENT FASTER_SHARED_DATA=${faster_shared_data})
endif()

# What takes time in a test is in the libraries; optimizing its checks takes a quarter of its compiling, half of it with
# sanitizers.
set(faster_test_options $<$<CONFIG:Release>:-O0>)
if(FASTER_SANITIZERS)
  set(faster_test_options -O0)
endif()

# What most tests include.
faster_compile_headers(faster_test_header
  HEADERS <catch2/catch.hpp> <filesystem> <fstream> <nlohmann/json.hpp> <random> <sstream> <thread> <Eigen/Geometry>
  LIBRARIES faster_options Catch2::Catch2 Eigen3::Eigen nlohmann_json::nlohmann_json)
target_compile_options(faster_test_header PRIVATE ${faster_test_options})

# faster_add_test_library(NAME <STATIC|OBJECT> SOURCES... [LIBRARIES...])
function(faster_add_test_library name type)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(${name} ${type} ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${name} PUBLIC faster_options Catch2::Catch2 ${ARG_LIBRARIES})
endfunction()

# faster_add_test(NAME LABEL <unit|golden|engine|cli|browser|budget|examples> TIMEOUT seconds SOURCES... LIBRARIES...)
# One executable; each of its test cases is one CTest test NAME.CASE with the label, and the timeout for itself.
# A test that prints "skipped: " could not run, and CTest says so.
# No ';' and no lone bracket in the name of a case: CMake would take it for a list, and the case would not run. That
# fails rather than passes: Catch2 is told to (NoTests).
function(faster_add_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LIBRARIES" ${ARGN})
  foreach(required LABEL TIMEOUT SOURCES LIBRARIES)
    if(NOT ARG_${required})
      message(FATAL_ERROR "faster_add_test(${name}): ${required} is missing")
    endif()
  endforeach()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE FASTER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # Each file of tests is a namespace of its own, so the build can join them: what takes the compiler longest they share.
  target_precompile_headers(${name} REUSE_FROM faster_test_header)
  target_compile_options(${name} PRIVATE ${faster_test_options})
  target_link_libraries(${name} PRIVATE faster_options Catch2::Catch2 ${ARG_LIBRARIES})
  if(FASTER_SANITIZERS)
    math(EXPR ARG_TIMEOUT "5 * ${ARG_TIMEOUT}")
  endif()
  catch_discover_tests(${name} TEST_PREFIX "${name}." EXTRA_ARGS --warn NoTests PROPERTIES
    LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} SKIP_REGULAR_EXPRESSION "skipped: " ${faster_test_environment})
endfunction()
