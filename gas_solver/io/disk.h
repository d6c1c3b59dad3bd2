// What a disk can go wrong with: room for what is to be written, the cause when it could not be,
// and the exchange of a whole file for the one before.
#pragma once

#include <string>

#include "coupling/base/communicator.h"

namespace gasgrain {

// Throws Error, on all ranks, when the disk of a file or the process' limit has not this much room
// [bytes]. To be asked before: HDF5 leaves a file broken when a write fails, and may leave ranks
// waiting for each other. Collective.
void require_room(const std::string& file, double bytes, const Communicator& comm);

// Why a write of a file failed, found by writing some bytes beside it; HDF5 does not tell.
std::string why_not_written(const std::string& file);
// Why a file cannot be opened as HDF5.
std::string why_not_opened(const std::string& file);

// Puts a file, whole and on the disk, in the place of another. The number of the failure (errno),
// 0: none.
int put_in_place(const std::string& written, const std::string& name);

}  // namespace gasgrain
