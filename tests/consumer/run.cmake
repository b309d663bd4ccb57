# Installs the built project to an empty prefix, then configures, builds and runs the project in CONSUMER_DIR
# against it. Fails with the output of the step that fails.
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nfailed with ${status}:\n${output}")
  endif()
  set(step_output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${SCRATCH_DIR}")
step("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${SCRATCH_DIR}/prefix" --config "${CONFIG}")
step("${CMAKE_COMMAND}" -S "${CONSUMER_DIR}" -B "${SCRATCH_DIR}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/prefix" "-DCMAKE_BUILD_TYPE=${CONFIG}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
step("${CMAKE_COMMAND}" --build "${SCRATCH_DIR}/build" --config "${CONFIG}")
step("${SCRATCH_DIR}/build/consumer")
if(NOT step_output STREQUAL "x^2+y^2-1\n")
  message(FATAL_ERROR "the consumer printed: ${step_output}")
endif()
step("${SCRATCH_DIR}/build/renderer")
if(NOT step_output MATCHES "\n +[^ \n]+ +[^ \n]+ +\n") # a row of the torus with its hole
  message(FATAL_ERROR "the renderer printed: ${step_output}")
endif()
