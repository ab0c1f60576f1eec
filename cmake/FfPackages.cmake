# cpack -G DEB, by scripts/package: ffstudy (the program), ffstudy-gates (the smaller one), libffstudy-dev (static libraries, headers, CMake package,
# pkg-config file), and libffstudy where the libraries are shared.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program)
if(NOT FFSTUDY_GATES_ONLY)
  list(APPEND CPACK_COMPONENTS_ALL library)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/CompressManPages.cmake)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "laboratory for form-factor methods under honest statistics")
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGE_CONTACT "the ffstudy maintainers <ffstudy@localhost>")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ffstudy)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "nodejs, librsvg2-bin")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Repeats computations of form factors (view factors) with seeded trials, and
says how large bias and spread are against exact values, and how sure that is.")

if(FFSTUDY_GATES_ONLY)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ffstudy-gates)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONFLICTS "ffstudy, libffstudy-dev")  # which have all of it, under the same names
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "statistical gates on what Monte Carlo codes report")
  set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Judges means with their errors, or trials, against bands: pass, fail or
inconclusive, with both risks stated. With headers for unit tests, and a
function for CTest.")
endif()

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libffstudy-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libeigen3-dev, libembree-dev, libfmt-dev, libhwy-dev, libpugixml-dev, \
libassimp-dev, libsqlite3-dev, libssl-dev, libtomlplusplus-dev, nlohmann-json3-dev, zlib1g-dev")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Libraries and headers of ffstudy, with a CMake package and a pkg-config
file.")

if(BUILD_SHARED_LIBS)
  list(APPEND CPACK_COMPONENTS_ALL runtime)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libffstudy${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
  set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "What the program and programs of users load.")
  # Require the packages of this very build: no version promises that its libraries work with the program of another.
  set(same "${CPACK_DEBIAN_RUNTIME_PACKAGE_NAME} (= ${PROJECT_VERSION}-1)")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${same}")
  string(APPEND CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS ", ${same}")
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/core ${PROJECT_BINARY_DIR}/samplers
    ${PROJECT_BINARY_DIR}/stats ${PROJECT_BINARY_DIR}/studies ${PROJECT_BINARY_DIR}/reports)
endif()

# What Debian asks of every package: copyright and a compressed list of changes.
find_program(GZIP gzip)
set(copyright "Upstream-Name: ffstudy\n\nLicensed under the Apache License, Version 2.0:\n")
string(APPEND copyright "see /usr/share/common-licenses/Apache-2.0.\n")
file(READ ${PROJECT_SOURCE_DIR}/reports/vendor/LICENCES licences)
string(APPEND copyright "\nIn the package ffstudy, ${licences}")
file(WRITE ${PROJECT_BINARY_DIR}/copyright "Copyright (C) 2026 the ffstudy maintainers\n${copyright}")
if(GZIP)
  execute_process(COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz)
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(to ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(debian ${PROJECT_BINARY_DIR}/${component}-changelog)
    file(WRITE ${debian} "ffstudy (${PROJECT_VERSION}-1) unstable; urgency=low\n\n  * See changelog.gz.\n\n"
      " -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
    execute_process(COMMAND ${GZIP} -9nc ${debian} OUTPUT_FILE ${debian}.gz)
    install(FILES ${debian}.gz DESTINATION ${to} RENAME changelog.Debian.gz COMPONENT ${component})
    install(FILES ${PROJECT_BINARY_DIR}/copyright ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${to}
      COMPONENT ${component})
  endforeach()
endif()
include(CPack)
