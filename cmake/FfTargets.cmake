# Settings that every target of the project shares, in one place.

option(FFSTUDY_CONTRACTS "Check FF_EXPECT and FF_ENSURE at run time" OFF)
option(FFSTUDY_WERROR "Treat warnings as errors; the presets for developers do" OFF)
set(FFSTUDY_HOT_OPTIONS "" CACHE STRING "Further compiler options for what computes: core, samplers and stats")
set(FFSTUDY_SANITIZE "" CACHE STRING "Sanitizers for -fsanitize=, e.g. address,undefined")

add_library(ff_settings INTERFACE)
target_compile_features(ff_settings INTERFACE cxx_std_20)
target_compile_options(ff_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  -Wold-style-cast -Woverloaded-virtual)
if(FFSTUDY_WERROR)
  target_compile_options(ff_settings INTERFACE -Werror)
endif()

# g++ collects garbage less often, which saves 5 to 10 % of its time. clang-tidy, which reads the commands of the preset
# "edit", does not know the option.
if(CMAKE_UNITY_BUILD)
  target_compile_options(ff_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)
endif()

# Flags that decide results; the program reports them. a*b+c must round twice on every CPU, or hit counts would differ
# between machines.
set(FF_CODE_GENERATION -ffp-contract=off)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  # Highway's dispatch starts here and chooses AVX2 or AVX-512 at run time.
  list(APPEND FF_CODE_GENERATION -march=x86-64-v2)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
  # All have NEON, so that nothing is chosen at run time. Vectors of the scalable extension cannot be members of a struct.
  # Boost.Math would compute quantiles in long double, which has 128 bits there and is emulated.
  target_compile_definitions(ff_settings INTERFACE
    HWY_COMPILE_ONLY_STATIC "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)"
    BOOST_MATH_PROMOTE_DOUBLE_POLICY=false)
  # g++ notes every call that passes a pair of numbers, since version 10 does so in another way.
  target_compile_options(ff_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>)
endif()
target_compile_options(ff_settings INTERFACE ${FF_CODE_GENERATION})
if(FFSTUDY_SANITIZE)
  target_compile_options(ff_settings INTERFACE -fsanitize=${FFSTUDY_SANITIZE} -fno-omit-frame-pointer)
  # In instrumented code g++ takes storage that a library fills later for used before that.
  target_compile_options(ff_settings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(ff_settings INTERFACE -fsanitize=${FFSTUDY_SANITIZE})
endif()

# What is for use reads files of strangers: buffers and the stack are watched, and what the loader fills in is read-only
# once it has. Decides no result; the hot loops write to no array on the stack. tests/cli/hardened looks at the program.
if(FFSTUDY_SANITIZE)
  set(hardened 0)
else()
  set(hardened $<CONFIG:Release>)
endif()
target_compile_options(ff_settings INTERFACE
  $<${hardened}:-U_FORTIFY_SOURCE> $<${hardened}:-D_FORTIFY_SOURCE=2> $<${hardened}:-fstack-protector-strong>
  $<$<AND:${hardened},$<NOT:$<BOOL:$<TARGET_PROPERTY:POSITION_INDEPENDENT_CODE>>>>:-fPIE>)
target_link_options(ff_settings INTERFACE
  $<$<AND:${hardened},$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>>:-pie> $<${hardened}:LINKER:-z,relro> $<${hardened}:LINKER:-z,now>)

# ff_rooms(TARGET [all | a+b ...])
#
# With CMAKE_UNITY_BUILD the .cpp files of a folder are compiled as one unit, of at most 40 files. Folders named together,
# like "exact+geometry", count as one folder, "." is the folder of the target itself, and "all" puts the whole target
# together. Most of a small file's compile time is its headers, which this reads once for all of them. Names are unique
# within such a room, also in anonymous namespaces. Files that Highway compiles several times stay alone. The preset
# "edit" compiles each file alone, and shows which one forgets an include.
# Precompiled headers would save nothing more (measured: docs/decisions/0063-folders-compile-as-units.md).
function(ff_rooms target)
  foreach(together ${ARGN})
    string(REPLACE "+" ";" folders ${together})
    foreach(folder ${folders})
      set(room_of_${folder} ${together})
    endforeach()
  endforeach()

  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(rooms "")
  foreach(source ${sources})
    get_filename_component(path ${source} ABSOLUTE)
    file(STRINGS ${path} compiled_several_times REGEX "hwy/foreach_target" LIMIT_COUNT 1)
    if(compiled_several_times)
      continue()
    endif()
    get_filename_component(room ${source} DIRECTORY)
    if(ARGN STREQUAL "all")
      set(room all)
    elseif(room STREQUAL "")
      set(room .)
    endif()
    if(DEFINED room_of_${room})
      set(room ${room_of_${room}})
    endif()
    string(MAKE_C_IDENTIFIER "${target}/${room}" room)
    list(APPEND rooms ${room})
    list(APPEND files_of_${room} ${source})
  endforeach()

  list(REMOVE_DUPLICATES rooms)
  foreach(room ${rooms})
    list(SORT files_of_${room})
    list(LENGTH files_of_${room} count)
    math(EXPR units "(${count} + 39) / 40")
    set(index 0)
    foreach(source ${files_of_${room}})
      math(EXPR unit "${index} * ${units} / ${count}")
      set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${unit})
      math(EXPR index "${index} + 1")
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# ff_library(core SOURCES a.cpp b.cpp LINKS fmt::fmt PRIVATE_LINKS embree TOGETHER points+support)
#
# One folder, one library: core/ -> target ff_core, alias ff::core, include "core/...", installed as <ffstudy/core/...>.
function(ff_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS;TOGETHER" ${ARGN})
  add_library(ff_${name} ${ARG_SOURCES})
  add_library(ff::${name} ALIAS ff_${name})
  target_include_directories(ff_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(ff_${name} PUBLIC ${ARG_LINKS} PRIVATE $<BUILD_INTERFACE:ff_settings> ${ARG_PRIVATE_LINKS})
  target_compile_features(ff_${name} PUBLIC cxx_std_20)
  target_compile_definitions(ff_${name} PUBLIC FF_CONTRACTS=$<BOOL:${FFSTUDY_CONTRACTS}>)
  ff_rooms(ff_${name} ${ARG_TOGETHER})
  # Until 1.0 each minor version may change the interface.
  set_target_properties(ff_${name} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME ffstudy_${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endfunction()
