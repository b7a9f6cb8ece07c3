# Debian packages, made by `cpack` in the folder of a build for /usr. Packages of one commit that are built in the same
# folders are identical.
#   nipref         the program, its data, manual, completion, kernel.h
#   libnipref-dev  libraries, headers, files for find_package and pkg-config
#   python3-nipref the package for Python
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "nipref <nipref@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_NIPREF_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/.cmake/same_packages.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(of_this_version "(= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME nipref)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${PROJECT_DESCRIPTION}: the program")

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libnipref-dev)
set(CPACK_DEBIAN_LIBRARIES_DESCRIPTION "${PROJECT_DESCRIPTION}: libraries for C++, C and what calls it")
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_DEPENDS "nipref ${of_this_version}, libgmp-dev, libmpfr-dev, libmpc-dev, libmpfi-dev, \
libboost1.81-dev | libboost-dev (>= 1.81), libgsl-dev, libfmt-dev, libssl-dev")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-nipref)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}: for Python")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy, nipref ${of_this_version}, libnipref-dev ${of_this_version}")

include(CPack)
foreach(component command-line host tables)
  cpack_add_component(${component} GROUP program)
endforeach()
foreach(component data ref fast fast-shared verify c)
  cpack_add_component(${component} GROUP libraries)
endforeach()
cpack_add_component(python GROUP python)
