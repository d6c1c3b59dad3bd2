#include "fix_cfd_coupling/lammps/fix_property_global.h"

#include <cmath>
#include <cstring>
#include <map>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "atom.h"
#include "modify.h"
#include "utils.h"

namespace LAMMPS_NS {

namespace {

[[noreturn]] void refuse(const char* id, const std::string& why) {
  gasgrain::stop_everything(fmt::format("fix {} property/global: {}", id, why));
}

}  // namespace

FixPropertyGlobal::FixPropertyGlobal(LAMMPS* host, int narg, char** arg) : Fix(host, narg, arg) {
  if (narg < 6) refuse(id, "it needs NAME KIND VALUES, such as 'youngsModulus peratomtype 5e6'.");
  name_ = arg[3];
  const std::map<std::string, Kind> kinds = {{"scalar", Kind::scalar},
                                             {"vector", Kind::vector},
                                             {"peratomtype", Kind::per_type},
                                             {"peratomtypepair", Kind::pairs}};
  const auto found = kinds.find(arg[4]);
  if (found == kinds.end()) {
    std::vector<std::string> known;
    for (const auto& [kind, meaning] : kinds) known.push_back(kind);
    refuse(id, fmt::format("{} is no kind of a property.{}", arg[4],
                           gasgrain::suggestion(arg[4], known)));
  }
  kind_ = found->second;
  int at = 5;
  if (kind_ == Kind::pairs)
    size_array_rows = size_array_cols = utils::inumeric(FLERR, arg[at++], false, lmp);
  for (; at < narg; ++at) {
    values_.push_back(utils::numeric(FLERR, arg[at], false, lmp));
    if (!std::isfinite(values_.back()))
      refuse(id, fmt::format("value {} of {} is {}.", values_.size(), name_, arg[at]));
  }
  check_size();
  scalar_flag = kind_ == Kind::scalar;
  vector_flag = kind_ == Kind::vector || kind_ == Kind::per_type;
  array_flag = kind_ == Kind::pairs;
  size_vector = static_cast<int>(values_.size());
  global_freq = 1;
  extscalar = extvector = extarray = 0;
}

void FixPropertyGlobal::check_size() const {
  const int types = atom->ntypes;
  if (kind_ == Kind::scalar && values_.size() != 1)
    refuse(id, fmt::format("{} scalar has one value, not {}.", name_, values_.size()));
  if (kind_ == Kind::per_type && values_.size() != static_cast<std::size_t>(types))
    refuse(id, fmt::format("{} peratomtype needs a value for each of the {} types, and has {}.",
                           name_, types, values_.size()));
  if (kind_ != Kind::pairs) return;
  if (size_array_rows != types)
    refuse(id, fmt::format("{} peratomtypepair {}: the scene has {} types.", name_, size_array_rows,
                           types));
  if (values_.size() != static_cast<std::size_t>(types) * types)
    refuse(id, fmt::format("{} peratomtypepair {} needs {} values, and has {}.", name_, types,
                           types * types, values_.size()));
  for (int i = 0; i < types; ++i)
    for (int j = 0; j < i; ++j)
      if (values_[i * types + j] != values_[j * types + i])
        refuse(id, fmt::format(
                       "{} of types {} and {} is {}, of {} and {} it is {}: a property of pairs "
                       "is symmetric.",
                       name_, i + 1, j + 1, values_[i * types + j], j + 1, i + 1,
                       values_[j * types + i]));
}

FixPropertyGlobal* FixPropertyGlobal::find(LAMMPS* host, const std::string& name, Kind kind,
                                           std::size_t values) {
  for (int n = 0; n < host->modify->nfix; ++n) {
    auto* fix = dynamic_cast<FixPropertyGlobal*>(host->modify->fix[n]);
    if (fix != nullptr && fix->name_ == name && fix->kind_ == kind && fix->values_.size() == values)
      return fix;
  }
  return nullptr;
}

std::vector<std::string> FixPropertyGlobal::names(LAMMPS* host) {
  std::vector<std::string> found;
  for (int n = 0; n < host->modify->nfix; ++n)
    if (const auto* fix = dynamic_cast<FixPropertyGlobal*>(host->modify->fix[n]))
      found.push_back(fix->name_);
  return found;
}

}  // namespace LAMMPS_NS
