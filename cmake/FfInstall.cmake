# cmake --install: the program, the libraries with their headers, the study files, and the CMake package "ffstudy" with
# the targets ffstudy::core, ffstudy::samplers, ffstudy::stats, ffstudy::studies and ffstudy::reports.

include(CMakePackageConfigHelpers)

set(libraries core samplers stats studies reports)
list(TRANSFORM libraries PREPEND ff_ OUTPUT_VARIABLE targets)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ffstudy)

install(TARGETS ffstudy)
install(TARGETS ${targets} EXPORT ffstudy)
foreach(library ${libraries})
  install(DIRECTORY ${library}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy/${library} FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(DIRECTORY studies/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/studies
  FILES_MATCHING PATTERN "*.toml" PATTERN "*.json")
install(DIRECTORY reports/templates/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/templates)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT ffstudy FILE ffstudyTargets.cmake NAMESPACE ffstudy:: DESTINATION ${package_dir})
configure_package_config_file(cmake/ffstudyConfig.cmake.in ${PROJECT_BINARY_DIR}/ffstudyConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ffstudyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ffstudyConfig.cmake ${PROJECT_BINARY_DIR}/ffstudyConfigVersion.cmake
  DESTINATION ${package_dir})
