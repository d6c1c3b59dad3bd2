#include "tools/measure/dump_file.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

// The line after `heading`, which must be the next.
std::string line_after(std::istream& stream, const std::string& heading, const std::string& file) {
  std::string line;
  std::getline(stream, line);
  if (line.rfind(heading, 0) != 0)
    fail(
        "{}: \"{}\" is missing: this is no whole dump of the style custom or "
        "local.",
        file, heading);
  std::getline(stream, line);
  return line;
}

DumpFrame read_frame(std::istream& stream, const std::string& file) {
  const long step = std::atol(line_after(stream, "ITEM: TIMESTEP", file).c_str());
  const long count = std::atol(line_after(stream, "ITEM: NUMBER OF ", file).c_str());
  line_after(stream, "ITEM: BOX BOUNDS", file);
  std::string line;
  std::getline(stream, line);  // y
  std::getline(stream, line);  // z
  std::getline(stream, line);
  std::istringstream heading(line);
  std::string word;
  std::vector<std::string> columns;
  heading >> word >> word;  // ITEM: ATOMS, or ENTRIES of a dump local
  while (heading >> word) columns.push_back(word);
  const std::size_t width = columns.size();
  DumpFrame frame(file, step, std::move(columns));
  for (long n = 0; n < count; ++n) {
    std::getline(stream, line);
    std::istringstream text(line);
    std::vector<double> row(width);
    for (double& value : row) text >> value;
    if (!text || width == 0)
      fail("{}: row {} of {} of step {} is cut short or no number.", file, n + 1, count, step);
    frame.add(std::move(row));
  }
  return frame;
}

}  // namespace

std::size_t DumpFrame::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end())
    fail("{}: the dump has no column {}.{} Add it to the script's dump line.", file_, name,
         suggestion(name, columns_));
  return static_cast<std::size_t>(found - columns_.begin());
}

std::vector<Grain> DumpFrame::grains() const {
  const std::size_t x = column("x");
  const std::size_t y = column("y");
  const std::size_t z = column("z");
  const std::size_t radius = column("radius");
  std::vector<Grain> grains;
  grains.reserve(rows_.size());
  for (const auto& row : rows_) grains.push_back({{row[x], row[y], row[z]}, row[radius]});
  return grains;
}

void DumpFrame::sort_by_id() {
  const std::size_t id = column("id");
  std::sort(rows_.begin(), rows_.end(),
            [id](const auto& a, const auto& b) { return a[id] < b[id]; });
}

std::vector<DumpFrame> read_dump(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    fail(
        "{} is absent: the script must write it, for example\n  dump heap all custom 1000 "
        "${{out}}/particles/{} id x y z radius",
        file.string(), file.filename().string());
  std::vector<DumpFrame> frames;
  while (stream.peek() != std::ifstream::traits_type::eof())
    frames.push_back(read_frame(stream, file.string()));
  if (frames.empty()) fail("{} is empty: the run wrote no frame.", file.string());
  return frames;
}

}  // namespace gasgrain
