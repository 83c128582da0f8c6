// docs/examples/families.cpp: makes families, proves what they declare, writes one and reads it
// again.
#include <iostream>
#include <stdexcept>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/family_check.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"

namespace codec = tagmint::codec;

void tell(const codec::Family& family) {
  std::cout << family.name() << ": " << family.size() << " tags of " << family.bits()
            << " bits, any two at least " << family.min_hamming() << " apart\n";
}

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "my.json";

  // The greedy search of the published families.
  const codec::LexicodeOptions search{.layout = codec::classic_layout(8),
                                      .min_hamming = 5,
                                      .order = codec::parse_order("seed:7"),
                                      .complexity = codec::parse_complexity("rectangles:5")};
  const codec::Family listed = codec::make_family(search, codec::search_lexicode(search), "mine");
  tell(listed);

  // Proven from the codewords alone.
  const codec::FamilyCheck check = codec::check_family(listed);
  if (check.violation) throw std::runtime_error(check.violation->message);

  codec::write_family(listed, path);  // whole or not at all
  const codec::SharedFamily again = codec::load_family(path);
  tell(*again);

  // The bundled ones have names.
  for (const char* name : {"tag36h11", "rot48"}) tell(*codec::find_family(name));
}
