# How the static libraries are compiled, and the one library that holds them all.

# tagmint_hide_internals(<target>)
# Its objects may go into a shared library, which offers only what TAGMINT_API marks.
function(tagmint_hide_internals target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()

# tagmint_add_whole_library()
# tagmint::tagmint: codec, detect and the interface for C in one. Where TAGMINT_SHARED is on it is
# libtagmint.so, linked from the objects of the static libraries; else it stands for these.
#
# Below version 1 each minor version may change what programs were compiled against, so it is in the
# soname: libtagmint.so.0.1. Later it is the major version alone.
function(tagmint_add_whole_library)
  set(parts tagmint_codec tagmint_detect tagmint_c)
  if(NOT TAGMINT_SHARED)
    add_library(tagmint_whole INTERFACE)
    target_link_libraries(tagmint_whole INTERFACE tagmint::c tagmint::detect tagmint::codec)
  else()
    set(abi ${PROJECT_VERSION_MAJOR})
    if(abi EQUAL 0)
      string(APPEND abi .${PROJECT_VERSION_MINOR})
    endif()
    set(TAGMINT_ABI ${abi})
    set(TAGMINT_ABI ${abi} PARENT_SCOPE)
    set(exports ${PROJECT_BINARY_DIR}/exports.map)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/exports.map.in ${exports} @ONLY)
    add_library(tagmint_whole SHARED)
    foreach(part IN LISTS parts)
      target_sources(tagmint_whole PRIVATE $<TARGET_OBJECTS:${part}>)
      target_include_directories(tagmint_whole INTERFACE
        $<BUILD_INTERFACE:$<TARGET_PROPERTY:${part},INTERFACE_INCLUDE_DIRECTORIES>>)
    endforeach()
    target_include_directories(tagmint_whole INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_compile_features(tagmint_whole INTERFACE cxx_std_20)
    target_link_libraries(tagmint_whole
      PRIVATE fmt::fmt hwy::hwy OpenSSL::Crypto TBB::tbb Threads::Threads)
    target_link_options(tagmint_whole PRIVATE LINKER:--version-script=${exports}
      $<$<NOT:$<BOOL:${TAGMINT_SANITIZE}>>:LINKER:--no-undefined>)
    set_target_properties(tagmint_whole PROPERTIES OUTPUT_NAME tagmint LINKER_LANGUAGE CXX
      VERSION ${PROJECT_VERSION} SOVERSION ${abi} LINK_DEPENDS ${exports}
      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  endif()
  set_target_properties(tagmint_whole PROPERTIES EXPORT_NAME tagmint)
  add_library(tagmint::tagmint ALIAS tagmint_whole)
endfunction()
