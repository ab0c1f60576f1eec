# Run at build time by FfBuildInfo.cmake: fills build_info.hpp.in.

set(REVISION unknown)  # no git, or not a checkout: a release archive
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(COMMAND ${GIT} -C ${SOURCE_DIR} describe --always --dirty --exclude=* --abbrev=12
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(REVISION ${described})
  endif()
endif()
if(NOT SANITIZERS)
  set(SANITIZERS none)
endif()
configure_file(${TEMPLATE} ${HEADER} @ONLY)
