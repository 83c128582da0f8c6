#pragma once

#include <boost/mpi/communicator.hpp>

namespace tagmint::cluster {

/// The life of a rank that does not lead: works on the leader's tasks until it says that the
/// program ends.
///   threads   of this rank, where the leader leaves it to the rank
///   returns   the exit code of the program
int serve(const boost::mpi::communicator& ranks, int threads);

}  // namespace tagmint::cluster
