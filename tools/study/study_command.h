// `gasgrain study KIND SCENE`: what the accuracy of a dial costs in time.
#pragma once

#include <string>
#include <vector>

#include "tools/study/study_options.h"

namespace gasgrain {

// Names of the kinds with what each turns, for --help.
std::vector<std::pair<std::string, std::string>> study_kinds();

// The exit status: 0 when at least the reference and one more point went well, 130 after Ctrl-C.
// Throws Error when nothing can be run.
int study(const StudyOptions& options);

}  // namespace gasgrain
