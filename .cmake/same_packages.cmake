# Run by cpack after everything is installed in the folder of which packages are made.
if(NOT CPACK_NIPREF_PREFIX STREQUAL "/usr")
  message(FATAL_ERROR "packages are made of a build with -D CMAKE_INSTALL_PREFIX=/usr")
endif()

# Removes what would differ between two packages of one commit: times, and the effect of the user's umask.
execute_process(COMMAND git -C ${CMAKE_CURRENT_LIST_DIR} log -1 --format=%ct OUTPUT_VARIABLE commit_time
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(commit_time AND NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  set(ENV{SOURCE_DATE_EPOCH} ${commit_time})
endif()
file(CHMOD_RECURSE ${CPACK_TEMPORARY_DIRECTORY} DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
