# cmake --install: the program, the libraries with their headers, the study files, the CMake package "ffstudy" with the
# targets ffstudy::core, ffstudy::samplers, ffstudy::stats, ffstudy::studies and ffstudy::reports, and ffstudy.pc.
# Components: program, runtime (shared libraries, where they are built), library (for developers).

include(FfInstallGate)

set(libraries core samplers stats studies reports)
list(TRANSFORM libraries PREPEND ff_ OUTPUT_VARIABLE targets)

install(TARGETS ffstudy)
install(TARGETS ${targets} EXPORT ffstudy
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT library
  ARCHIVE COMPONENT library)
if(BUILD_SHARED_LIBS)
  file(RELATIVE_PATH to_libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(ffstudy PROPERTIES INSTALL_RPATH "$ORIGIN/${to_libraries}")
  set_target_properties(${targets} PROPERTIES INSTALL_RPATH "$ORIGIN")
endif()

foreach(library ${libraries})
  ff_install_headers(library ${library}/*.hpp)
endforeach()

install(DIRECTORY studies/built_in/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/studies)
install(DIRECTORY reports/templates/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/templates FILES_MATCHING PATTERN "*.mustache" PATTERN "report.*" PATTERN "scene_report.*")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT ffstudy FILE ffstudyTargets.cmake NAMESPACE ffstudy:: DESTINATION ${package_dir} COMPONENT library)
install(FILES include/ffstudy/plugin.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy COMPONENT library)

file(RELATIVE_PATH FFSTUDY_PC_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
if(FFSTUDY_CONTRACTS)
  set(FFSTUDY_CONTRACTS_VALUE 1)
else()
  set(FFSTUDY_CONTRACTS_VALUE 0)
endif()
configure_file(cmake/ffstudy.pc.in ${PROJECT_BINARY_DIR}/ffstudy.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/ffstudy.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)
