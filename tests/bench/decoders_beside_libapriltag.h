#pragma once

/// Engines of the decoder beside the table of libapriltag, in one run.
namespace tagmint::bench {

/// Prints a table: tag36h11, tagStandard41h12 and tagStandard52h13, two errors corrected; processor
/// time to build, bytes, and nanoseconds for a word of a tag with two errors and for a random word.
/// The last family takes 6.4 GB of memory for the table that it is compared with.
void print_decoders_beside_libapriltag();

}  // namespace tagmint::bench
