// Goes through the dumps of a run once and gathers the windows' rates. What only the dumps tell,
// d_s and the steps from dump to dump, it learns from the first of them.
#pragma once

#include <optional>

#include "tools/analyse/analyse_options.h"
#include "tools/analyse/phase_frames.h"

namespace gasgrain {

class DragReading {
 public:
  DragReading(const AnalyseOptions& options, const RunFacts& facts, const BigGrains& big)
      : options_(options), facts_(facts), big_(big) {}

  void add(const DumpFrame& frame);
  // Throws when there was too little to fill a window.
  [[nodiscard]] const DragRates& rates() const;
  [[nodiscard]] const ForceColumns& force() const { return *force_; }

 private:
  void check_largest(const Phases& phases);
  void learn_spacing(long spacing);
  void learn_small_diameter(const std::vector<MovingGrain>& small);

  const AnalyseOptions& options_;
  const RunFacts& facts_;
  const BigGrains& big_;
  std::optional<ForceColumns> force_;
  std::optional<long> last_step_;
  long spacing_ = 0;  // steps
  long window_steps_ = 0;
  double big_radius_ = 0.0;      // of the first one
  double small_diameter_ = 0.0;  // Sauter's mean of the first frame that has small grains
  std::vector<Phases> waiting_;  // until both are known
  std::optional<DragRates> rates_;
};

}  // namespace gasgrain
