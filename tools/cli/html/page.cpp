#include "cli/html/page.h"

#include <fmt/format.h>

#include "cli/html/embedded_texts.h"
#include "cli/html/markup.h"
#include "tagmint/codec/version.h"

namespace tagmint::cli {

std::string page_head(std::string_view title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n",
      escaped(title), page_style);
}

std::string page_foot() {
  return fmt::format("</main>\n<footer>Made by tagmint {}.</footer>\n</body>\n</html>\n",
                     codec::kVersion);
}

}  // namespace tagmint::cli
