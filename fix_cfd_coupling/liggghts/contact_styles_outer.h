// Contact laws that were built elsewhere, as the host's models: filled by `plugin load`, asked by
// the models that are put together at run time.
#pragma once

#include <map>
#include <memory>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}
namespace LIGGGHTS {
class IContactHistorySetup;
namespace ContactModels {
class CohesionModelBase;
class ContactModelBase;
class RollingModelBase;
}  // namespace ContactModels
}  // namespace LIGGGHTS

namespace gasgrain {

// Makes the model of a law that scripts call `name`.
template <class Model>
using OuterMaker = std::shared_ptr<Model> (*)(LAMMPS_NS::LAMMPS*, LIGGGHTS::IContactHistorySetup*,
                                              LIGGGHTS::ContactModels::ContactModelBase*,
                                              const char* name);

template <class Model>
struct OuterLaw {
  std::string name;
  OuterMaker<Model> make;
};

template <class Model>
using OuterLaws = std::map<int, OuterLaw<Model>>;  // by id

// Those loaded so far.
OuterLaws<LIGGGHTS::ContactModels::CohesionModelBase>& outer_cohesion_laws();
OuterLaws<LIGGGHTS::ContactModels::RollingModelBase>& outer_rolling_laws();

// Adds one under its id and its name. Throws Error where another law has one of them.
void add_outer_cohesion(const std::string& name, int id,
                        OuterMaker<LIGGGHTS::ContactModels::CohesionModelBase> make);
void add_outer_rolling(const std::string& name, int id,
                       OuterMaker<LIGGGHTS::ContactModels::RollingModelBase> make);

}  // namespace gasgrain
