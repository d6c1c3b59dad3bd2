#include "tools/advise_command.h"

#include <cstdio>

#include "coupling/base/error.h"
#include "tools/advise_text.h"
#include "tools/advise_write.h"
#include "tools/scene_check.h"

namespace gasgrain {

int advise(const AdviseOptions& options) {
  require_scene(options.scene);
  const NumericsWish wish{0.01 * options.overlap_percent, options.speed};
  AdviseScene scene = read_scene(options.scene, options.variables);
  const Places places = places_of(scene);
  auto effects = effect_rows(scene, places);
  auto numbers = number_rows(scene, places, wish);
  const Advice advice{std::move(scene), places, std::move(effects), std::move(numbers)};
  std::fputs((options.json ? advice_json(advice) : advice_text(advice)).c_str(), stdout);
  if (!options.write.empty()) {
    const auto told = write_advice(advice, options.write, options.variables);
    std::FILE* sink = options.json ? stderr : stdout;
    fmt::print(sink, "\nWritten to {}:\n", options.write.string());
    for (const auto& line : told) fmt::print(sink, "  {}\n", line);
    if (told.empty()) fmt::print(sink, "  nothing to change\n");
  }
  return 0;
}

}  // namespace gasgrain
