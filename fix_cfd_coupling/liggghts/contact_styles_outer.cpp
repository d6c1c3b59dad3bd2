#include "fix_cfd_coupling/liggghts/contact_styles_outer.h"

#include "coupling/base/error.h"
// The host's headers lean on each other's order.
#include "fix_insert_stream.h"
// --
#include "contact_models.h"

namespace gasgrain {
namespace {

using LIGGGHTS::ContactModels::Factory;
constexpr int first_id = 40;
constexpr int last_id = 63;  // a hash of models has six bits for each

// `known`: id of the name among the host's, below 1 where it has none.
template <class Model>
void add(OuterLaws<Model>& laws, const char* kind, const std::string& name, int id, int known,
         OuterMaker<Model> make) {
  if (id < first_id || id > last_id)
    fail("{} {}: its id is {}. Laws that are built outside of gasgrain have {} to {}.", kind, name,
         id, first_id, last_id);
  const auto at = laws.find(id);
  if (at != laws.end() && at->second.name != name)
    fail(
        "{} {}: its id {} is that of \"{}\", which is loaded too. Give one of them another, {} to "
        "{}.",
        kind, name, id, at->second.name, first_id, last_id);
  if (at == laws.end() && known > 0)
    fail("{} {}: there is a law of this name already. Give it another one.", kind, name);
  laws[id] = {name, make};
}

}  // namespace

OuterLaws<LIGGGHTS::ContactModels::CohesionModelBase>& outer_cohesion_laws() {
  static OuterLaws<LIGGGHTS::ContactModels::CohesionModelBase> laws;
  return laws;
}
OuterLaws<LIGGGHTS::ContactModels::RollingModelBase>& outer_rolling_laws() {
  static OuterLaws<LIGGGHTS::ContactModels::RollingModelBase> laws;
  return laws;
}

void add_outer_cohesion(const std::string& name, int id,
                        OuterMaker<LIGGGHTS::ContactModels::CohesionModelBase> make) {
  add(outer_cohesion_laws(), "cohesion", name, id, Factory::instance().getCohesionModelId(name),
      make);
  Factory::instance().addCohesionModel(name, id);
}
void add_outer_rolling(const std::string& name, int id,
                       OuterMaker<LIGGGHTS::ContactModels::RollingModelBase> make) {
  add(outer_rolling_laws(), "rolling_friction", name, id,
      Factory::instance().getRollingModelId(name), make);
  Factory::instance().addRollingModel(name, id);
}

}  // namespace gasgrain
