// An HDF5 file that the ranks of a group write and read together: fields of the whole grid, of
// which each rank holds a box, in (z, y, x) order. Every call is collective; every failure is an
// Error.
//
// A failure may be met by some ranks only: the others may wait for them within HDF5, and the file
// cannot be used or closed any more. Whoever catches the Error has to end the program.
#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

// The part of a dataset that a rank holds: x runs fastest in `box`, components faster still.
struct FilePart {
  Int3 whole{0, 0, 0};  // extents of the dataset
  IndexBox box;
  int components = 1;
};

class ParallelFile {
 public:
  enum class Mode { create, read, append };
  ParallelFile(const std::string& name, Mode mode, const Communicator& comm);
  ~ParallelFile();
  ParallelFile(const ParallelFile&) = delete;
  ParallelFile& operator=(const ParallelFile&) = delete;

  // Everything is on the disk then. A destructor without it tells no failure.
  void close();

  void make_group(const std::string& group);
  void write(const std::string& dataset, const FilePart& part, const std::vector<double>& values);
  void read(const std::string& dataset, const FilePart& part, std::vector<double>& values);
  // Numbers that belong to the file ("/") or to a group.
  void write_numbers(const std::string& object, const std::string& name,
                     const std::vector<double>& values);
  [[nodiscard]] std::vector<double> read_numbers(const std::string& object,
                                                 const std::string& name) const;
  [[nodiscard]] bool has_numbers(const std::string& object, const std::string& name) const;
  [[nodiscard]] bool has(const std::string& dataset) const;
  [[nodiscard]] std::vector<std::string> groups() const;  // of the file's root, sorted
  void remove(const std::string& group);
  void flush();

 private:
  void require(bool success, const std::string& what) const;
  void require_written(bool success, const std::string& what);

  std::string name_;
  Communicator comm_;
  hid_t file_ = H5I_INVALID_HID;
  bool broken_ = false;  // by a failed write
};

}  // namespace gasgrain
