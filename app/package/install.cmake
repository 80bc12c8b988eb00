# What is installed, in two components:
#     program      the program with its manual pages, scenes and completions
#     development  the engine for other programs: find_package(carom), or pkg-config carom
# cmake --install BUILD [--component NAME]; ninja -C BUILD uninstall removes what was installed.
include(CMakePackageConfigHelpers)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS carom)
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/carom USE_SOURCE_PERMISSIONS)
foreach(section 1 5 7)
  file(GLOB pages CONFIGURE_DEPENDS man/*.${section})
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man${section})
endforeach()
install(FILES ${CAROM_COMPLETIONS}/bash/carom
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${CAROM_COMPLETIONS}/zsh/_carom DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${CAROM_COMPLETIONS}/fish/carom.fish
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(CAROM_CMAKE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/carom)
install(TARGETS carom_engine EXPORT carom)
install(DIRECTORY engine/include/carom DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT carom FILE caromTargets.cmake NAMESPACE carom:: DESTINATION ${CAROM_CMAKE_FOLDER})
configure_package_config_file(engine/caromConfig.cmake.in ${PROJECT_BINARY_DIR}/caromConfig.cmake
  INSTALL_DESTINATION ${CAROM_CMAKE_FOLDER})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/caromConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/caromConfig.cmake ${PROJECT_BINARY_DIR}/caromConfigVersion.cmake
  DESTINATION ${CAROM_CMAKE_FOLDER})
# The folders are found from the file's own place, so that the installed tree may be moved.
file(RELATIVE_PATH CAROM_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(engine/carom.pc.in ${PROJECT_BINARY_DIR}/carom.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/carom.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR}
  -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake VERBATIM)
