# ff_included_sources(app/gates_main.cpp VARIABLE): the sources that a program with this main needs. They are found by
# its includes: "studies/run/run.hpp" asks for studies/run/run.cpp, where there is one, and so on. Folders are those of
# the project that ROOT is.
#
# ff_included_headers(VARIABLE a.hpp b.hpp ...): these headers, and those of the project that they include.
#
# cmake -D ROOT=. -D MAIN=app/gates_main.cpp -P cmake/IncludedSources.cmake: prints all files that are read, with the
# headers of others, one a line, on stderr.

cmake_minimum_required(VERSION 3.25)

# With `sources` (ON or OFF), also the sources of each header, and what they include.
function(ff_included_files root files sources variable)
  set(found)
  set(next ${files})
  while(next)
    list(POP_FRONT next file)
    if(file IN_LIST found OR NOT EXISTS ${root}/${file})
      continue()
    endif()
    list(APPEND found ${file})
    file(STRINGS ${root}/${file} lines REGEX "^ *# *include *\"")
    list(TRANSFORM lines REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1")
    list(APPEND next ${lines})
    if(sources)
      list(TRANSFORM lines REPLACE "\\.hpp$" ".cpp")
      list(APPEND next ${lines})
    endif()
  endwhile()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

function(ff_included_sources main variable)
  ff_included_files(${PROJECT_SOURCE_DIR} ${main} ON files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})  # an include more may be a source more
  list(FILTER files INCLUDE REGEX "\\.cpp$")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

function(ff_included_headers variable)
  ff_included_files(${PROJECT_SOURCE_DIR} "${ARGN}" OFF files)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  ff_included_files(${ROOT} ${MAIN} ON files)
  foreach(file IN LISTS files)
    file(STRINGS ${ROOT}/${file} foreign REGEX "^ *# *include *<")
    list(TRANSFORM foreign REPLACE "^[^<]*(<[^>]*>).*" "\\1")
    message("${file}: ${foreign}")
  endforeach()
endif()
