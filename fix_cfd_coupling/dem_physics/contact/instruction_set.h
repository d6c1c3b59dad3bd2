// Which of the processor's vector instructions the loops over contacts use. It is chosen when the
// program runs, so that one package serves every machine.
#pragma once

#include <string>
#include <vector>

namespace gasgrain::contact {

// `portable` computes one contact after the other with what every machine has.
enum class InstructionSet { portable, avx2, avx512 };

// What this machine has and this program was built for, the widest last.
std::vector<InstructionSet> instruction_sets_here();
std::string name_of(InstructionSet set);

// The widest of them; GASGRAIN_INSTRUCTIONS=portable, avx2 or avx512 of the environment asks for
// another. Throws Error where that is unknown or the machine does not have it.
InstructionSet chosen_instruction_set();

}  // namespace gasgrain::contact
