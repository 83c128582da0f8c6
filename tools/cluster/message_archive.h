#pragma once

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include "cluster/messages.h"

/// How Boost packs the messages.
namespace boost::serialization {

template <typename Archive>
void serialize(Archive& archive, tagmint::cluster::Chunk& chunk, unsigned /*version*/) {
  archive& chunk.first& chunk.count;
}

template <typename Archive>
void serialize(Archive& archive, tagmint::cluster::Task& task, unsigned /*version*/) {
  archive& task.kind& task.rules& task.number& task.chunk& task.new_codes;
}

template <typename Archive>
void serialize(Archive& archive, tagmint::codec::KeptWord& kept, unsigned /*version*/) {
  archive& kept.index& kept.word;
}

template <typename Archive>
void serialize(Archive& archive, tagmint::codec::SiftedWords& sifted, unsigned /*version*/) {
  archive& sifted.kept& sifted.distant;
}

template <typename Archive>
void serialize(Archive& archive, tagmint::cluster::Answer& answer, unsigned /*version*/) {
  archive& answer.chunk& answer.seconds& answer.sifted& answer.open;
}

}  // namespace boost::serialization
