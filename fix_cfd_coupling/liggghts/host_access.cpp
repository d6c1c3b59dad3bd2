// Reaches private members by the one legal way: the arguments of an explicit template instantiation
// may name them.
#include "fix_cfd_coupling/liggghts/host_access.h"

#include "fix_contact_history.h"
#include "input.h"
#include "modify.h"
#include "output.h"
#include "thermo.h"

namespace gasgrain {

struct FixMapTag {
  using Type = std::map<std::string, FixCreator>* LAMMPS_NS::Modify::*;
  friend Type member_of(FixMapTag);
};
struct CommandMapTag {
  using Type = std::map<std::string, CommandCreator>* LAMMPS_NS::Input::*;
  friend Type member_of(CommandMapTag);
};
struct LostFlagTag {
  using Type = int LAMMPS_NS::Thermo::*;
  friend Type member_of(LostFlagTag);
};

struct ListInUseTag {
  using Type = int* LAMMPS_NS::FixContactHistory::*;
  friend Type member_of(ListInUseTag);
};

// The friend must live in namespace gasgrain itself: no unnamed namespace around it.
template <class Tag, typename Tag::Type member>
struct Reveal {
  friend typename Tag::Type member_of(Tag) { return member; }
};
template struct Reveal<FixMapTag, &LAMMPS_NS::Modify::fix_map>;
template struct Reveal<CommandMapTag, &LAMMPS_NS::Input::command_map>;
template struct Reveal<LostFlagTag, &LAMMPS_NS::Thermo::lostflag>;
template struct Reveal<ListInUseTag, &LAMMPS_NS::FixContactHistory::computeflag_>;

std::map<std::string, FixCreator>& fix_map(LAMMPS_NS::LAMMPS& host) {
  return *(host.modify->*member_of(FixMapTag{}));
}

std::map<std::string, CommandCreator>& command_map(LAMMPS_NS::LAMMPS& host) {
  return *(host.input->*member_of(CommandMapTag{}));
}

bool lost_grains_are_errors(LAMMPS_NS::LAMMPS& host) {
  constexpr int error = 2;  // of thermo.cpp's enum: ignore, warn, error
  return host.output->thermo != nullptr && host.output->thermo->*member_of(LostFlagTag{}) == error;
}

void store_contacts_now(LAMMPS_NS::FixContactHistory& stored) {
  int* list_in_use = stored.*member_of(ListInUseTag{});
  if (list_in_use == nullptr || *list_in_use == 0) return;
  stored.pre_exchange();
  *list_in_use = 0;
}

}  // namespace gasgrain
