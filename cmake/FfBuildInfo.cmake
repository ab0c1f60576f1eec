# "app/build_info.hpp", generated in the build tree: version, git revision, compiler, flags, where the study files are.
# The revision is looked up at every build, so that it is never stale; the header is rewritten only when it changed.
# Link ff_build_info to include it.

string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
string(JOIN " " flags ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${FF_CODE_GENERATION})
string(STRIP "${flags}" flags)

set(header ${PROJECT_BINARY_DIR}/generated/app/build_info.hpp)
add_custom_target(ff_write_build_info
  COMMAND ${CMAKE_COMMAND}
    -D "SOURCE_DIR=${PROJECT_SOURCE_DIR}"
    -D "BINARY_DIR=${PROJECT_BINARY_DIR}"
    -D "TEMPLATE=${CMAKE_CURRENT_LIST_DIR}/build_info.hpp.in"
    -D "HEADER=${header}"
    -D "VERSION=${PROJECT_VERSION}"
    -D "COMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    -D "BUILD_TYPE=${CMAKE_BUILD_TYPE}"
    -D "FLAGS=${flags}"
    -D "SANITIZERS=${FFSTUDY_SANITIZE}"
    -D "DATA_DIR=${FFSTUDY_DATA_DIR}"
    -P ${CMAKE_CURRENT_LIST_DIR}/WriteBuildInfo.cmake
  BYPRODUCTS ${header}
  COMMENT "Noting the git revision"
  VERBATIM)

add_library(ff_build_info INTERFACE)
target_include_directories(ff_build_info INTERFACE ${PROJECT_BINARY_DIR}/generated)
add_dependencies(ff_build_info ff_write_build_info)
