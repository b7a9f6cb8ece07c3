# nipref_add_kernel_check(NAME test QUANTITY I1 TARGET mylib [SYMBOL f | KERNEL name] [PROMISE 4] [POINTS 10000]
#   [RANGES alpha=1e-3..50 ...] [BASELINE file.toml] [JUNIT file.xml] [TIME_LIMIT 10] [THREAD_SAFE])
#
# Adds a test to CTest that grades a function or a kernel of a shared library or module. The options are those of
# `nipref help grade`. SYMBOL is a double f(double, ...), KERNEL a kernel that the library lists as in nipref/kernel.h.
# Without both, all kernels of the quantity are graded. The largest error found is a measurement of the test. BASELINE
# is a file of the source folder, which the same call with --update-baseline writes from any folder (`ctest -V` shows
# the call). An error is compared with the entry of the same quantity, symbol or kernel, library file without folder and
# version, RANGES, POINTS, compiler of nipref and instruction set. Without the file or the entry the test fails.
function(nipref_add_kernel_check)
  set(values NAME QUANTITY TARGET SYMBOL KERNEL PROMISE POINTS BASELINE JUNIT TIME_LIMIT)
  cmake_parse_arguments(PARSE_ARGV 0 CHECK "THREAD_SAFE" "${values}" "RANGES")
  if(CHECK_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "nipref_add_kernel_check: unknown arguments ${CHECK_UNPARSED_ARGUMENTS}")
  endif()
  foreach(needed NAME QUANTITY TARGET)
    if(NOT DEFINED CHECK_${needed})
      message(FATAL_ERROR "nipref_add_kernel_check needs ${needed}")
    endif()
  endforeach()
  get_target_property(type ${CHECK_TARGET} TYPE)
  if(NOT type MATCHES "^(SHARED|MODULE)_LIBRARY$")
    message(FATAL_ERROR "nipref_add_kernel_check: ${CHECK_TARGET} must be a shared library or a module, is ${type}")
  endif()

  if(DEFINED CHECK_BASELINE)
    cmake_path(ABSOLUTE_PATH CHECK_BASELINE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  set(options --ctest --quiet)
  if(CHECK_SYMBOL)
    list(APPEND options --symbol ${CHECK_SYMBOL} --quantity ${CHECK_QUANTITY})
  elseif(CHECK_KERNEL)
    list(APPEND options ${CHECK_KERNEL})
  else()
    list(APPEND options ${CHECK_QUANTITY})
  endif()
  foreach(option promise points baseline junit time-limit)
    string(TOUPPER ${option} name)
    string(REPLACE "-" "_" name ${name})
    if(DEFINED CHECK_${name})
      list(APPEND options --${option} ${CHECK_${name}})
    endif()
  endforeach()
  if(CHECK_THREAD_SAFE)
    list(APPEND options --thread-safe)
  endif()
  add_test(NAME ${CHECK_NAME} COMMAND nipref::nipref grade $<TARGET_FILE:${CHECK_TARGET}> ${options} ${CHECK_RANGES})
endfunction()
