# Decides whether `mpirun tagmint generate` searches with many processes (docs/cluster.md); sets
# tagmint_mpi to TRUE or FALSE.
set(TAGMINT_WITH_MPI AUTO CACHE STRING
    "Searches over many processes: ON, OFF, or AUTO = where MPI and Boost.MPI are installed")
set_property(CACHE TAGMINT_WITH_MPI PROPERTY STRINGS AUTO ON OFF)

set(tagmint_mpi FALSE)
if(TAGMINT_WITH_MPI STREQUAL AUTO AND TAGMINT_SANITIZE)
  message(STATUS "Many processes: off, MPI's own leaks would be reported by the sanitizers")
elseif(TAGMINT_WITH_MPI)
  set(MPI_CXX_SKIP_MPICXX TRUE)  # the C interface will do
  find_package(MPI QUIET COMPONENTS CXX)
  find_package(Boost 1.74 QUIET COMPONENTS mpi serialization)
  if(MPI_CXX_FOUND AND Boost_FOUND)
    set(tagmint_mpi TRUE)
    message(STATUS "Many processes: on, MPI ${MPI_CXX_VERSION} and Boost.MPI ${Boost_VERSION}")
  elseif(TAGMINT_WITH_MPI STREQUAL AUTO)
    message(STATUS "Many processes: off, MPI or Boost.MPI is missing (libboost-mpi-dev)")
  else()
    message(FATAL_ERROR "TAGMINT_WITH_MPI is ON, but MPI or Boost.MPI is missing; install "
                        "libboost-mpi-dev and openmpi-bin")
  endif()
endif()
