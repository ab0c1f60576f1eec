# Every library the project uses, all packaged in Debian 12 and 13 (scripts/packages.txt). Those that installed targets link to
# are looked up again by cmake/ffstudyConfig.cmake.in: keep the two in step.

find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED CONFIG)   # Random, Math: headers only
find_package(fmt 9 REQUIRED)
find_package(CLI11 2 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(pugixml 1.13 REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h REQUIRED)
add_library(ff_random123 INTERFACE)
target_include_directories(ff_random123 SYSTEM INTERFACE $<BUILD_INTERFACE:${RANDOM123_INCLUDE_DIR}>)

# The smaller program needs no more.
if(FFSTUDY_GATES_ONLY)
  return()
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(embree REQUIRED)             # 3 or 4
if(embree_VERSION VERSION_LESS 3.13 OR embree_VERSION VERSION_GREATER_EQUAL 5)
  message(FATAL_ERROR "Embree ${embree_VERSION} was found in ${embree_DIR}; ffstudy knows 3.13 and later, and 4.")
endif()
string(REGEX MATCH "^[0-9]+" FFSTUDY_EMBREE_MAJOR ${embree_VERSION})
add_library(ff_embree INTERFACE)
target_link_libraries(ff_embree INTERFACE embree)
target_compile_definitions(ff_embree INTERFACE FF_EMBREE_MAJOR=${FFSTUDY_EMBREE_MAJOR})
find_package(hwy 1.0 REQUIRED)
find_package(SQLite3 3.40 REQUIRED)
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)   # SHA-256 of what a report runs

if(FFSTUDY_PYTHON)
  # The system's Python, whose NumPy is the one that is packaged with it, unless another is asked for.
  if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python that the module is for")
  endif()
  set(PYBIND11_FINDPYTHON ON)
  if(FFSTUDY_PYTHON STREQUAL "AUTO")
    find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
    if(Python_FOUND)
      find_package(pybind11 2.10 QUIET CONFIG)
    endif()
    if(NOT pybind11_FOUND)
      message(STATUS "The Python module is left out: it needs Python's headers and pybind11 (python3-dev, pybind11-dev).")
    endif()
  else()
    find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
    find_package(pybind11 2.10 REQUIRED CONFIG)
  endif()
  if(pybind11_FOUND)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # the libraries become part of a module
  endif()
endif()

if(FFSTUDY_MPI)
  enable_language(C)  # of MPI only the C interface is used, and CMake looks for it with a C compiler
  find_package(MPI 3 REQUIRED COMPONENTS C)
endif()

find_package(ZLIB REQUIRED)   # compressed arrays of VTK's XML

# Meshes: STL, PLY, OFF, glTF. Its own CMake files would want the headers of zlib and Draco as well.
find_path(ASSIMP_INCLUDE_DIR assimp/Importer.hpp REQUIRED)
find_library(ASSIMP_LIBRARY assimp REQUIRED)

find_path(MUSTACHE_INCLUDE_DIR kainjow/mustache.hpp REQUIRED)
add_library(ff_mustache INTERFACE)
target_include_directories(ff_mustache SYSTEM INTERFACE $<BUILD_INTERFACE:${MUSTACHE_INCLUDE_DIR}>)
