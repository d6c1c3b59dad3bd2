#include "fix_cfd_coupling/liggghts/contact_styles_properties.h"

#include <cstring>
#include <utility>

#include "lammps.h"
// --
#include "atom.h"
#include "error.h"
#include "fix_property_global.h"
#include "force.h"
#include "modify.h"
#include "update.h"

namespace gasgrain {

// A property's name is private to its fix; an explicit instantiation may name it.
struct PropertyNameTag {
  using Type = char* LAMMPS_NS::FixPropertyGlobal::*;
  friend Type property_member(PropertyNameTag);
};
template <class Tag, typename Tag::Type member>
struct RevealProperty {
  friend typename Tag::Type property_member(Tag) { return member; }
};
template struct RevealProperty<PropertyNameTag, &LAMMPS_NS::FixPropertyGlobal::variablename>;

namespace {

LAMMPS_NS::FixPropertyGlobal* find(LAMMPS_NS::LAMMPS& host, const char* name, const char* kind,
                                   int rows, int columns) {
  return static_cast<LAMMPS_NS::FixPropertyGlobal*>(host.modify->find_fix_property(
      name, "property/global", kind, rows, columns, "contact model", false));
}

std::vector<std::string> property_names(LAMMPS_NS::LAMMPS& host) {
  std::vector<std::string> names;
  for (int n = 0; n < host.modify->nfix; ++n) {
    LAMMPS_NS::Fix* fix = host.modify->fix[n];
    if (std::strcmp(fix->style, "property/global") == 0)
      names.emplace_back(
          static_cast<LAMMPS_NS::FixPropertyGlobal*>(fix)->*property_member(PropertyNameTag{}));
  }
  return names;
}

}  // namespace

ContactProperties::ContactProperties(LAMMPS_NS::LAMMPS& host, std::string model)
    : host_(host), model_(std::move(model)), types_(host.atom->ntypes) {}

std::optional<PairTable<double>> ContactProperties::pairs(const char* name) const {
  auto* fix = find(host_, name, "peratomtypepair", types_, types_);
  if (fix == nullptr) return std::nullopt;
  PairTable<double> table(types_);
  for (int i = 1; i <= types_; ++i)
    for (int j = 1; j <= types_; ++j) table(i, j) = fix->compute_array(i - 1, j - 1);
  return table;
}

std::optional<std::vector<double>> ContactProperties::per_type(const char* name) const {
  auto* fix = find(host_, name, "peratomtype", types_, 0);
  if (fix == nullptr) return std::nullopt;
  std::vector<double> values(types_ + 1);
  for (int i = 1; i <= types_; ++i) values[i] = fix->compute_vector(i - 1);
  return values;
}

std::optional<double> ContactProperties::scalar(const char* name) const {
  auto* fix = find(host_, name, "scalar", 0, 0);
  if (fix == nullptr) return std::nullopt;
  return fix->compute_scalar();
}

PairTable<double> ContactProperties::need_pairs(const char* name, const char* unit) const {
  if (auto values = pairs(name)) return *values;
  refuse_missing(name, fmt::format("fix ID all property/global {} peratomtypepair {} VALUES  ({})",
                                   name, types_, unit));
}

std::vector<double> ContactProperties::need_per_type(const char* name, const char* unit) const {
  if (auto values = per_type(name)) return *values;
  refuse_missing(name,
                 fmt::format("fix ID all property/global {} peratomtype VALUES  ({})", name, unit));
}

double ContactProperties::need_scalar(const char* name, const char* unit) const {
  if (auto value = scalar(name)) return *value;
  refuse_missing(name, fmt::format("fix ID all property/global {} scalar VALUE  ({})", name, unit));
}

void ContactProperties::refuse_unfit_run() const {
  if (host_.force->cg_active()) host_.error->cg(FLERR, model_.c_str());
  if (std::strcmp(host_.update->unit_style, "si") != 0)
    refuse(fmt::format("it works in SI, but the script has 'units {}'. Write 'units si'.",
                       host_.update->unit_style));
}

void ContactProperties::refuse(const std::string& why) const {
  stop_everything(fmt::format("{}: {}", model_, why));
}

void ContactProperties::refuse_missing(const char* name, const std::string& lines) const {
  const std::string near = nearest_name(name, property_names(host_));
  std::string hint;
  if (near == name)
    hint =
        "\nThe script has a property of this name, but not in this form, or not one value for "
        "each of the types.";
  else if (!near.empty())
    hint = fmt::format("\nThe script has \"{}\": is it misspelt?", near);
  refuse(
      fmt::format("it needs the property {}. Add before this model:\n  {}{}", name, lines, hint));
}

}  // namespace gasgrain
