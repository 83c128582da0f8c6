# Port for vcpkg, an overlay: vcpkg install tagmint --overlay-ports=FOLDER, where FOLDER/tagmint holds
# this file and the vcpkg.json that CMake writes into the build folder. TAGMINT_SOURCES, in the
# environment, is a checkout.
set(SOURCE_PATH "$ENV{TAGMINT_SOURCES}")
if(NOT EXISTS "${SOURCE_PATH}/libcodec")
  message(FATAL_ERROR "TAGMINT_SOURCES is not a checkout of tagmint; set it to one, and keep it with "
                      "VCPKG_KEEP_ENV_VARS=TAGMINT_SOURCES")
endif()
string(COMPARE EQUAL "${VCPKG_LIBRARY_LINKAGE}" dynamic shared)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DTAGMINT_BUILD_TOOLS=OFF -DTAGMINT_BUILD_TESTS=OFF -DTAGMINT_SHARED=${shared})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/tagmint)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
