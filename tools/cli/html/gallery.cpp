#include "cli/html/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/html/embedded_texts.h"
#include "cli/html/markup.h"
#include "cli/html/tag_svg.h"

namespace tagmint::cli {
namespace {

/// What the script needs to draw and find tags. Codewords are one string of hex digits, each with
/// as many as the family's bits take.
std::string data_json(const FamilyReport& report, std::size_t listed) {
  const codec::Family& family = *report.family;
  const codec::Layout& layout = family.layout();
  const int digits = (family.bits() + 3) / 4;
  std::string words;
  words.reserve(listed * static_cast<std::size_t>(digits));
  for (const codec::Codeword word : codec::first_codewords(family, listed)) {
    fmt::format_to(std::back_inserter(words), "{:0{}x}", word, digits);
  }
  std::string cells;
  for (const std::string& row : layout.rows()) cells += row;
  nlohmann::ordered_json order = nlohmann::ordered_json::array();
  for (const codec::CellPosition& cell : layout.data_cells()) {
    order.push_back(cell.y * layout.width() + cell.x);
  }
  const nlohmann::ordered_json data = {{"name", family.name()},
                                       {"bits", family.bits()},
                                       {"size", family.size()},
                                       {"listed", listed},
                                       {"safe", report.safe_errors().value_or(0)},
                                       {"width", layout.width()},
                                       {"cells", cells},
                                       {"order", order},
                                       {"blank", blank_path(layout)},
                                       {"digits", digits},
                                       {"words", words}};
  return data.dump();
}

std::string first_tags_html(const codec::Family& family) {
  std::string html;
  const int digits = (family.bits() + 3) / 4;
  const std::size_t count = std::min(family.size(), kDrawnInGallery);
  for (codec::TagId id = 0; id < count; ++id) {
    html += fmt::format(
        "<figure id=\"tag-{0}\">{1}<figcaption>id {0}<br><code>0x{2:0{3}x}</code></figcaption>"
        "</figure>\n",
        id, tag_svg(family, id), family.codeword(id), digits);
  }
  return html;
}

}  // namespace

std::string gallery_html(const FamilyReport& report) {
  const codec::Family& family = *report.family;
  const std::size_t listed = std::min(family.size(), kMostInGallery);
  const std::size_t drawn = std::min(family.size(), kDrawnInGallery);
  const std::string rest =
      listed == family.size()
          ? ""
          : fmt::format(
                "<p>This family has {} tags; the page carries the first {}. <code>tagmint encode"
                "</code> shows any other.</p>\n",
                grouped(family.size()), grouped(listed));
  const std::string blank = blank_path(family.layout()).empty()
                                ? ""
                                : " Grey places are no part of the tag: nothing is printed there.";
  return fmt::format(
      R"(<section id="gallery">
<h2>Tags</h2>
{}<p>Each with its quiet zone, one cell of white.{}</p>
<form id="search" role="search" hidden>
<label for="query">Ids or a codeword:</label>
<input id="query" type="text" autocomplete="off" spellcheck="false" placeholder="0-9,12 or 0x{:x}">
<button type="submit">Find</button>
<button type="button" id="all">All</button>
</form>
<noscript><p>Search and the other tags need JavaScript, which does not run here.</p></noscript>
<p id="status" role="status">The first {} tags.</p>
<div id="grid" class="grid">
{}</div>
<div id="pager" class="pager" hidden>
<button type="button" id="back">Back</button><span id="place"></span><button type="button" id="forth">On</button>
</div>
<script type="application/json" id="family-data">{}</script>
<script>
{}</script>
</section>
)",
      rest, blank, family.codeword(0), drawn, first_tags_html(family), data_json(report, listed),
      gallery_script);
}

}  // namespace tagmint::cli
