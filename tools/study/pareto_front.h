// The Pareto front of a study: the points that no other point beats in cost and error both.
#pragma once

#include <vector>

#include "tools/study/study_point.h"

namespace gasgrain {

// Marks the rows on the front of the figures `cost` and `error`, both the less the better. Rows
// that failed, or lack one of the two, as references do, are not on it, nor is the twin.
void mark_pareto_front(std::vector<StudyRow>& rows, const std::string& cost,
                       const std::string& error);

}  // namespace gasgrain
