# embed_families(<target> <name>...)
# Compiles families/<name>.json into <target> as raw string literals, one source a family, and
# writes the list of them in the order given (libcodec/src/embedded_families.h). The sources are
# made again when a family file changes. `constinit`: families can be asked for before main().
#
# Called as a script (cmake -DJSON=... -DSYMBOL=... -DSOURCE=... -P embed_families.cmake), it writes
# the source of one family.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ "${JSON}" content)
  file(WRITE "${SOURCE}"
    "#include <string_view>\n\n"
    "namespace tagmint::codec {\n"
    "extern const std::string_view ${SYMBOL};\n"
    "static const char text[] = R\"family(${content})family\";\n"
    "constinit const std::string_view ${SYMBOL}(text, sizeof text - 1);\n"
    "}  // namespace tagmint::codec\n")
  return()
endif()

set(embed_families_script ${CMAKE_CURRENT_LIST_FILE})

function(embed_families target)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded_families)
  set(declarations "")
  set(entries "")
  foreach(name IN LISTS ARGN)
    set(json ${PROJECT_SOURCE_DIR}/families/${name}.json)
    set(source ${folder}/${name}.cpp)
    set(symbol embedded_${name})
    add_custom_command(OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DJSON=${json} -DSYMBOL=${symbol} -DSOURCE=${source}
              -P ${embed_families_script}
      DEPENDS ${json} ${embed_families_script}
      COMMENT "Embedding ${name}.json" VERBATIM)
    target_sources(${target} PRIVATE ${source})
    string(APPEND declarations "extern const std::string_view ${symbol};\n")
    string(APPEND entries "      EmbeddedFamily{\"${name}\", ${symbol}},\n")
  endforeach()
  # The literals are constants in other files, so the list is made at the first call, not before.
  file(CONFIGURE OUTPUT ${folder}/index.cpp @ONLY CONTENT [[
#include <array>

#include "embedded_families.h"

namespace tagmint::codec {

@declarations@
std::span<const EmbeddedFamily> embedded_families() {
  static const std::array all = {
@entries@  };
  return all;
}

}  // namespace tagmint::codec
]])
  target_sources(${target} PRIVATE ${folder}/index.cpp)
endfunction()
