# Run at build time: installs the packages of the lock file into WORK, and compiles the pictures into OUT. Where the npm
# registry cannot be reached the build continues without pictures.

file(GLOB sources ${SOURCE}/*.json ${SOURCE}/*.js ${SOURCE}/*.mjs)
file(COPY ${sources} DESTINATION ${WORK})

include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/NpmPackages.cmake)
install_npm_packages(${WORK} ${NODE} failed)
if(failed)
  message(NOTICE "${failed} Reports will tell their pictures in words. "
    "Configure and build again when the npm registry can be reached.")
  return()
endif()

file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${NODE} build.mjs ${OUT} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
