#pragma once

#include <tiffio.h>

#include <cstdarg>
#include <cstdio>
#include <memory>
#include <new>

namespace tagmint::io {

/// The first complaint of libtiff about one file; nothing is printed.
struct TiffMessages {
  char message[200] = {};

  /// Options that send libtiff's messages here; `this` must outlive what is opened with them.
  /// Throws std::bad_alloc.
  std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> open_options() {
    std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                             &TIFFOpenOptionsFree);
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), note_error, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, this);
    return options;
  }

 private:
  static int note_error(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto& self = *static_cast<TiffMessages*>(user);
    if (self.message[0] == '\0') {
      std::vsnprintf(self.message, sizeof(self.message), format, arguments);
    }
    return 1;  // handled
  }
  static int ignore_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }
};

}  // namespace tagmint::io
