# Targets for GMP, MPFR, MPC and MPFI, which have no CMake packages. The build and the installed package include this.
function(nipref_c_library target library header)
  if(TARGET ${target})
    return()
  endif()
  find_library(NIPREF_${library}_LIBRARY ${library} REQUIRED)
  find_path(NIPREF_${library}_INCLUDE_DIR ${header} REQUIRED)
  add_library(${target} UNKNOWN IMPORTED)
  set_target_properties(${target} PROPERTIES IMPORTED_LOCATION ${NIPREF_${library}_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${NIPREF_${library}_INCLUDE_DIR} INTERFACE_LINK_LIBRARIES "${ARGN}")
endfunction()

nipref_c_library(GMP::gmp gmp gmp.h)
nipref_c_library(GMP::gmpxx gmpxx gmpxx.h GMP::gmp)
nipref_c_library(MPFR::mpfr mpfr mpfr.h GMP::gmp)
nipref_c_library(MPC::mpc mpc mpc.h MPFR::mpfr)
nipref_c_library(MPFI::mpfi mpfi mpfi.h MPFR::mpfr)
