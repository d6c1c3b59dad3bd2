#include "gas_solver/io/snapshots.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "coupling/base/error.h"
#include "gas_solver/io/disk.h"
#include "gas_solver/io/parallel_file.h"

namespace gasgrain {
namespace {

std::string group_name(std::size_t number) {
  return fmt::format("{:06d}", number);
}

std::string data_item(const Int3& cells, int components, const std::string& path) {
  return fmt::format(
      "          <DataItem Dimensions=\"{} {} {}{}\" NumberType=\"Float\" Precision=\"8\" "
      "Format=\"HDF\">gas.h5:/{}</DataItem>\n",
      cells[2], cells[1], cells[0], components == 1 ? "" : fmt::format(" {}", components), path);
}

std::string attribute(const Int3& cells, int components, const std::string& group,
                      const std::string& name) {
  return fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Cell\">\n", name,
                     components == 1 ? "Scalar" : "Vector") +
         data_item(cells, components, group + "/" + name) + "        </Attribute>\n";
}

// ParaView orders the axes of a regular grid z, y, x.
std::string geometry(const BoxGrid& grid) {
  const Vec3 h = grid.spacing();
  return fmt::format(
      "        <Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"{} {} {}\"/>\n"
      "        <Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n"
      "          <DataItem Dimensions=\"3\" Format=\"XML\">{} {} {}</DataItem>\n"
      "          <DataItem Dimensions=\"3\" Format=\"XML\">{} {} {}</DataItem>\n"
      "        </Geometry>\n",
      grid.cells[2] + 1, grid.cells[1] + 1, grid.cells[0] + 1, grid.lo[2], grid.lo[1], grid.lo[0],
      h[2], h[1], h[0]);
}

// What a group has of the fields that a run may write.
std::vector<std::string> scalars_of(const ParallelFile& file, const std::string& group) {
  std::vector<std::string> names;
  for (const char* name :
       {"void_fraction", "pressure", "density", "viscosity", "turbulence_k", "turbulence_epsilon"})
    if (file.has(fmt::format("{}/{}", group, name))) names.emplace_back(name);
  return names;
}

}  // namespace

Snapshots::Snapshots(const std::string& folder, const Domain& domain, double restart_time)
    : folder_(folder), domain_(domain) {
  const std::string name = folder + "/gas.h5";
  const bool there =
      domain.comm().max(std::filesystem::exists(name) ? 1.0 : 0.0) > 0 && restart_time >= 0;
  file_ = std::make_unique<ParallelFile>(
      name, there ? ParallelFile::Mode::append : ParallelFile::Mode::create, domain.comm());
  const Int3& cells = domain.grid().cells;
  const std::vector<double> shape{1.0 * cells[0], 1.0 * cells[1], 1.0 * cells[2]};
  if (!there) {
    file_->write_numbers("/", "cells", shape);
    return;
  }
  if (!file_->has_numbers("/", "cells") || file_->read_numbers("/", "cells") != shape)
    fail(
        "{} holds snapshots of another grid than {} x {} x {} cells: give the run a folder of its "
        "own, or move the file away.",
        name, cells[0], cells[1], cells[2]);
  for (const std::string& group : file_->groups()) {
    // One without a time was not finished.
    const bool whole = file_->has_numbers(group, "time");
    const double time = whole ? file_->read_numbers(group, "time").at(0) : restart_time;
    if (!whole || time > restart_time)
      file_->remove(group);
    else
      snapshots_.push_back({time, scalars_of(*file_, group)});
  }
}

Snapshots::~Snapshots() = default;

bool Snapshots::end_at(double time) const {
  return !snapshots_.empty() && snapshots_.back().time == time;
}

void Snapshots::write(const GasSolver& gas) {
  const std::string group = group_name(snapshots_.size());
  const IndexBox own = domain_.own();
  const FilePart scalar{domain_.grid().cells, own, 1};
  const auto write_scalar = [&](const std::string& name, const Array3<double>& field) {
    file_->write(group + "/" + name, scalar, {field.begin(), field.end()});
  };
  file_->make_group(group);
  write_scalar("void_fraction", gas.void_fraction());
  write_scalar("pressure", gas.pressure());
  std::vector<std::string> scalars{"void_fraction", "pressure"};
  for (const auto& [name, field] : gas.further_fields()) {
    Array3<double> inside(own);
    for_each_cell(own, [&, &of = *field](int i, int j, int k) { inside(i, j, k) = of(i, j, k); });
    write_scalar(name, inside);
    scalars.push_back(name);
  }
  const CellVector velocity = gas.cell_velocity();
  std::vector<double> vectors;
  vectors.reserve(3 * own.size());
  for (std::size_t n = 0; n < own.size(); ++n)
    for (int d = 0; d < 3; ++d) vectors.push_back(velocity[d][n]);
  file_->write(group + "/velocity", {domain_.grid().cells, own, 3}, vectors);
  file_->write_numbers(group, "time", {gas.time()});
  file_->flush();
  snapshots_.push_back({gas.time(), scalars});
  if (domain_.comm().is_root()) write_xdmf();
}

void Snapshots::write_xdmf() const {
  const Int3& cells = domain_.grid().cells;
  const std::string name = folder_ + "/gas.xdmf";
  {
    std::ofstream out(name + ".new");
    out << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
           "    <Grid Name=\"gas\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
    for (std::size_t n = 0; n < snapshots_.size(); ++n) {
      out << fmt::format("      <Grid Name=\"{}\">\n        <Time Value=\"{:.12g}\"/>\n",
                         group_name(n), snapshots_[n].time)
          << geometry(domain_.grid());
      for (const std::string& scalar : snapshots_[n].scalars)
        out << attribute(cells, 1, group_name(n), scalar);
      out << attribute(cells, 3, group_name(n), "velocity") << "      </Grid>\n";
    }
    out << "    </Grid>\n  </Domain>\n</Xdmf>\n";
    if (!out.flush()) fail("{}: cannot be written: {}.", name, why_not_written(name));
  }
  std::filesystem::rename(name + ".new", name);
}

}  // namespace gasgrain
