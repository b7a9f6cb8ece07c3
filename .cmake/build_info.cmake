# Makes nipref_build_info.hpp from verify/support/internal/build_info.hpp.in. CMake fills in constants when it configures.
# This file, run as a script in every build, fills in commit and build type; it writes the header only if they change.
if(CMAKE_SCRIPT_MODE_FILE)
  function(ask_git variable)
    execute_process(COMMAND git -C ${source} ${ARGN} OUTPUT_VARIABLE answer RESULT_VARIABLE status ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT status EQUAL 0)
      set(answer unknown)
    endif()
    set(${variable} ${answer} PARENT_SCOPE)
  endfunction()
  set(commit unknown)
  set(commit_date unknown)
  ask_git(top rev-parse --show-toplevel)
  if(top STREQUAL source)  # not a folder in somebody else's repository
    ask_git(commit describe --always --dirty --abbrev=40 --exclude=*)
    ask_git(commit_date log -1 --format=%cI)
  endif()
  configure_file(${template} ${header})
  return()
endif()

# The version that HEADER of the imported TARGET defines, as one text or as numbers in several lines.
function(nipref_version_in_header variable target header pattern)
  get_target_property(directory ${target} INTERFACE_INCLUDE_DIRECTORIES)
  file(STRINGS ${directory}/${header} lines REGEX "define +${pattern}")
  list(TRANSFORM lines REPLACE ".* \"?([0-9.a-z-]+)\"?$" "\\1")
  list(JOIN lines "." version)
  set(${variable} "${version}" PARENT_SCOPE)
endfunction()

# A target that keeps HEADER up to date.
function(nipref_build_info target header)
  nipref_version_in_header(GMP_VERSION GMP::gmp gmp.h "__GNU_MP_VERSION(_MINOR|_PATCHLEVEL)? ")
  nipref_version_in_header(MPFR_VERSION MPFR::mpfr mpfr.h MPFR_VERSION_STRING)
  nipref_version_in_header(MPC_VERSION MPC::mpc mpc.h MPC_VERSION_STRING)
  nipref_version_in_header(MPFI_VERSION MPFI::mpfi mpfi.h MPFI_VERSION_STRING)
  set(libraries "")
  foreach(library Boost Eigen3 fmt GMP GSL MPC MPFI MPFR nlohmann_json)
    set(version ${${library}_VERSION})
    if(version STREQUAL "")
      set(version unknown)
    endif()
    string(APPEND libraries "    {\"${library}\", \"${version}\"},\n")
  endforeach()
  set(template ${CMAKE_CURRENT_BINARY_DIR}/build_info.hpp.in)
  configure_file(support/internal/build_info.hpp.in ${template} @ONLY)
  file(REAL_PATH ${PROJECT_SOURCE_DIR} source)
  add_custom_target(${target} BYPRODUCTS ${header} VERBATIM
    COMMAND ${CMAKE_COMMAND} -D source=${source} -D template=${template} -D header=${header} -D build_type=$<CONFIG>
      -P ${PROJECT_SOURCE_DIR}/.cmake/build_info.cmake)
endfunction()
