# -DFFSTUDY_GATES_ONLY=ON: the smaller program. It judges what other programs report, and is built of the rooms that
# app/gates_main.cpp includes: no Embree, Eigen, Highway, SQLite, assimp or Node.js.

include(IncludedSources)
ff_included_sources(app/gates_main.cpp sources)
# Built in under a minute on two cores: what includes Boost.Math is compiled together, as its headers are most of the
# work, and only statistics are worth full optimisation. tests/install/gates_only measures it.
set(statistics ${sources})
list(FILTER statistics INCLUDE REGEX "^stats/")
list(REMOVE_ITEM sources ${statistics})
add_library(ff_statistics OBJECT ${statistics})
set_target_properties(ff_statistics PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
add_executable(ffstudy ${sources})
foreach(target ff_statistics ffstudy)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${target} PRIVATE FF_CONTRACTS=$<BOOL:${FFSTUDY_CONTRACTS}>)
  target_link_libraries(${target} PRIVATE ff_settings ff_build_info ff_random123 CLI11::CLI11 fmt::fmt
    nlohmann_json::nlohmann_json pugixml::pugixml tomlplusplus::tomlplusplus Threads::Threads)
endforeach()
target_compile_options(ffstudy PRIVATE -O1)
target_link_libraries(ffstudy PRIVATE ff_statistics)

install(TARGETS ffstudy)
include(FfManual)
include(FfInstallGate)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(FfPackages)
