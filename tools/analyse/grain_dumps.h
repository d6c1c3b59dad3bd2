// The dumps of a run, frame by frame in the order of their steps: one text file of all frames, or
// a file a frame, text or legacy VTK, whose name ends in the step: grains.*.dump, p_*.vtk.
#pragma once

#include <functional>

#include "tools/measure/dump_file.h"

namespace gasgrain {

class GrainDumps {
 public:
  // `place`: a results folder, in whose particles/ `pattern` is looked for (an empty one: the only
  // dumps there), or a file. Throws an Error that lists what there is.
  GrainDumps(const std::filesystem::path& place, const std::string& pattern);

  // "grains.*.dump"
  [[nodiscard]] const std::string& name() const { return name_; }
  // A file of all frames is read whole; of a file a frame one is held at a time.
  void each(const std::function<void(const DumpFrame& frame)>& look) const;

 private:
  std::string name_;
  std::vector<std::pair<long, std::filesystem::path>> files_;  // by step
};

}  // namespace gasgrain
