# Run at build time: installs the packages of the lock file into WORK, and compiles the pictures into OUT. Where the npm
# registry cannot be reached the build goes on without pictures.

file(GLOB sources ${SOURCE}/*.json ${SOURCE}/*.js ${SOURCE}/*.mjs)
file(COPY ${sources} DESTINATION ${WORK})

file(SHA256 ${SOURCE}/package-lock.json wanted)
set(installed)
if(EXISTS ${WORK}/installed)
  file(READ ${WORK}/installed installed)
endif()
if(NOT wanted STREQUAL installed)
  execute_process(
    COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=60000
    WORKING_DIRECTORY ${WORK} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE failed)
  if(failed)
    message(NOTICE "${said}\nnpm cannot install what pictures need: reports will tell them in words. "
      "Configure and build again when the npm registry can be reached.")
    return()
  endif()
  file(WRITE ${WORK}/installed ${wanted})
endif()

file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${NODE} build.mjs ${OUT} WORKING_DIRECTORY ${WORK} COMMAND_ERROR_IS_FATAL ANY)
