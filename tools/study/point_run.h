// Runs the points of a study, each by `gasgrain run` on a copy of the scene.
#pragma once

#include <functional>
#include <string>

#include "tools/study/study_options.h"
#include "tools/study/study_point.h"

namespace gasgrain {

// A folder of the study: FOLDER/scene is the copy, FOLDER/run1 (run2, ...) its results.
class PointRunner {
 public:
  // `look` is called now and then with the share of the point that is done, from 0 to 1.
  using Look = std::function<void(double share)>;

  PointRunner(StudyOptions options, double time_s, std::filesystem::path folder);

  // Packs the scene's bed for all points; nothing when the scene cannot begin from a packed bed. A
  // bed that an earlier, interrupted study packed is taken as it is. False when a stop was asked
  // for. Throws Error when the bed cannot be packed: no point could run.
  bool pack(const Settings& variables, const Look& look);

  // Runs the point unless its folder holds its results already. The status is "ok" or why it
  // failed; empty when a stop was asked for.
  std::string run(const StudyPoint& point, const Look& look);

  [[nodiscard]] std::filesystem::path results(const StudyPoint& point, int repeat = 1) const;
  // True when the point's results are there already.
  [[nodiscard]] bool is_done(const StudyPoint& point) const;
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] bool begins_packed() const { return begins_packed_; }

 private:
  // The point's scene is in folder/scene when this returns; what it is made of is the text.
  std::string prepare(const StudyPoint& point, bool packed) const;
  std::string launch(const StudyPoint& point, const std::filesystem::path& results, double time_s,
                     const Look& look) const;

  StudyOptions options_;
  double time_s_;
  std::filesystem::path folder_;
  bool begins_packed_ = false;
};

}  // namespace gasgrain
