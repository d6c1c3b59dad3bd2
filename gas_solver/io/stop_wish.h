// The wish to stop a run of the gas alone before its end: SIGUSR1, Ctrl-C (SIGINT) or SIGTERM. The
// run then ends its interval and writes its checkpoint; a second signal ends it at once. A coupled
// run never calls this: there the DEM program decides.
#pragma once

namespace gasgrain {

// `tells`: whether this rank says, at the signal, that the run is about to stop.
void catch_stop_wishes(bool tells);

// The signal that has arrived at this rank, 0: none. Ranks have to agree on it (mpirun passes
// signals on to all, but not at one time), by the greatest.
int stop_wish();

// 0 after SIGUSR1, as of a coupled run that was asked so; else what shells report after Ctrl-C, as
// of `gasgrain run`.
int status_after(int stop_wish);

}  // namespace gasgrain
