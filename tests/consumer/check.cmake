# Installs the build into a fresh prefix, moves it, and uses it as strangers do: from their own folders, with their own
# projects, without the packages that its components do not need. Then removes it.
set(work ${build}/consumer)
set(prefix ${work}/prefix)
set(moved ${work}/moved)
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
unset(ENV{NIPREF_DATA})

# Packages that were unpacked because they could not be installed count as installed in this test.
file(GLOB unpacked ${build}/packages/usr/lib/*-linux-*)
if(unpacked)
  cmake_path(GET unpacked FILENAME architecture)
  set(ENV{CMAKE_PREFIX_PATH} ${build}/packages/usr)
  set(ENV{CPATH} ${build}/packages/usr/include:${build}/packages/usr/include/${architecture})
  set(ENV{LIBRARY_PATH} ${unpacked})
  set(ENV{LD_LIBRARY_PATH} ${unpacked})
endif()

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${work}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "should have said ${pattern}: ${output}")
  endif()
endfunction()

function(expect_not pattern)
  if(output MATCHES "${pattern}")
    message(FATAL_ERROR "has ${CMAKE_MATCH_0}, which should not be there: ${output}")
  endif()
endfunction()

# The build's own list of installed files is kept.
set(manifest ${build}/install_manifest.txt)
if(EXISTS ${manifest})
  file(RENAME ${manifest} ${work}/owners_manifest.txt)
endif()
run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
file(RENAME ${manifest} ${work}/install_manifest.txt)
if(EXISTS ${work}/owners_manifest.txt)
  file(RENAME ${work}/owners_manifest.txt ${manifest})
endif()
file(RENAME ${prefix} ${moved})

# The program reads the files beside it, neither those of the source tree nor those of the first prefix.
file(READ ${moved}/share/nipref/tables/thesis-VII.csv table)
string(REPLACE "Elastic rolling, complete slip" "The moved table" table "${table}")
file(WRITE ${moved}/share/nipref/tables/thesis-VII.csv "${table}")
run(${moved}/bin/nipref tables --list)
expect("thesis-VII [^\n]*\n[^\n]*The moved table")
foreach(text man/man1/nipref.1 bash-completion/completions/nipref zsh/vendor-completions/_nipref fish/vendor_completions.d/nipref.fish)
  file(READ ${moved}/share/${text} output)
  expect("no.*times")
endforeach()
file(READ ${moved}/share/doc/nipref/ref/sheet/README.md output)
expect("## Roots")
file(READ ${moved}/share/doc/nipref/README.md output)
expect("# nipref")

# A missing component is named as the reason.
file(WRITE ${work}/unknown.cmake "cmake_minimum_required(VERSION 3.25)
find_package(nipref REQUIRED COMPONENTS fortran)")
execute_process(COMMAND ${CMAKE_COMMAND} -D nipref_ROOT=${moved} -P ${work}/unknown.cmake ERROR_VARIABLE output RESULT_VARIABLE status)
expect("Component[ \n]+fortran[ \n]+is[ \n]+not[ \n]+installed")

# The kernel of a user who has only the program and its header.
file(WRITE ${work}/mine.c "#include <math.h>
#include <nipref/kernel.h>
double f(double alpha) { return alpha == 0 ? 0 : copysign(1.5707963267948966, alpha); }
static int evaluate(void* state, size_t n, const double* const* arguments, double* out) {
  for (size_t i = 0; i < n; ++i) out[i] = f(arguments[0][i]);
  return state != 0;
}
static const nipref_kernel mine = {NIPREF_KERNEL_ABI, sizeof(nipref_kernel), \"mine\", \"I2\", 1, 0, 0, evaluate, 0};
const nipref_kernel* const* nipref_kernels(void) {
  static const nipref_kernel* const all[] = {&mine, 0};
  return all;
}
")
find_program(cc NAMES cc)
run(${cc} -shared -fPIC -I ${moved}/include ${work}/mine.c -o ${work}/mine.so -lm)
run(${moved}/bin/nipref grade ./mine.so --points 500)
expect("mine of[ \n]+[^ \n]*mine.so[ \n]+as[ \n]+I2,[ \n]+its[ \n]+domain:[ \n]+PASS")
run(${moved}/bin/nipref grade ./mine.so --symbol f --quantity I2 --points 500)
expect("f of[ \n]+[^ \n]*mine.so[ \n]+as[ \n]+I2,[ \n]+its[ \n]+domain:[ \n]+PASS")

# The tests of a user's own kernels: CTest, its measurements and JUnit.
set(kernel_check ${work}/kernel_check)
run(${CMAKE_COMMAND} -S ${source}/kernel_check -B ${kernel_check} -D nipref_ROOT=${moved})
run(${CMAKE_COMMAND} --build ${kernel_check})
# CTest will pass the whole path.
run(${moved}/bin/nipref grade kernel_check/libmylib.so --symbol sign_kernel --quantity I2 --points 500
  --baseline ${kernel_check}/baseline.toml --update-baseline)
run(${CMAKE_CTEST_COMMAND} --test-dir ${kernel_check} --verbose --output-junit junit.xml)
expect("I2 largest error found, ulp")
expect("100% tests passed, 0 tests failed out of 4")
foreach(file_and_says "sound.xml|failures=\"0\"" "wrong.xml|<failure message=\"largest error found" "junit.xml|tests=\"4\"")
  string(REPLACE "|" ";" file_and_says "${file_and_says}")
  list(POP_FRONT file_and_says file)
  file(READ ${kernel_check}/${file} output)
  expect("${file_and_says}")
endforeach()

# The commands of the workflow that users may copy, except those that install a compiler.
file(STRINGS ${source}/kernel_check/github.yml commands REGEX "- run: (gcc|nipref)")
list(TRANSFORM commands REPLACE ".*- run: " "")
list(JOIN commands " && " commands)
run(${CMAKE_COMMAND} -E env --modify PATH=path_list_prepend:${moved}/bin
  sh -c "cp ${source}/kernel_check/mylib.c . && ${commands}" )
expect("sign_kernel of[ \n]+[^ \n]*mylib.so[ \n]+as[ \n]+I2,[ \n]+its[ \n]+domain:[ \n]+PASS")

# Examples of everything. The package tells them the folder of the data.
run(${CMAKE_COMMAND} -S ${source} -B ${work}/examples -D nipref_ROOT=${moved})
run(${CMAKE_COMMAND} --build ${work}/examples)
run(${CMAKE_CTEST_COMMAND} --test-dir ${work}/examples --verbose)
expect("I1\\(0.73\\) = 0\\.2069902446408192670")
expect("The moved table")
expect("L: replayed 0.0579, corrected 0.0[1-9]+ ")
expect("promise of [0-9.]+ missed")

# fast alone, without the packages that the other rooms need.
set(without)
foreach(package Boost Eigen3 fmt GSL nlohmann_json)
  list(APPEND without -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
set(alone ${work}/fast_alone)
run(${CMAKE_COMMAND} -S ${source}/fast_alone -B ${alone} -D nipref_ROOT=${moved} ${without})
file(STRINGS ${alone}/CMakeCache.txt output)
expect_not("NIPREF_(gmp|mpfr|mpc|mpfi)_")
run(${CMAKE_COMMAND} --build ${alone})
set(programs fast_alone)
if(shared)
  list(APPEND programs from_cpp from_c)
endif()
foreach(program IN LISTS programs)
  run(${alone}/${program})
  expect("I1\\(0.73\\) = 0\\.20699024464081[0-9]+\nalpha = 0: ")
  run(readelf --dynamic ${alone}/${program})
  expect_not("\\[lib(fmt|gsl|gmp|mpfr|mpc|mpfi|boost)[^]]*")
endforeach()

# Everything from C and Fortran, by one shared library that exports only its C functions.
if(shared)
  set(c_interface ${work}/c_interface)
  run(${CMAKE_COMMAND} -S ${source}/c_interface -B ${c_interface} -D nipref_ROOT=${moved} ${without})
  run(${CMAKE_COMMAND} --build ${c_interface})
  run(${c_interface}/from_c)
  expect("un = [0-9.]+ in double\nun = [0-9.]+ \\+- [0-9.e-]+, proven\nun\\(2\\) = [0-9.e+-]+\n.*poisson = 2.*wn: .*Un = 0.0348008[0-9]+ of 1\n.*texts_size = 10.*3 places, 3 pressures, the last is 0, L = 0.1917[0-9]+, its error is small: 1\nscene: wanted")
  if(EXISTS ${c_interface}/from_fortran)
    run(${c_interface}/from_fortran)
    expect("I1\\(0.73\\) = 0\\.20699024464081")
  endif()
  file(GLOB_RECURSE library ${moved}/libnipref.so)
  run(nm --dynamic --defined-only ${library})
  expect(" nipref_ref")
  expect_not("\n[0-9a-f]* [A-Za-z] _Z[^\n]*")
endif()

# The files that the compiler reads if it reads all headers of these rooms.
function(headers_read rooms)
  set(text)
  foreach(room IN LISTS rooms)
    file(GLOB_RECURSE headers RELATIVE ${moved}/include ${moved}/include/nipref/${room}/*)
    foreach(header IN LISTS headers)
      string(APPEND text "#include <${header}>\n")
    endforeach()
  endforeach()
  file(WRITE ${work}/headers.cpp "${text}int main() {}\n")
  run(${compiler} -std=c++20 -I ${moved}/include -H -M -MF ${work}/headers.d ${work}/headers.cpp)
  string(REPLACE "${moved}/include" "" output "${output}")
  expect("/nipref/fast/sheet/kernels.hpp")
  expect_not("[^\n]*/nipref/[^\n]*/(internal|arithmetic|generator|cli)/[^\n]*")
  expect_not("[^\n]*/(CLI|eigen3|Eigen|fmt|gsl|nlohmann|toml\\+\\+)/[^\n]*")
  set(output "${output}" PARENT_SCOPE)
endfunction()
headers_read("data;fast")
expect_not("[^\n]*/(boost/|(gmp|mp[cf][a-z]*)\\.h)")
headers_read("data;fast;ref;verify")

# The shared library exports only its public interface, and needs only the C++ library.
if(shared)
  file(GLOB_RECURSE library ${moved}/libnipref_fast.so)
  run(readelf --dynamic ${library})
  expect("SONAME[^\n]*\\[libnipref_fast\\.so\\.[0-9]+\\.[0-9]+\\]")
  run(nm --dynamic --defined-only --demangle ${library})
  expect(" nipref::fast::I1\\(double, ")
  expect("typeinfo for nipref::data::BadInput")
  expect(" nipref_fast_I1")
  expect_not("\n[0-9a-f]* [A-Za-z] (nipref::[a-z]+::internal|fmt|Eigen|boost|std|toml)::[^\n]*")
  expect_not("nipref::data::SceneTable")  # it is in an internal folder
  find_program(python NAMES python3)
  if(python AND NOT sanitize)
    run(${python} ${source}/fast_alone/from_python.py ${library})
    expect("I1\\(0.73\\) = 0\\.20699024464081[0-9]+\n.*poisson = -1")
  endif()
endif()

# pkg-config finds the package in its new place.
find_program(pkg_config NAMES pkg-config)
if(pkg_config AND NOT sanitize)
  file(GLOB_RECURSE pc ${moved}/nipref-fast.pc)
  cmake_path(GET pc PARENT_PATH folder)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  cmake_path(GET folder PARENT_PATH libraries)
  run(${pkg_config} --libs nipref-fast)
  expect_not("-l(gmp|mpfr|mpc|mpfi)")
  run(${pkg_config} --cflags --libs nipref)
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${compiler} ${source}/fast_alone/main.cpp -o ${work}/by_pkg_config ${flags} -Wl,-rpath,${libraries})
  run(${work}/by_pkg_config)
  expect("I1\\(0.73\\) = 0\\.20699024464081[0-9]+\n")
endif()

# Uninstalling leaves the files that others have put there.
file(RENAME ${moved} ${prefix})
file(WRITE ${prefix}/include/another.h "")
run(${CMAKE_COMMAND} -D build=${work} -P ${source}/../../.cmake/uninstall.cmake)
file(GLOB_RECURSE left RELATIVE ${prefix} LIST_DIRECTORIES false ${prefix}/*)
if(NOT left STREQUAL "include/another.h" OR EXISTS ${prefix}/include/nipref)
  message(FATAL_ERROR "uninstalling has left: ${left}")
endif()
