# cmake --install: the program, the libraries with their headers, the study files, the CMake package "ffstudy" with the
# targets ffstudy::core, ffstudy::samplers, ffstudy::stats, ffstudy::studies and ffstudy::reports, and ffstudy.pc.
# Components: program, runtime (shared libraries, where they are built), library (for developers).

include(CMakePackageConfigHelpers)

set(libraries core samplers stats studies reports)
list(TRANSFORM libraries PREPEND ff_ OUTPUT_VARIABLE targets)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ffstudy)

install(TARGETS ffstudy)
install(TARGETS ${targets} EXPORT ffstudy
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT library
  ARCHIVE COMPONENT library)
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(ffstudy PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  set_target_properties(${targets} PROPERTIES INSTALL_RPATH "$ORIGIN")
endif()

# Users write <ffstudy/core/...>, and so do the installed headers.
string(JOIN "|" any ${libraries})
set(headers ${PROJECT_BINARY_DIR}/headers)
foreach(library ${libraries})
  install(CODE "
    file(REMOVE_RECURSE \"${headers}/${library}\")
    file(GLOB_RECURSE paths RELATIVE \"${PROJECT_SOURCE_DIR}\" \"${PROJECT_SOURCE_DIR}/${library}/*.hpp\")
    foreach(path IN LISTS paths)
      file(READ \"${PROJECT_SOURCE_DIR}/\${path}\" text)
      string(REGEX REPLACE \"#include \\\"(${any})/([^\\\"]+)\\\"\" \"#include <ffstudy/\\\\1/\\\\2>\" text \"\${text}\")
      file(WRITE \"${headers}/\${path}\" \"\${text}\")
    endforeach()" COMPONENT library)
endforeach()
install(DIRECTORY ${headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy COMPONENT library
  PATTERN embree_version.hpp EXCLUDE)

install(DIRECTORY studies/built_in/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/studies)
install(DIRECTORY reports/templates/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/templates FILES_MATCHING PATTERN "*.mustache" PATTERN "report.*")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT ffstudy FILE ffstudyTargets.cmake NAMESPACE ffstudy:: DESTINATION ${package_dir} COMPONENT library)
configure_package_config_file(cmake/ffstudyConfig.cmake.in ${PROJECT_BINARY_DIR}/ffstudyConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ffstudyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/ffstudyGates.cmake cmake/ffstudyRunGate.cmake DESTINATION ${package_dir} COMPONENT library)
install(FILES include/ffstudy/plugin.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy COMPONENT library)
install(FILES cmake/gate.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy COMPONENT library)
install(FILES ${PROJECT_BINARY_DIR}/ffstudyConfig.cmake ${PROJECT_BINARY_DIR}/ffstudyConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT library)

file(RELATIVE_PATH FFSTUDY_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
if(FFSTUDY_CONTRACTS)
  set(FFSTUDY_CONTRACTS_VALUE 1)
else()
  set(FFSTUDY_CONTRACTS_VALUE 0)
endif()
configure_file(cmake/ffstudy.pc.in ${PROJECT_BINARY_DIR}/ffstudy.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/ffstudy.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
