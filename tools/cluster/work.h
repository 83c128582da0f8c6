#pragma once

#include "cluster/messages.h"
#include "cluster/round_division.h"
#include "tagmint/codec/search/crew.h"

namespace tagmint::cluster {

/// One chunk of a round, done by `crew`. kind: Sift or ListOpen.
Answer work_on(Task::Kind kind, const Chunk& chunk, codec::SearchCrew& crew);

}  // namespace tagmint::cluster
