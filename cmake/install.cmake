# Installs the libraries, their headers, the family files and a CMake package (find_package(tagmint)).
include(CMakePackageConfigHelpers)

set(tagmint_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tagmint)
install(TARGETS tagmint_codec tagmint_detect tagmint_c EXPORT tagmintTargets FILE_SET HEADERS)
install(EXPORT tagmintTargets NAMESPACE tagmint:: DESTINATION ${tagmint_cmake_dir})
configure_package_config_file(cmake/tagmintConfig.cmake.in
  ${PROJECT_BINARY_DIR}/tagmintConfig.cmake INSTALL_DESTINATION ${tagmint_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tagmintConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tagmintConfig.cmake
              ${PROJECT_BINARY_DIR}/tagmintConfigVersion.cmake
        DESTINATION ${tagmint_cmake_dir})
install(DIRECTORY families/ DESTINATION ${CMAKE_INSTALL_DATADIR}/tagmint/families
        FILES_MATCHING PATTERN "*.json" PATTERN extract EXCLUDE)
if(TAGMINT_BUILD_TOOLS)
  install(TARGETS tagmint)
endif()
