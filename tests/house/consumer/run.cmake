# Installs FLOE_BUILD to a fresh prefix, then configures, builds and runs against it a small project
# and the example of ROOT, whose numbers are checked.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(build source binary)
  run(${CMAKE_COMMAND} -S ${source} -B ${binary} -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_FLAGS=${FLAGS} -D CMAKE_BUILD_TYPE=${BUILD_TYPE})
  run(${CMAKE_COMMAND} --build ${binary})
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${FLOE_BUILD} --prefix ${WORK}/prefix)
build(${CMAKE_CURRENT_LIST_DIR} ${WORK}/build)
run(${WORK}/build/consumer)
build(${ROOT}/examples/library ${WORK}/example)
run(${PYTHON} -B ${ROOT}/tests/house/check_example.py ${WORK}/example/plate_in_waves ${ROOT})
