# Packages: a .tar.gz of everything, and for Debian carom and libcarom-dev.
#     cmake --workflow --preset package
set(CPACK_PACKAGE_NAME carom)
set(CPACK_PACKAGE_VENDOR "The carom authors")
set(CPACK_PACKAGE_CONTACT "The carom authors <carom@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_RESOURCE_FILE_README ${PROJECT_SOURCE_DIR}/README.md)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_GENERATOR TGZ DEB)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${CPACK_PACKAGE_CONTACT})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME carom)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "colliding balls in a terminal, with the price of accuracy
carom simulates hard disks in a plane and shows them in a terminal.
A scene names the effects it wants (walls, collisions, gravity, drag,
friction, attraction), and only these are computed, exactly from impact
to impact or in time steps, in 16 to 100 digits.

It measures what each way of computing a scene costs and how wrong it
is, and writes trajectories, series and reports for other programs.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcarom-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfmt-dev, libmpfr-dev, libgmp-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "engine of carom for other programs
The library with which carom simulates hard disks in a plane: scenes,
simulations, measurements and a pool of worker threads, in C++20.

This package holds the static library, its headers, and the files by
which CMake and pkg-config find it.")

# What only Debian's packages hold; put into them before they are packed.
string(TIMESTAMP CAROM_PACKAGE_DATE "%a, %d %b %Y 00:00:00 +0000" UTC)
foreach(CAROM_PACKAGE carom libcarom-dev)
  configure_file(app/package/debian_changelog.in
    ${PROJECT_BINARY_DIR}/debian/${CAROM_PACKAGE}/changelog @ONLY)
endforeach()
set(CPACK_CAROM_DEBIAN_FILES ${PROJECT_BINARY_DIR}/debian)
set(CPACK_CAROM_SOURCES ${PROJECT_SOURCE_DIR})
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_files.cmake)
include(CPack)
