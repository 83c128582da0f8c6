# Installs the libraries, their headers, the family files, a CMake package (find_package(tagmint)) and
# pkg-config files, in three components: runtime (libtagmint.so), development, and tools (the program).
include(CMakePackageConfigHelpers)

set(tagmint_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tagmint)
install(TARGETS tagmint_codec tagmint_detect tagmint_c tagmint_whole EXPORT tagmintTargets
  LIBRARY COMPONENT runtime NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development
  FILE_SET HEADERS COMPONENT development)
install(EXPORT tagmintTargets NAMESPACE tagmint:: DESTINATION ${tagmint_cmake_dir}
        COMPONENT development)
configure_package_config_file(cmake/tagmintConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tagmintConfig.cmake INSTALL_DESTINATION ${tagmint_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tagmintConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tagmintConfig.cmake
              ${PROJECT_BINARY_DIR}/tagmintConfigVersion.cmake
        DESTINATION ${tagmint_cmake_dir} COMPONENT development)

# tagmint_install_pkg_config(<name> LIBS <library>... REQUIRES <package>...)
# <name>.pc, which finds its folders from its own place.
function(tagmint_install_pkg_config name)
  cmake_parse_arguments(ARG "" "" "LIBS;REQUIRES" ${ARGN})
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" PC_PREFIX "\${pcfiledir}/${up}")
  list(TRANSFORM ARG_LIBS PREPEND -l)
  list(JOIN ARG_LIBS " " PC_LIBS)
  list(JOIN ARG_REQUIRES ", " PC_REQUIRES)
  set(PC_NAME ${name})
  configure_file(cmake/tagmint.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endfunction()
set(static_libraries LIBS tagmint_c tagmint_detect tagmint_codec stdc++ m
                     REQUIRES fmt libhwy libcrypto tbb)
tagmint_install_pkg_config(tagmint-static ${static_libraries})
if(TAGMINT_SHARED)
  tagmint_install_pkg_config(tagmint LIBS tagmint)
else()
  tagmint_install_pkg_config(tagmint ${static_libraries})
endif()

if(TAGMINT_BUILD_TOOLS)
  install(TARGETS tagmint COMPONENT tools)
  install(DIRECTORY ${TAGMINT_MANUAL_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          COMPONENT tools)
  install(FILES ${TAGMINT_MANUAL_DIR}/tagmint.bash RENAME tagmint COMPONENT tools
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  # Debian's zsh looks into the first in /usr/local, into the second in /usr.
  foreach(folder IN ITEMS site-functions vendor-completions)
    install(FILES ${TAGMINT_MANUAL_DIR}/_tagmint COMPONENT tools
            DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${folder})
  endforeach()
  install(FILES ${TAGMINT_MANUAL_DIR}/tagmint.fish COMPONENT tools
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  install(DIRECTORY families/ DESTINATION ${CMAKE_INSTALL_DATADIR}/tagmint/families
          COMPONENT tools FILES_MATCHING PATTERN "*.json" PATTERN extract EXCLUDE)
endif()
