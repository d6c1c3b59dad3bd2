#include "fix_cfd_coupling/dem_physics/contact/instruction_set.h"

#include <algorithm>
#include <cstdlib>

#include "coupling/base/error.h"

namespace gasgrain::contact {

std::string name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::portable:
      break;
  }
  return "portable";
}

std::vector<InstructionSet> instruction_sets_here() {
  std::vector<InstructionSet> sets = {InstructionSet::portable};
#ifdef GASGRAIN_LANES
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
      __builtin_cpu_supports("bmi2"))
    sets.push_back(InstructionSet::avx2);
  if (sets.size() == 2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512cd"))
    sets.push_back(InstructionSet::avx512);
#endif
  return sets;
}

InstructionSet chosen_instruction_set() {
  const auto here = instruction_sets_here();
  const char* wish = std::getenv("GASGRAIN_INSTRUCTIONS");
  if (wish == nullptr || *wish == '\0') return here.back();
  std::vector<std::string> names;
  for (const auto set : here) {
    if (name_of(set) == wish) return set;
    names.push_back(name_of(set));
  }
  fail("GASGRAIN_INSTRUCTIONS={} is not of this machine and program, which have {}.{}", wish,
       fmt::join(names, ", "), suggestion(wish, names));
}

}  // namespace gasgrain::contact
