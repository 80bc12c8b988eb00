# Installs the build into a folder of its own, builds the consumer against it and runs it.
#     cmake -D BUILD=... -D FOLDER=... -D CONSUMER=... -D LINK_FLAGS=... -D GENERATOR=... -P package.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${status}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${FOLDER}/installed)

file(GLOB_RECURSE installed RELATIVE ${FOLDER}/installed ${FOLDER}/installed/*)
foreach(expected bin/carom share/man/man1/carom.1 share/man/man5/carom-scene.5 share/man/man7/carom-models.7
    share/man/man7/carom-algorithms.7
    share/carom/scenes/break.json share/carom/scenes/scene.schema.json include/carom/simulation.hpp)
  if(NOT expected IN_LIST installed)
    message(FATAL_ERROR "${expected} is not installed; there is\n${installed}")
  endif()
endforeach()
run(${FOLDER}/installed/bin/carom run ${FOLDER}/installed/share/carom/scenes/break.json --frames 1)

run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${FOLDER}/consumer -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${FOLDER}/installed -D CMAKE_EXE_LINKER_FLAGS=${LINK_FLAGS})
run(${CMAKE_COMMAND} --build ${FOLDER}/consumer)
run(${FOLDER}/consumer/consumer)
file(REMOVE_RECURSE ${FOLDER})
