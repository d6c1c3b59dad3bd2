#include "fix_cfd_coupling/liggghts/compiled_contact.h"

#include <algorithm>
#include <sstream>

#include "coupling/base/error.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_damped_history.h"
#include "fix_cfd_coupling/dem_physics/contact/tangential_no_history.h"

namespace gasgrain {
namespace {

// Without those that no script of LIGGGHTS can name: it lists what is compiled, line by line.
std::string of_this_host(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (line.find(contact::TangentialDampedHistory::name) == std::string::npos) kept += line + '\n';
  return kept;
}

// `tangential off`, or no such word, is LIGGGHTS's way to leave friction out: a model of friction
// whose coefficient is then 0 does the same. Whether the words are so.
bool name_no_friction(std::vector<std::string>& words) {
  const auto at = std::find(words.begin(), words.end(), "tangential");
  if (at == words.end()) {
    words.insert(words.end(), {"tangential", contact::TangentialNoHistory::name});
    return true;
  }
  if (at + 1 == words.end() || at[1] != "off") return false;
  at[1] = contact::TangentialNoHistory::name;
  return true;
}

}  // namespace

CompiledContact::CompiledContact(std::vector<std::string> words, bool of_wall)
    : frictionless_(name_no_friction(words)) {
  try {
    choice_ = contact::read_contact(words, of_wall);
  } catch (const Error& e) {
    throw Error(of_this_host(e.what()));
  }
  choice_.stack->put_cohesion_first();
}

void CompiledContact::connect(LAMMPS_NS::LAMMPS& host, LIGGGHTS::IContactHistorySetup& place) {
  hosts_.clear();
  choice_.stack->connect(
      choice_.name, [&](const std::string& law, int offset) -> contact::ContactHost& {
        auto& of_law =
            *hosts_.emplace_back(std::make_unique<ContactHostLiggghts>(host, place, law));
        of_law.set_history_offset(offset);
        of_law.set_frictionless(frictionless_);
        return of_law;
      });
}

}  // namespace gasgrain
