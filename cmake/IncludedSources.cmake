# ff_included_sources(app/gates_main.cpp VARIABLE): the sources that a program with this main needs. They are found by
# its includes: "studies/run/run.hpp" asks for studies/run/run.cpp, where there is one, and so on. Folders are those of
# the project that ROOT is.
#
# cmake -D ROOT=. -D MAIN=app/gates_main.cpp -P cmake/IncludedSources.cmake: prints all files that are read, with the
# headers of others, one a line, on stderr.

cmake_minimum_required(VERSION 3.25)

function(ff_included_files root main variable)
  set(found)
  set(next ${main})
  while(next)
    list(POP_FRONT next file)
    if(file IN_LIST found OR NOT EXISTS ${root}/${file})
      continue()
    endif()
    list(APPEND found ${file})
    file(STRINGS ${root}/${file} lines REGEX "^ *# *include *\"")
    list(TRANSFORM lines REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1")
    set(sources ${lines})
    list(TRANSFORM sources REPLACE "\\.hpp$" ".cpp")
    list(APPEND next ${lines} ${sources})
  endwhile()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

function(ff_included_sources main variable)
  ff_included_files(${PROJECT_SOURCE_DIR} ${main} files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})  # an include more may be a source more
  list(FILTER files INCLUDE REGEX "\\.cpp$")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  ff_included_files(${ROOT} ${MAIN} files)
  foreach(file IN LISTS files)
    file(STRINGS ${ROOT}/${file} foreign REGEX "^ *# *include *<")
    list(TRANSFORM foreign REPLACE "^[^<]*(<[^>]*>).*" "\\1")
    message("${file}: ${foreign}")
  endforeach()
endif()
