#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"

#include <cstdlib>

namespace gasgrain::contact {

void ContactHost::refuse(const std::string& why) const {
  end_launch(fmt::format("{}: {}", law_, why));
  std::abort();
}

PairTable<double> ContactHost::need_pairs(const char* name, const char* unit) const {
  if (auto values = pairs(name)) return *values;
  refuse_missing(name, fmt::format("fix ID all property/global {} peratomtypepair {} VALUES  ({})",
                                   name, types(), unit));
}

std::vector<double> ContactHost::need_per_type(const char* name, const char* unit) const {
  if (auto values = per_type(name)) return *values;
  refuse_missing(name,
                 fmt::format("fix ID all property/global {} peratomtype VALUES  ({})", name, unit));
}

double ContactHost::need_scalar(const char* name, const char* unit) const {
  if (auto value = scalar(name)) return *value;
  refuse_missing(name, fmt::format("fix ID all property/global {} scalar VALUE  ({})", name, unit));
}

void ContactHost::refuse_missing(const char* name, const std::string& lines) const {
  const std::string near = nearest_name(name, property_names());
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

}  // namespace gasgrain::contact
