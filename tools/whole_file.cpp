#include "tools/whole_file.h"

#include <fstream>

#include "coupling/base/error.h"

namespace gasgrain {

void write_whole(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path beside = file.string() + ".part";
  std::ofstream stream(beside);
  stream << text;
  stream.close();
  if (!stream) fail("{} cannot be written.", file.string());
  std::filesystem::rename(beside, file);
}

}  // namespace gasgrain
