#include "fix_cfd_coupling/lammps/fix_wall_gran_bridge.h"

#include <algorithm>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/grains_of_host.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

namespace LAMMPS_NS {

namespace contact = gasgrain::contact;

FixWallGranBridge::FixWallGranBridge(LAMMPS* host, int narg, char** arg) : Fix(host, narg, arg) {
  try {
    read(std::vector<std::string>(arg + 3, arg + narg));
  } catch (const gasgrain::Error& e) {
    gasgrain::stop_everything(fmt::format("fix {} wall/gran/bridge: {}", id, e.what()));
  }
  const int values = static_cast<int>(choice_.stack->history().size());
  width_ = values > 0 ? values + 1 : 0;
  vector_flag = 1;
  size_vector = 3;
  global_freq = 1;
  extvector = 1;
  create_attribute = 1;
  restart_peratom = width_ > 0 ? 1 : 0;
  maxexchange = width_;
  FixWallGranBridge::grow_arrays(atom->nmax);
  for (int k = 0; k < atom->nlocal; ++k) FixWallGranBridge::set_arrays(k);
  atom->add_callback(Atom::GROW);
  if (restart_peratom != 0) atom->add_callback(Atom::RESTART);
}

FixWallGranBridge::~FixWallGranBridge() {
  atom->delete_callback(id, Atom::GROW);
  if (restart_peratom != 0) atom->delete_callback(id, Atom::RESTART);
  memory->destroy(rows_);
}

void FixWallGranBridge::read(std::vector<std::string> words) {
  if (atom->sphere_flag == 0) gasgrain::fail("grains are spheres. Write 'atom_style sphere'.");
  read_shape(words);
  choice_ = contact::read_contact(words, true);
}

// Takes `primitive type T SHAPE ...` out of the words.
void FixWallGranBridge::read_shape(std::vector<std::string>& words) {
  const auto begin = std::find(words.begin(), words.end(), "primitive");
  if (begin == words.end())
    gasgrain::fail(
        "it needs a shape after the contact: 'primitive type T zplane C' or 'primitive "
        "type T zcylinder R X Y'. Walls of triangles are LIGGGHTS's alone.");
  const auto left = words.end() - begin;
  if (left < 5 || begin[1] != "type")
    gasgrain::fail("after 'primitive' it needs 'type T SHAPE', T the type of the wall's material.");
  type_ = utils::inumeric(FLERR, begin[2].c_str(), false, lmp);
  if (type_ < 1 || type_ > atom->ntypes)
    gasgrain::fail("primitive type {}: the scene has the types 1 to {}.", type_, atom->ntypes);
  const std::vector<std::string> shapes = {"xplane",    "yplane",    "zplane",
                                           "xcylinder", "ycylinder", "zcylinder"};
  const auto shape = std::find(shapes.begin(), shapes.end(), begin[3]);
  if (shape == shapes.end())
    gasgrain::fail("{} is no shape of a wall.{}", begin[3], gasgrain::suggestion(begin[3], shapes));
  const auto number = static_cast<int>(shape - shapes.begin());
  shape_.axis = number % 3;
  shape_.round = number > 2;
  const int numbers = shape_.round ? 3 : 1;
  if (left < 4 + numbers)
    gasgrain::fail("{} needs {}.", *shape,
                   shape_.round ? "a radius and the centre in the two other axes" : "its place");
  const auto value = [&](int n) { return utils::numeric(FLERR, begin[4 + n].c_str(), false, lmp); };
  if (shape_.round) {
    shape_.radius = value(0);
    if (!(shape_.radius > 0.0))
      gasgrain::fail("{}: the radius {} is not above 0.", *shape, begin[4]);
    shape_.centre = {value(1), value(2)};
  } else {
    shape_.place = value(0);
  }
  for (int d = 0; d < 3; ++d)
    if (domain->periodicity[d] != 0 && (d == shape_.axis) != shape_.round)
      gasgrain::fail("{} cannot stand in a box that is periodic in {}.", *shape, "xyz"[d]);
  words.erase(begin, begin + 4 + numbers);
}

int FixWallGranBridge::setmask() {
  return FixConst::POST_FORCE;
}

void FixWallGranBridge::init() {
  bodies_.find_fix(*lmp);
  if (domain->dimension != 3 || force->nktv2p != 1.0)
    gasgrain::stop_everything(
        fmt::format("fix {} wall/gran/bridge: its laws are of three dimensions and of 'units si', "
                    "cgs or lj.",
                    id));
  const gasgrain::ContactOwner owner{lmp,
                                     fmt::format("fix {} wall/gran/bridge", id),
                                     id,
                                     choice_.name.normal,
                                     &choice_.properties,
                                     &reach_,
                                     nullptr};
  hosts_.connect(owner, *choice_.stack, choice_.name);
}

void FixWallGranBridge::reach_at_least(double times) {
  reach_.times = std::max(reach_.times, times);
}

void FixWallGranBridge::setup(int vflag) {
  find_near_grains();
  post_force(vflag);
}

void FixWallGranBridge::find_near_grains() {
  near_.clear();
  for (int k = 0; k < atom->nlocal; ++k) {
    if ((atom->mask[k] & groupbit) == 0) continue;
    contact::Triple delta;
    const double distance = shape_.reach(atom->x[k], delta);
    const bool in_use = width_ > 0 && rows_[k][width_ - 1] != 0.0;
    if (in_use || distance < reach_.of(atom->radius[k]) + neighbor->skin) near_.push_back(k);
  }
}

void FixWallGranBridge::post_force(int) {
  if (neighbor->ago == 0) {
    find_near_grains();
    if (bodies_.exist()) bodies_.take(*lmp);
  }
  force_ = {};
  const contact::WallNeighbours near{static_cast<int>(near_.size()), near_.data(), rows_};
  choice_.stack->wall(gasgrain::grains_of(*lmp, 0, bodies_.data()), near, shape_, type_, this);
}

void FixWallGranBridge::acts(int, int, const contact::Triple& on_grain, const contact::Triple&) {
  force_ -= on_grain;
}

double FixWallGranBridge::compute_vector(int n) {
  double all = 0.0;
  MPI_Allreduce(force_.data() + n, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixWallGranBridge::memory_usage() {
  return static_cast<double>(atom->nmax) * width_ * sizeof(double) + near_.size() * sizeof(int);
}

void FixWallGranBridge::grow_arrays(int nmax) {
  if (width_ > 0) memory->grow(rows_, nmax, width_, "wall/gran/bridge:rows");
}

void FixWallGranBridge::copy_arrays(int i, int j, int) {
  if (width_ > 0) std::copy_n(rows_[i], width_, rows_[j]);
}

void FixWallGranBridge::set_arrays(int i) {
  if (width_ > 0) std::fill_n(rows_[i], width_, 0.0);
}

int FixWallGranBridge::pack_exchange(int i, double* buffer) {
  if (width_ > 0) std::copy_n(rows_[i], width_, buffer);
  return width_;
}

int FixWallGranBridge::unpack_exchange(int i, double* buffer) {
  if (width_ > 0) std::copy_n(buffer, width_, rows_[i]);
  return width_;
}

// The first value is how many there are, as the host wants it.
int FixWallGranBridge::pack_restart(int i, double* buffer) {
  buffer[0] = width_ + 1;
  std::copy_n(rows_[i], width_, buffer + 1);
  return width_ + 1;
}

void FixWallGranBridge::unpack_restart(int i, int nth) {
  const double* values = atom->extra[i];
  for (int n = 0; n < nth; ++n) values += static_cast<int>(*values);
  if (static_cast<int>(*values) != width_ + 1)
    gasgrain::stop_everything_from_here(fmt::format(
        "fix {} wall/gran/bridge: its models keep {} values of a contact, those of the restart "
        "file {}. Go on with the same models, or give the fix another ID.",
        id, width_ - 1, static_cast<int>(*values) - 2));
  std::copy_n(values + 1, width_, rows_[i]);
}

int FixWallGranBridge::size_restart(int) {
  return width_ + 1;
}
int FixWallGranBridge::maxsize_restart() {
  return width_ + 1;
}

}  // namespace LAMMPS_NS
