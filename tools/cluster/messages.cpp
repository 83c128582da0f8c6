#include "cluster/messages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace tagmint::cluster {

std::string rules_text(const codec::SearchRules& rules) {
  return fmt::format("{}\n{}\n{}\n{}\n", fmt::join(rules.layout.rows(), "/"), rules.min_hamming,
                     codec::to_string(rules.order), codec::to_string(rules.complexity));
}

codec::SearchRules parse_rules(const std::string& text) {
  std::istringstream lines(text);
  std::string layout;
  int min_hamming = 0;
  std::string order;
  std::string complexity;
  lines >> layout >> min_hamming >> order >> complexity;
  return {codec::Layout(layout), min_hamming, codec::parse_order(order),
          codec::parse_complexity(complexity)};
}

}  // namespace tagmint::cluster
