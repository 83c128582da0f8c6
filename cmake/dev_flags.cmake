# Compiler settings of our own targets: the language level, warnings, sanitizers.
# `-march` stays untouched; vector code chooses its instructions at run time.
add_library(tagmint_dev_flags INTERFACE)
target_compile_features(tagmint_dev_flags INTERFACE cxx_std_20)
target_compile_options(tagmint_dev_flags INTERFACE -Wall -Wextra)
if(TAGMINT_WARNINGS_AS_ERRORS)
  target_compile_options(tagmint_dev_flags INTERFACE -Werror)
endif()
if(TAGMINT_SANITIZE)
  target_compile_options(tagmint_dev_flags INTERFACE -fsanitize=${TAGMINT_SANITIZE}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(tagmint_dev_flags INTERFACE -fsanitize=${TAGMINT_SANITIZE})
endif()
