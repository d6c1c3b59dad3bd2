// The LIST of studies. A new one is a file beside the others and a line in kinds.cpp.
#pragma once

#include <vector>

#include "tools/study/study_kind.h"

namespace gasgrain {

const std::vector<StudyKind>& all_study_kinds();

Study plan_stiffness(const SceneCopy& scene, const StudyOptions& options);
Study plan_dem_step(const SceneCopy& scene, const StudyOptions& options);
Study plan_fluid_step(const SceneCopy& scene, const StudyOptions& options);
Study plan_coupling_interval(const SceneCopy& scene, const StudyOptions& options);
Study plan_void_fraction(const SceneCopy& scene, const StudyOptions& options);
Study plan_grid(const SceneCopy& scene, const StudyOptions& options);
Study plan_ranks(const SceneCopy& scene, const StudyOptions& options);
Study plan_contact_model(const SceneCopy& scene, const StudyOptions& options);
Study plan_effects(const SceneCopy& scene, const StudyOptions& options);

}  // namespace gasgrain
