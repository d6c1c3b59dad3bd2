#include "fix_cfd_coupling/liggghts/mpi_redirect.h"

#include <cstdio>
#include <cstdlib>

#include "fix_cfd_coupling/fixes/host_error.h"

namespace {

MPI_Comm world_stand_in = MPI_COMM_NULL;
bool normal_end = false;

MPI_Comm stand_in(MPI_Comm comm) {
  return comm == MPI_COMM_WORLD && world_stand_in != MPI_COMM_NULL ? world_stand_in : comm;
}

}  // namespace

namespace gasgrain {

void redirect_world_to(MPI_Comm local) {
  world_stand_in = local;
}

void end_normally() {
  normal_end = true;
  PMPI_Finalize();
}

void abort_launch() {
  std::fflush(nullptr);
  PMPI_Abort(MPI_COMM_WORLD, 1);
  std::_Exit(1);
}

}  // namespace gasgrain

extern "C" {

int MPI_Finalize() {
  if (normal_end) return PMPI_Finalize();
  gasgrain::abort_launch();
}

int MPI_Comm_dup(MPI_Comm comm, MPI_Comm* copy) {
  return PMPI_Comm_dup(stand_in(comm), copy);
}
int MPI_Comm_size(MPI_Comm comm, int* size) {
  return PMPI_Comm_size(stand_in(comm), size);
}
int MPI_Comm_rank(MPI_Comm comm, int* rank) {
  return PMPI_Comm_rank(stand_in(comm), rank);
}
int MPI_Comm_group(MPI_Comm comm, MPI_Group* group) {
  return PMPI_Comm_group(stand_in(comm), group);
}
int MPI_Comm_create(MPI_Comm comm, MPI_Group group, MPI_Comm* created) {
  return PMPI_Comm_create(stand_in(comm), group, created);
}
int MPI_Comm_split(MPI_Comm comm, int color, int key, MPI_Comm* part) {
  return PMPI_Comm_split(stand_in(comm), color, key, part);
}
int MPI_Barrier(MPI_Comm comm) {
  return PMPI_Barrier(stand_in(comm));
}
int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  return PMPI_Bcast(data, count, type, root, stand_in(comm));
}
int MPI_Gather(const void* from, int from_count, MPI_Datatype from_type, void* to, int to_count,
               MPI_Datatype to_type, int root, MPI_Comm comm) {
  return PMPI_Gather(from, from_count, from_type, to, to_count, to_type, root, stand_in(comm));
}
int MPI_Allgather(const void* from, int from_count, MPI_Datatype from_type, void* to, int to_count,
                  MPI_Datatype to_type, MPI_Comm comm) {
  return PMPI_Allgather(from, from_count, from_type, to, to_count, to_type, stand_in(comm));
}
int MPI_Reduce(const void* from, void* to, int count, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm) {
  return PMPI_Reduce(from, to, count, type, op, root, stand_in(comm));
}
int MPI_Allreduce(const void* from, void* to, int count, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm) {
  return PMPI_Allreduce(from, to, count, type, op, stand_in(comm));
}

}  // extern "C"
