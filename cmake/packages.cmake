# `cpack -G DEB`: Debian packages libtagmint, libtagmint-dev and tagmint. What is installed without a
# component of ours goes into none of them.
set(CPACK_PACKAGE_NAME tagmint)
set(CPACK_PACKAGE_VENDOR "the tagmint authors")
set(CPACK_PACKAGE_CONTACT "the tagmint authors <tagmint@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL development)
if(TAGMINT_SHARED)
  list(APPEND CPACK_COMPONENTS_ALL runtime)
endif()
if(TAGMINT_BUILD_TOOLS)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

# The shared library's package carries its soname, so that two of them can be installed at a time.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libtagmint${TAGMINT_ABI})
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}: shared library")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtagmint-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(development_needs libfmt-dev libhwy-dev libssl-dev libtbb-dev)
if(TAGMINT_SHARED)
  list(PREPEND development_needs
    "${CPACK_DEBIAN_RUNTIME_PACKAGE_NAME} (= ${PROJECT_VERSION})")
endif()
list(JOIN development_needs ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "${PROJECT_DESCRIPTION}: headers, static libraries, CMake and pkg-config files")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME tagmint)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "${PROJECT_DESCRIPTION}: the program")
include(CPack)

# vcpkg wants the version in a file of its own.
configure_file(${PROJECT_SOURCE_DIR}/cmake/packaging/vcpkg/vcpkg.json.in
               ${PROJECT_BINARY_DIR}/vcpkg/tagmint/vcpkg.json @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/cmake/packaging/vcpkg/portfile.cmake
               ${PROJECT_BINARY_DIR}/vcpkg/tagmint/portfile.cmake COPYONLY)
