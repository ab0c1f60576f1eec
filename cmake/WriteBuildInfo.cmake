# Run at build time by FfBuildInfo.cmake: fills build_info.hpp.in.

# In an archive made by git, revision.txt names the commit instead of asking for it.
file(READ ${CMAKE_CURRENT_LIST_DIR}/revision.txt archived)
set(REVISION unknown)
if(archived MATCHES "^[0-9a-f]+")
  string(SUBSTRING ${archived} 0 12 REVISION)
endif()
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
