#pragma once

#include <optional>
#include <string>

#include "tagmint/codec/decoder.h"

namespace CLI {
class App;
}

namespace tagmint::cli {

/// The options that say which tags are recognised, and with how many errors, as they were given.
struct DecoderArguments {
  std::string ids;  ///< a list, like "0-9,12,20-"; empty = all
  std::optional<int> max_hamming;
  bool unsafe_radius = false;
};

/// Adds --ids, --max-hamming and --unsafe-radius.
void add_decoder_options(CLI::App& app, DecoderArguments& arguments);

/// A decoder for the ids and errors that were asked for. The safe radius is that of the ids in use:
/// a level of a family, or a few tags that are farther apart than the family, may be read with more
/// errors.
/// Throws UsageError for ids that the family lacks, and for errors beyond the safe radius that were
/// not asked for with --unsafe-radius.
codec::Decoder make_decoder(const codec::SharedFamily& family, const DecoderArguments& arguments);

}  // namespace tagmint::cli
