#include "fix_cfd_coupling/fixes/script_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace gasgrain {

// The open script's name is that of its descriptor, the line is told by its position.
std::string place_in_script(std::FILE* script) {
  if (script == nullptr) return "";
  std::array<char, 4096> name{};
  const auto link = fmt::format("/proc/self/fd/{}", fileno(script));
  const auto length = readlink(link.c_str(), name.data(), name.size() - 1);
  const long position = std::ftell(script);
  if (length <= 0 || position < 0) return "";
  std::FILE* again = std::fopen(name.data(), "r");
  if (again == nullptr) return "";
  std::string text;
  int number = 0;
  long at = 0;
  int c = 0;
  while (at < position && (c = std::fgetc(again)) != EOF) {
    ++at;
    if (text.empty() || text.back() == '\n') {
      text.clear();
      ++number;
    }
    text.push_back(static_cast<char>(c));
  }
  std::fclose(again);
  if (number == 0) return "";
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  const std::string path = name.data();
  return fmt::format("{}:{}: \"{}\": ", path.substr(path.find_last_of('/') + 1), number, text);
}

}  // namespace gasgrain
