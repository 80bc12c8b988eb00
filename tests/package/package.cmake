# Installs the build by components into a folder of its own, builds the consumer against it with
# find_package and with pkg-config, runs it, and uninstalls.
#     cmake -D BUILD=... -D FOLDER=... -D CONSUMER=... -D COMPILER=... -D LINK_FLAGS=... -D GENERATOR=...
#           -P package.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${status}\n${output}")
  endif()
endfunction()

function(expect_installed)
  file(GLOB_RECURSE installed RELATIVE ${prefix} ${prefix}/*)
  foreach(expected IN LISTS ARGV)
    if(NOT expected IN_LIST installed)
      message(FATAL_ERROR "${expected} is not installed; there is\n${installed}")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
set(prefix ${FOLDER}/installed)

# The program alone: nothing of the library comes along, and it finds its scenes.
run(${CMAKE_COMMAND} --install ${BUILD} --component program --prefix ${prefix})
expect_installed(bin/carom share/man/man1/carom.1 share/man/man1/carom-play.1 share/man/man1/carom-sweep.1
  share/man/man5/carom-scene.5 share/man/man5/carom-output.5 share/man/man7/carom-models.7
  share/man/man7/carom-algorithms.7 share/man/man7/carom-figures.7
  share/carom/scenes/break.json share/carom/scenes/scene.schema.json
  share/bash-completion/completions/carom share/zsh/site-functions/_carom
  share/fish/vendor_completions.d/carom.fish)
foreach(folder include lib)
  if(EXISTS ${prefix}/${folder})
    message(FATAL_ERROR "the component program installs ${folder}")
  endif()
endforeach()
run(${prefix}/bin/carom run gas --frames 1)

run(${CMAKE_COMMAND} --install ${BUILD} --component development --prefix ${prefix})
expect_installed(include/carom/simulation.hpp)
file(GLOB_RECURSE pkgconfig ${prefix}/*/carom.pc)

# The tree may be moved.
file(RENAME ${prefix} ${FOLDER}/moved)
string(REPLACE ${prefix} ${FOLDER}/moved pkgconfig ${pkgconfig})
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${FOLDER}/consumer -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${FOLDER}/moved -D CMAKE_EXE_LINKER_FLAGS=${LINK_FLAGS})
run(${CMAKE_COMMAND} --build ${FOLDER}/consumer)
run(${FOLDER}/consumer/consumer)

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  cmake_path(GET pkgconfig PARENT_PATH folder)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${PKG_CONFIG} --cflags --libs carom
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${COMPILER} -std=c++20 ${LINK_FLAGS} ${CONSUMER}/main.cpp ${flags} -o ${FOLDER}/by_pkg_config)
  run(${FOLDER}/by_pkg_config)
endif()

# Uninstalling removes every file that was installed.
file(RENAME ${FOLDER}/moved ${prefix})
run(${CMAKE_COMMAND} -D BUILD=${BUILD} -P ${CMAKE_CURRENT_LIST_DIR}/../../app/package/uninstall.cmake)
file(GLOB_RECURSE left ${prefix}/*)
if(left OR EXISTS ${prefix}/share/carom)
  message(FATAL_ERROR "uninstalling has left ${left}")
endif()
file(REMOVE_RECURSE ${FOLDER})
