#pragma once

#include <sched.h>

#include <span>

namespace tagmint::cluster {

/// How many of a machine's cores are one process's when each core is divided evenly among the
/// processes that may run on it; at least 1. Launchers bind processes to cores or leave them free,
/// and so a count of cores alone would not do.
///   own    the cores that this process may run on
///   all    the same for each process of the job on this machine, this one included
int share_of_cores(const cpu_set_t& own, std::span<const cpu_set_t> all);

}  // namespace tagmint::cluster
