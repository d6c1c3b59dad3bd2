// What the styles of one host process share: the place in the launch and the wish to stop.
#pragma once

#include <mpi.h>

#include <csignal>
#include <string>

#include "coupling/base/communicator.h"

namespace gasgrain {

struct HostSession {
  Communicator local;                          // the DEM ranks
  MPI_Comm partner = MPI_COMM_NULL;            // to the gas ranks; null when the DEM runs alone
  bool greeted = false;                        // a fix couple/gas has met the partner
  volatile std::sig_atomic_t stop_wanted = 0;  // SIGUSR1 arrived: checkpoint and end
  std::string fault;                           // why the run is being stopped; empty: it is not
};

inline HostSession& session() {
  static HostSession the_session;
  return the_session;
}

// What goes wrong while a fault's autopsy is written must not hide the fault.
inline std::string with_fault(const std::string& message) {
  const std::string& fault = session().fault;
  if (fault.empty() || message.compare(0, fault.size(), fault) == 0) return message;
  return fault + "\nNo autopsy of it: " + message;
}

}  // namespace gasgrain
