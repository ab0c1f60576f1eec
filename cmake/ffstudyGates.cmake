# ffstudy_add_gate(NAME name COMMAND program [arguments...] BANDS bands.toml [AGAINST old.csv] [TIMEOUT seconds])
#
# A test that runs the command, takes what it prints for the file of --estimates, and checks it against the bands. It
# passes where all gates pass; inconclusive is not a pass. Estimates and verdicts are in the folder NAME of the binary
# directory. AGAINST and BANDS are taken from the source directory. Label: gate.

find_program(FFSTUDY_PROGRAM ffstudy HINTS ${CMAKE_CURRENT_LIST_DIR}/../../../bin ${CMAKE_CURRENT_LIST_DIR}/../../../../bin
  DOC "The program that checks gates")
set(FFSTUDY_RUN_GATE ${CMAKE_CURRENT_LIST_DIR}/ffstudyRunGate.cmake)

function(ffstudy_add_gate)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "NAME;BANDS;AGAINST;TIMEOUT" "COMMAND")
  foreach(needed NAME BANDS COMMAND)
    if(NOT ARG_${needed})
      message(FATAL_ERROR "ffstudy_add_gate: ${needed} is missing")
    endif()
  endforeach()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "ffstudy_add_gate: unknown arguments: ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  foreach(file BANDS AGAINST)
    if(ARG_${file})
      get_filename_component(${file} ${ARG_${file}} ABSOLUTE)
    endif()
  endforeach()
  # Targets are the programs that they build.
  list(POP_FRONT ARG_COMMAND program)
  if(TARGET ${program})
    set(program $<TARGET_FILE:${program}>)
  endif()
  add_test(NAME ${ARG_NAME} COMMAND ${CMAKE_COMMAND}
    -D FFSTUDY=${FFSTUDY_PROGRAM} -D BANDS=${BANDS} -D AGAINST=${AGAINST}
    -D FOLDER=${CMAKE_CURRENT_BINARY_DIR}/${ARG_NAME}
    -P ${FFSTUDY_RUN_GATE} -- ${program} ${ARG_COMMAND})
  set_tests_properties(${ARG_NAME} PROPERTIES LABELS gate)
  if(ARG_TIMEOUT)
    set_tests_properties(${ARG_NAME} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  endif()
endfunction()
