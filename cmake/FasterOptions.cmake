# Compiler flags of every target of ours, on one INTERFACE target. No -march=native and no -ffast-math: both move
# floating-point results, and with them the bit-exact vertex transform (docs/function.md#vertex-transform).
# Who uses the installed libraries gets the headers and the language standard alone.
add_library(faster_options INTERFACE)
target_include_directories(faster_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/faster-sim>)
target_compile_features(faster_options INTERFACE cxx_std_17)
set(faster_compile_options
  -ffp-contract=off -fno-semantic-interposition -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/= -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual)
if(FASTER_WARNINGS_AS_ERRORS)
  list(APPEND faster_compile_options -Werror)
endif()
if(FASTER_SANITIZERS)
  list(APPEND faster_compile_options -fsanitize=${FASTER_SANITIZERS} -fno-omit-frame-pointer)
  target_link_options(faster_options INTERFACE -fsanitize=${FASTER_SANITIZERS})
endif()
target_compile_options(faster_options INTERFACE "$<BUILD_INTERFACE:${faster_compile_options}>")

# A tenth of the compiler's time, for some hundred MB more of memory, where the host has them for each of its cores.
cmake_host_system_information(RESULT faster_host_cores QUERY NUMBER_OF_LOGICAL_CORES)
cmake_host_system_information(RESULT faster_host_megabytes QUERY TOTAL_PHYSICAL_MEMORY)
math(EXPR faster_megabytes_of_core "${faster_host_megabytes} / ${faster_host_cores}")
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND faster_megabytes_of_core GREATER 1500)
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-expand=400;--param=ggc-min-heapsize=900000>")
endif()

find_program(FASTER_CCACHE ccache)
if(FASTER_CCACHE)
  # ccache asks for both before it caches what includes a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${FASTER_CCACHE})
  add_compile_options(-fpch-preprocess)
endif()

# faster_add_room(OWNER NAME SOURCES... [PUBLIC targets...] [PRIVATE targets...])
# One folder of src/ is one static library OWNER_NAME, alias OWNER::NAME; its arrows are its link libraries. OWNER is
# `dataflow` (the kernel) or `faster` (the design).
function(faster_add_room owner name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${owner}_${name} STATIC ${ARG_SOURCES})
  add_library(${owner}::${name} ALIAS ${owner}_${name})
  set_target_properties(${owner}_${name} PROPERTIES EXPORT_NAME ${name})
  target_link_libraries(${owner}_${name} PUBLIC faster_options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
endfunction()

# faster_compile_each_alone(TARGET...)
# For code in which the time is spent: what the compiler inlines does not depend on what else is in the file, even where
# the build joins sources (CMAKE_UNITY_BUILD). A build that does not optimize has nothing to protect, and is quicker.
function(faster_compile_each_alone)
  if(CMAKE_BUILD_TYPE MATCHES "^Rel")
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD OFF)
  endif()
endfunction()

# faster_compile_alone(SOURCE...)
# The same for some sources of a target of this folder; the others are joined.
function(faster_compile_alone)
  if(CMAKE_BUILD_TYPE MATCHES "^Rel")
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# faster_compile_headers(NAME HEADERS... LIBRARIES...)
# Headers that executables share, compiled once: target_precompile_headers(... REUSE_FROM NAME). LIBRARIES tell where
# they are.
function(faster_compile_headers name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LIBRARIES" ${ARGN})
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  target_compile_options(${name} PRIVATE -fPIE)  # as executables are compiled
endfunction()

# faster_compile_quickly(TARGET...)
# For code in which no time is spent: compiles in half the time of -O3, minutes of CI in all, and a third quicker than with
# -O1 or -O0.
function(faster_compile_quickly)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Og>)
  endforeach()
endfunction()
