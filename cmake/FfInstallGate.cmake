# find_package(ffstudy COMPONENTS gate): gates in the tests of others, by headers and by ffstudy_add_gate. In the smaller
# package they come with the program, elsewhere with the libraries.

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/ffstudy)

# ff_install_headers(COMPONENT core/*.hpp): users write <ffstudy/core/...>, and so do the installed headers.
function(ff_install_headers component)
  set(headers ${PROJECT_BINARY_DIR}/headers/${component})
  install(CODE "
    file(REMOVE_RECURSE \"${headers}\")
    foreach(pattern IN ITEMS ${ARGN})
      file(GLOB_RECURSE paths RELATIVE \"${PROJECT_SOURCE_DIR}\" \"${PROJECT_SOURCE_DIR}/\${pattern}\")
      foreach(path IN LISTS paths)
        file(READ \"${PROJECT_SOURCE_DIR}/\${path}\" text)
        string(REGEX REPLACE \"#include \\\"((core|samplers|stats|studies|reports)/[^\\\"]+)\\\"\"
          \"#include <ffstudy/\\\\1>\" text \"\${text}\")
        file(WRITE \"${headers}/\${path}\" \"\${text}\")
      endforeach()
    endforeach()" COMPONENT ${component})
  install(DIRECTORY ${headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy COMPONENT ${component})
endfunction()

set(component library)
if(FFSTUDY_GATES_ONLY)
  set(component program)
  ff_install_headers(program stats/gates/*.hpp)
endif()
configure_package_config_file(cmake/ffstudyConfig.cmake.in ${PROJECT_BINARY_DIR}/ffstudyConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/ffstudyConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/ffstudyGates.cmake cmake/ffstudyRunGate.cmake ${PROJECT_BINARY_DIR}/ffstudyConfig.cmake
  ${PROJECT_BINARY_DIR}/ffstudyConfigVersion.cmake DESTINATION ${package_dir} COMPONENT ${component})
install(FILES cmake/gate.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ffstudy COMPONENT ${component})
