// Which grains of a dump are the big ones: by size, type or number.
#pragma once

#include <string>
#include <vector>

#include "tools/measure/dump_file.h"

namespace gasgrain {

class BigGrains {
 public:
  // "largest", "type=2", "id=1,7" or "above=0.002" (diameter [m]). Faults are told with the nearest
  // name.
  BigGrains(const std::string& text, std::vector<std::string>& faults);

  // A flag a row.
  [[nodiscard]] std::vector<bool> of(const DumpFrame& frame) const;

 private:
  enum class By { largest, type, id, above };
  By by_ = By::largest;
  std::vector<double> values_;
};

}  // namespace gasgrain
