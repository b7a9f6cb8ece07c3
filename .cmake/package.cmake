# The installed package besides its targets: the files for find_package and pkg-config, and the target that uninstalls.
include(CMakePackageConfigHelpers)
set(data_dir ${CMAKE_INSTALL_DATADIR}/nipref)
configure_package_config_file(.cmake/nipref-config.cmake.in ${PROJECT_BINARY_DIR}/nipref-config.cmake
  INSTALL_DESTINATION ${NIPREF_PACKAGE_DIR} PATH_VARS data_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/nipref-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES .cmake/nipref-kernel-check.cmake DESTINATION ${NIPREF_PACKAGE_DIR} COMPONENT command-line)
install(FILES .cmake/multiprecision.cmake ${PROJECT_BINARY_DIR}/nipref-config.cmake
  ${PROJECT_BINARY_DIR}/nipref-config-version.cmake DESTINATION ${NIPREF_PACKAGE_DIR} COMPONENT data)

file(RELATIVE_PATH prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix "${prefix}")
foreach(name nipref nipref-fast)
  configure_file(.cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/nipref-fast.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT fast)
install(FILES ${PROJECT_BINARY_DIR}/nipref.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT ref)

if(PROJECT_IS_TOP_LEVEL)
  include(.cmake/debian.cmake)
  add_custom_target(uninstall VERBATIM
    COMMAND ${CMAKE_COMMAND} -D build=${PROJECT_BINARY_DIR} -P ${PROJECT_SOURCE_DIR}/.cmake/uninstall.cmake)
endif()
