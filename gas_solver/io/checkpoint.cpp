#include "gas_solver/io/checkpoint.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "coupling/base/error.h"
#include "gas_solver/io/disk.h"
#include "gas_solver/io/parallel_file.h"

namespace gasgrain {
namespace {

constexpr double format_version = 2;

std::vector<double> numbers_of(const BoxGrid& grid) {
  std::vector<double> numbers;
  for (int d = 0; d < 3; ++d) {
    numbers.push_back(grid.lo[d]);
    numbers.push_back(grid.hi[d]);
    numbers.push_back(grid.cells[d]);
    numbers.push_back(grid.periodic[d] ? 1 : 0);
  }
  return numbers;
}

std::string text_of(const std::vector<double>& n) {
  std::string periodic;
  for (std::size_t d = 0; d < 3; ++d)
    if (n[4 * d + 3] != 0) periodic += fmt::format(", periodic along {}", "xyz"[d]);
  return fmt::format("{} x {} x {} cells from ({}, {}, {}) to ({}, {}, {}) m{}", n[2], n[6], n[10],
                     n[0], n[4], n[8], n[1], n[5], n[9], periodic);
}

std::string beside(const std::string& file) {
  return file + ".new";
}

}  // namespace

CheckpointFile::CheckpointFile(const std::string& file, const Domain& domain)
    : name_(file), domain_(domain) {}

CheckpointFile::~CheckpointFile() = default;

Int3 CheckpointFile::whole(int component) const {
  Int3 extents = domain_.grid().cells;
  if (component >= 0 && !domain_.grid().periodic[component]) ++extents[component];
  return extents;
}

IndexBox CheckpointFile::share(int component) const {
  return component < 0 ? domain_.own() : domain_.faces(component);
}

CheckpointWriter::CheckpointWriter(const std::string& file, const Domain& domain)
    : CheckpointFile(file, domain) {
  file_ = std::make_unique<ParallelFile>(beside(file), ParallelFile::Mode::create, domain.comm());
  file_->write_numbers("/", "gas_checkpoint_version", {format_version});
  file_->write_numbers("/", "grid", numbers_of(domain.grid()));
}

void CheckpointWriter::choices(const CheckpointChoices& made) {
  for (const auto& [name, value] : made) file_->write_numbers("/", name, {value});
}

void CheckpointWriter::number(const std::string& name, double value) {
  file_->write_numbers("/", name, {value});
}

void CheckpointWriter::field(const std::string& name, int component, const Array3<double>& values) {
  std::vector<double> part;
  const IndexBox box = share(component);
  part.reserve(box.size());
  for_each_cell(box, [&](int i, int j, int k) { part.push_back(values(i, j, k)); });
  file_->write(name, {whole(component), box, 1}, part);
}

void CheckpointWriter::finish() {
  file_->close();
  file_.reset();
  // A rank that could not write its share does not come here.
  MPI_Barrier(domain_.comm().handle());
  long failed = 0;
  if (domain_.comm().is_root()) failed = put_in_place(beside(name_), name_);
  failed = domain_.comm().sum(failed);
  if (failed != 0) {
    if (domain_.comm().is_root()) std::remove(beside(name_).c_str());
    fail("{}: cannot be written: {}.", name_, std::strerror(static_cast<int>(failed)));
  }
}

CheckpointWriter::~CheckpointWriter() {
  // Half a checkpoint is of no use to anyone and takes room that is wanted.
  if (file_ && domain_.comm().is_root()) std::remove(beside(name_).c_str());
}

CheckpointReader::CheckpointReader(const std::string& file, const Domain& domain)
    : CheckpointFile(file, domain) {
  // MPI would try to read the folder, and tell of each of its many failures.
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown))
    fail("{} is a folder: name the checkpoint in it, such as {}.", file,
         (std::filesystem::path(file) / "gas.checkpoint.h5").string());
  file_ = std::make_unique<ParallelFile>(file, ParallelFile::Mode::read, domain.comm());
  if (!file_->has_numbers("/", "gas_checkpoint_version"))
    fail("{} is an HDF5 file, but no gas checkpoint.", file);
  const double version = file_->read_numbers("/", "gas_checkpoint_version").at(0);
  if (version != format_version)
    fail(
        "{} is a gas checkpoint of version {}, this program reads version {}: write it anew with "
        "this program.",
        file, version, format_version);
  const std::vector<double> written = file_->read_numbers("/", "grid");
  if (written != numbers_of(domain.grid()))
    fail(
        "{} was written for a grid of {}, this run's is {}: restart with the grid it was written "
        "for.",
        file, text_of(written), text_of(numbers_of(domain.grid())));
}

void CheckpointReader::require_choices(const CheckpointChoices& made) {
  std::string others;
  for (const auto& [name, value] : made)
    if (!file_->has_numbers("/", name) || file_->read_numbers("/", name).at(0) != value)
      others += (others.empty() ? "" : ", ") + name;
  if (!others.empty())
    fail(
        "{} was written with another choice of {} than this run's: restart with the one it was "
        "written with.",
        name_, others);
}

void CheckpointReader::number(const std::string& name, double& value) {
  value = file_->read_numbers("/", name).at(0);
}

void CheckpointReader::flag(const std::string& name, bool& value) {
  double number_read = 0;
  number(name, number_read);
  value = number_read != 0;
}

void CheckpointReader::field(const std::string& name, int component, Array3<double>& values) {
  if (!file_->has(name))
    fail(
        "{} has no field {}: it was written without the [[mass_source]] of this run, or by another "
        "program. Restart with the input it was written with.",
        name_, name);
  std::vector<double> part;
  const IndexBox box = share(component);
  file_->read(name, {whole(component), box, 1}, part);
  const double* value = part.data();
  for_each_cell(box, [&](int i, int j, int k) { values(i, j, k) = *value++; });
}

}  // namespace gasgrain
