// Puts advice into a copy of a scene: the dials of its script, the words of its couple/gas line,
// the keys of its gas.toml. Comments stay, and the scene itself is not touched.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/advise_text.h"

namespace gasgrain {

// Every change as a line for people; also what could not be put in, and how to do it by hand.
// `variables`: of the command line, as the advice was found with them.
std::vector<std::string> write_advice(
    const Advice& advice, const std::filesystem::path& folder,
    const std::vector<std::pair<std::string, std::string>>& variables);

}  // namespace gasgrain
