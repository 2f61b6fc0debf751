# Installs the tool into a fresh folder, configures a project that knows nothing but that folder, and runs its tests.
# Then does the same with examples of designs, which are projects of their own too.
#   cmake -D BUILD=build/ci -D CONSUMER=tests/package/consumer -D SCRATCH=folder
#         -D EXAMPLES_FOLDER=examples -D "EXAMPLES=pipeline;cyclic" -P package_test.cmake
function(run_checked what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what}: ${result}\n${output}")
  endif()
endfunction()

function(expect_in_output text)
  string(FIND "${output}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "expected \"${text}\" in\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run_checked(install ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/prefix)
file(COPY ${CONSUMER} DESTINATION ${SCRATCH})
set(source ${SCRATCH}/consumer)

# A first budget by --init, a second that is a copy of a shipped one with its own paths.
set(tool ${SCRATCH}/prefix/bin/faster-sim)
set(share ${SCRATCH}/prefix/share/faster-sim)
file(MAKE_DIRECTORY ${source}/budgets)
run_checked(init ${tool} check --init ${share}/configs/faster_zcu102.yaml --trace ${share}/traces/edge_heavy
  --out ${source}/budgets/design.yaml)
file(READ ${share}/configs/budgets/edge_heavy_10_cores.yaml wide)
string(REPLACE "../faster_zcu102" "${share}/configs/faster_zcu102" wide "${wide}")
string(REPLACE "../../traces" "${share}/traces" wide "${wide}")
file(WRITE ${source}/budgets/wide.yaml "${wide}")

run_checked(configure ${CMAKE_COMMAND} -S ${source} -B ${SCRATCH}/build -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix)
execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/build -L budget --output-on-failure
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "a broken budget passed\n${output}")
endif()
expect_in_output("1 tests failed out of 2")
expect_in_output("modules.rasterizer.setup_cycles")
if(NOT EXISTS ${SCRATCH}/build/design.xml)
  message(FATAL_ERROR "no JUnit file")
endif()

# Designs of their own find the kernel there, and nothing of the model, whatever C++ their projects are in (SystemC has a
# symbol for each). Not optimized: they compile for longer than they run.
set(standard -D CMAKE_CXX_STANDARD=20)
foreach(name IN LISTS EXAMPLES)
  file(COPY ${EXAMPLES_FOLDER}/${name} DESTINATION ${SCRATCH})
  run_checked(configure ${CMAKE_COMMAND} -S ${SCRATCH}/${name} -B ${SCRATCH}/${name}/build
    -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix -D CMAKE_BUILD_TYPE=None ${standard})
  set(standard)
  run_checked(build ${CMAKE_COMMAND} --build ${SCRATCH}/${name}/build --parallel 2)
  run_checked(run ${SCRATCH}/${name}/build/${name} run ${SCRATCH}/${name}/${name}.yaml)
  run_checked(budget ${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/${name}/build -L budget --no-tests=error)
endforeach()
file(REMOVE_RECURSE ${SCRATCH})
