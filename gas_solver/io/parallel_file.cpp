#include "gas_solver/io/parallel_file.h"

#include <exception>
#include <utility>

#include "coupling/base/error.h"
#include "gas_solver/io/disk.h"

namespace gasgrain {
namespace {

// HDF5's own, of a group of datasets: names, shapes, attributes.
constexpr double bytes_of_structure = 1 << 16;

// Closes an HDF5 identifier at the end of its scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

std::vector<hsize_t> zyx(const Int3& xyz, int components) {
  std::vector<hsize_t> extents;
  for (const int axis : {2, 1, 0}) extents.push_back(static_cast<hsize_t>(xyz[axis]));
  if (components > 1) extents.push_back(static_cast<hsize_t>(components));
  return extents;
}

// The selections of memory and file for a rank's part.
struct Selection {
  explicit Selection(const FilePart& part)
      : whole(zyx(part.whole, part.components)),
        extent(zyx({part.box.extent(0), part.box.extent(1), part.box.extent(2)}, part.components)),
        file(H5Screate_simple(static_cast<int>(whole.size()), whole.data(), nullptr), H5Sclose),
        memory(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose),
        transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose) {
    std::vector<hsize_t> start = zyx(part.box.lo, 1);
    start.resize(whole.size(), 0);
    H5Sselect_hyperslab(file, H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr);
    H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  }
  std::vector<hsize_t> whole;
  std::vector<hsize_t> extent;
  Handle file;
  Handle memory;
  Handle transfer;
};

}  // namespace

ParallelFile::ParallelFile(const std::string& name, Mode mode, const Communicator& comm)
    : name_(name), comm_(comm) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // we report failures ourselves
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_mpio(access, comm.handle(), MPI_INFO_NULL);
  if (mode == Mode::create)
    file_ = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  else
    file_ = H5Fopen(name.c_str(), mode == Mode::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, access);
  if (mode == Mode::create)
    require_written(file_ >= 0, "cannot be created");
  else if (file_ < 0)
    fail("{} cannot be opened: {}.", name, why_not_opened(name));
}

ParallelFile::~ParallelFile() {
  // Closing is collective: in an error that other ranks may not have met they would wait for ever.
  const bool nobody_waits = comm_.size() == 1 || std::uncaught_exceptions() == 0;
  // HDF5 does not get over a file that it could not write when it tries to close it.
  if (file_ >= 0 && nobody_waits && !broken_) H5Fclose(file_);
}

void ParallelFile::close() {
  flush();
  require_written(H5Fclose(std::exchange(file_, H5I_INVALID_HID)) >= 0, "cannot be closed");
}

void ParallelFile::require(bool success, const std::string& what) const {
  if (!success) fail("{}: {}.", name_, what);
}

void ParallelFile::require_written(bool success, const std::string& what) {
  if (success) return;
  broken_ = true;
  fail("{}: {}: {}.", name_, what, why_not_written(name_));
}

void ParallelFile::make_group(const std::string& group) {
  const Handle made(H5Gcreate2(file_, group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                    H5Gclose);
  require_written(made >= 0, "cannot make group " + group);
}

void ParallelFile::write(const std::string& dataset, const FilePart& part,
                         const std::vector<double>& values) {
  const Selection select(part);
  double bytes = sizeof(double);
  for (const hsize_t extent : select.whole) bytes *= static_cast<double>(extent);
  require_room(name_, bytes + bytes_of_structure, comm_);
  const Handle data(H5Dcreate2(file_, dataset.c_str(), H5T_IEEE_F64LE, select.file, H5P_DEFAULT,
                               H5P_DEFAULT, H5P_DEFAULT),
                    H5Dclose);
  require_written(data >= 0 && H5Dwrite(data, H5T_NATIVE_DOUBLE, select.memory, select.file,
                                        select.transfer, values.data()) >= 0,
                  "cannot write " + dataset);
}

void ParallelFile::read(const std::string& dataset, const FilePart& part,
                        std::vector<double>& values) {
  const Selection select(part);
  const Handle data(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  require(data >= 0, "lacks " + dataset);
  const Handle space(H5Dget_space(data), H5Sclose);
  std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  require(extents == select.whole, dataset + " has another shape than the grid");
  values.resize(part.box.size() * static_cast<std::size_t>(part.components));
  require(H5Dread(data, H5T_NATIVE_DOUBLE, select.memory, select.file, select.transfer,
                  values.data()) >= 0,
          "cannot read " + dataset);
}

void ParallelFile::write_numbers(const std::string& object, const std::string& name,
                                 const std::vector<double>& values) {
  const hsize_t count = values.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle attribute(H5Acreate_by_name(file_, object.c_str(), name.c_str(), H5T_IEEE_F64LE,
                                           space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  require_written(attribute >= 0 && H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data()) >= 0,
                  "cannot write " + name);
}

bool ParallelFile::has(const std::string& dataset) const {
  return H5Lexists(file_, dataset.c_str(), H5P_DEFAULT) > 0;
}

bool ParallelFile::has_numbers(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<double> ParallelFile::read_numbers(const std::string& object,
                                               const std::string& name) const {
  const Handle attribute(
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute >= 0, "lacks " + name);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  require(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()) >= 0, "cannot read " + name);
  return values;
}

std::vector<std::string> ParallelFile::groups() const {
  std::vector<std::string> names;
  const auto add = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  require(H5Literate(file_, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names) >= 0,
          "cannot be listed");
  return names;
}

void ParallelFile::remove(const std::string& group) {
  require_written(H5Ldelete(file_, group.c_str(), H5P_DEFAULT) >= 0, "cannot remove " + group);
}

void ParallelFile::flush() {
  require_written(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0, "cannot be flushed");
}

}  // namespace gasgrain
