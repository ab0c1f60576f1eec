# cmake --install: the program, the libraries with their headers, the study files, the CMake package "ffstudy" with the
# targets ffstudy::core, ffstudy::samplers, ffstudy::stats, ffstudy::studies and ffstudy::reports, and ffstudy.pc.
# Components: program, runtime (shared libraries, where they are built), library (for developers).

include(FfInstallGate)
include(IncludedSources)

# What programs of others may include (docs/library.md). The headers that these include are installed with them; all
# others stay inside.
set(public_headers
  core/estimators/added.hpp
  core/estimators/pairs/patch_pairs.hpp
  core/exact/exact.hpp
  core/geometry/box.hpp
  core/points/stream.hpp
  core/radiosity/solver.hpp
  samplers/outside/added.hpp
  samplers/sampler.hpp
  stats/convergence/convergence.hpp
  stats/error_rates/multiplicity.hpp
  stats/gates/gate_macros.hpp  # of ffstudy/gate.hpp
  stats/means/mean_test.hpp
  stats/shares/share_test.hpp
  stats/variances/variance_interval.hpp
  studies/form_factors/form_factors.hpp
  studies/outside/outside_code.hpp
  studies/plan/plan.hpp
  studies/results/results.hpp
  studies/run/run.hpp
  studies/scene_files/scene_file.hpp
  studies/spec/spec.hpp
  studies/store/store.hpp
  reports/html/html.hpp
  reports/json/json.hpp
  reports/markdown/markdown.hpp)

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

ff_included_headers(library_headers ${public_headers})
ff_install_headers(library ${library_headers})

install(DIRECTORY studies/built_in/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/studies)
install(DIRECTORY reports/templates/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/templates FILES_MATCHING PATTERN "*.mustache" PATTERN "report.*" PATTERN "scene_report.*")
install(DIRECTORY reports/vendor/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/templates)
install(FILES docs/glossary.md DESTINATION ${CMAKE_INSTALL_DATADIR}/ffstudy/docs)
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
