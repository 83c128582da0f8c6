# embed_text(<target> NAMESPACE <namespace> <file> <symbol> [<file> <symbol>...])
# Compiles text files of the current source folder into <target>, each as
# `extern const std::string_view <symbol>`. The sources are made again when a file changes.
#
# Called as a script (cmake -DTEXT=... -DNAMESPACE=... -DSYMBOL=... -DSOURCE=... -P embed_text.cmake),
# it writes the source of one file.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${TEXT}" content)
  file(WRITE "${SOURCE}"
    "#include <string_view>\n\n"
    "namespace ${NAMESPACE} {\n"
    "extern const std::string_view ${SYMBOL};\n"
    "static const char text[] = R\"embedded(${content})embedded\";\n"
    "constinit const std::string_view ${SYMBOL}(text, sizeof text - 1);\n"
    "}  // namespace ${NAMESPACE}\n")
  return()
endif()

set(embed_text_script ${CMAKE_CURRENT_LIST_FILE})

function(embed_text target)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "NAMESPACE" "")
  set(rest ${ARG_UNPARSED_ARGUMENTS})
  while(rest)
    list(POP_FRONT rest file symbol)
    set(text ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_text/${symbol}.cpp)
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DTEXT=${text} -DNAMESPACE=${ARG_NAMESPACE} -DSYMBOL=${symbol}
              -DSOURCE=${source} -P ${embed_text_script}
      DEPENDS ${text} ${embed_text_script}
      COMMENT "Embedding ${file}" VERBATIM)
    target_sources(${target} PRIVATE ${source})
  endwhile()
endfunction()
