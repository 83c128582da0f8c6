#pragma once

#include <optional>

namespace tagmint::cluster {

/// What the launcher of a parallel job says about this process; it is known before MPI starts.
struct Launch {
  int rank = 0;
  int ranks = 0;  ///< 0 = the launcher did not say
};

/// Reads the environment: Open MPI's mpirun sets OMPI_COMM_WORLD_*, srun and others PMIX_RANK or
/// PMI_*. Slurm's own variables are no sign of MPI: a plain command of a job script has them too.
/// Nothing where the process was started alone.
std::optional<Launch> read_launch();

}  // namespace tagmint::cluster
