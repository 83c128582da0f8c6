// What the codewords of everybody's families say: true distances, false accepts, tags that look
// alike; the tables of docs/families.md.
//
//   families_table [FILE...]
//
// FILE: a family that cannot be made or read here otherwise, in any kind that `tagmint convert`
// reads. Tables as markdown go to stdout; make_tables.sh gets the files that docs/families.md uses.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "families_table/family_row.h"
#include "families_table/shipped_families.h"

namespace tagmint::bench {
namespace {

void run(const std::vector<std::string>& files) {
  const std::vector<Shipment> shipments = shipped_families(files);
  std::vector<FamilyRow> earlier;
  for (const Shipment& shipment : shipments) {
    std::vector<FamilyRow> rows;
    for (const ShippedFamily& shipped : shipment.families) {
      rows.push_back(family_row(shipped, earlier));
      earlier.push_back(rows.back());
    }
    fmt::print("### {}\n\n{}\n", shipment.title, as_markdown(rows));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace tagmint::bench

int main(int argc, char** argv) {
  try {
    tagmint::bench::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "families_table: {}\n", error.what());
    return 1;
  }
  return 0;
}
