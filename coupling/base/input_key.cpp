#include "coupling/base/input_key.h"

#include <fmt/format.h>

namespace gasgrain {
namespace {

std::string columns_of(const InputKey& key) {
  const std::string fallback = key.fallback.empty() ? "required" : key.fallback;
  return fmt::format(" | {} | {} | {}{} |", key.unit, key.range, fallback,
                     key.with.empty() ? "" : "; with " + key.with);
}

}  // namespace

std::string markdown_of(const std::vector<InputKey>& keys) {
  std::string text;
  const InputKey* last = nullptr;
  for (const InputKey& key : keys) {
    if (key.heading.empty()) continue;
    const bool shares =
        last != nullptr && last->heading == key.heading && columns_of(*last) == columns_of(key);
    if (shares) {
      text += fmt::format(", `{}`", key.key);
    } else {
      if (last != nullptr) text += columns_of(*last) + '\n';
      text += fmt::format("| `{} {}`", key.heading, key.key);
    }
    last = &key;
  }
  if (last != nullptr) text += columns_of(*last) + '\n';
  return text;
}

}  // namespace gasgrain
