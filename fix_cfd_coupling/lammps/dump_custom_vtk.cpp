#include "fix_cfd_coupling/lammps/dump_custom_vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>

#include "coupling/base/error.h"
// --
#include "domain.h"
#include "update.h"

namespace LAMMPS_NS {

namespace {

// Legacy VTK has the highest byte first.
template <class Wire>
void append(std::string& bytes, Wire value) {
  char of_value[sizeof(Wire)];
  std::memcpy(of_value, &value, sizeof(Wire));
  std::reverse(of_value, of_value + sizeof(Wire));
  bytes.append(of_value, sizeof(Wire));
}

std::vector<std::string> words_of(const char* text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// "v" of "vx"; empty for what is no part of a vector.
std::string vector_of(const std::string& column) {
  for (const char* name : {"v", "f", "omega"})
    if (column == std::string(name) + "x") return name;
  return "";
}

}  // namespace

DumpCustomVtk::DumpCustomVtk(LAMMPS* host, int narg, char** arg) : DumpCustom(host, narg, arg) {
  if (multifile == 0 || multiproc != 0)
    gasgrain::stop_everything(fmt::format(
        "dump custom/vtk writes a file a step: there must be a * in the name \"{}\", and no %.",
        filename));
  binary = 1;
  buffer_allow = buffer_flag = 0;  // values come as they are, not as text
  const auto names = words_of(columns);
  width_ = names.size();
  const auto has = [&](std::size_t n, const std::string& name) {
    return n < names.size() && names[n] == name;
  };
  points_.name = "POINTS";
  for (const char* axis : {"x", "y", "z"}) {
    const auto found = std::find(names.begin(), names.end(), axis);
    if (found == names.end())
      gasgrain::stop_everything("dump custom/vtk needs x y z among its words.");
    points_.columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (names[n] == "x" || names[n] == "y" || names[n] == "z") continue;
    const std::string vector = vector_of(names[n]);
    if (!vector.empty() && has(n + 1, vector + "y") && has(n + 2, vector + "z")) {
      fields_.push_back({vector, {n, n + 1, n + 2}});
      n += 2;
    } else {
      fields_.push_back({names[n], {n}});
    }
  }
}

void DumpCustomVtk::write_header(bigint rows) {
  written_ = 0;
  const auto text = [&](const std::string& words) { fmt::print(fp, "{}", words); };
  const auto leave_room = [&](Field& field) {
    field.at = std::ftell(fp);
    std::fseek(fp, rows * static_cast<long>(field.columns.size() * sizeof(double)), SEEK_CUR);
    text("\n");
  };
  text(fmt::format("# vtk DataFile Version 5.1\ngasgrain, step {}\nBINARY\nDATASET POLYDATA\n",
                   update->ntimestep));
  text(fmt::format("POINTS {} double\n", rows));
  leave_room(points_);
  std::string bytes;
  const auto flush = [&](std::size_t longest) {
    if (bytes.size() < longest) return;
    std::fwrite(bytes.data(), 1, bytes.size(), fp);
    bytes.clear();
  };
  constexpr std::size_t piece = 1 << 16;
  text(fmt::format("VERTICES {} {}\nOFFSETS vtktypeint64\n", rows + 1, rows));
  for (std::int64_t n = 0; n <= rows; ++n, flush(piece)) append(bytes, n);
  flush(1);
  text("\nCONNECTIVITY vtktypeint64\n");
  for (std::int64_t n = 0; n < rows; ++n, flush(piece)) append(bytes, n);
  flush(1);
  text(fmt::format("\nPOINT_DATA {}\nFIELD FieldData {}\n", rows, fields_.size()));
  for (Field& field : fields_) {
    text(fmt::format("{} {} {} double\n", field.name, field.columns.size(), rows));
    leave_room(field);
  }
  write_box();
}

void DumpCustomVtk::write_data(int rows, double* values) {
  write_values(points_, rows, values);
  for (const Field& field : fields_) write_values(field, rows, values);
  written_ += rows;
}

void DumpCustomVtk::write_values(const Field& field, int rows, const double* values) {
  std::string bytes;
  const std::size_t of_row = field.columns.size() * sizeof(double);
  bytes.reserve(static_cast<std::size_t>(rows) * of_row);
  for (int n = 0; n < rows; ++n)
    for (const std::size_t column : field.columns)
      append(bytes, values[static_cast<std::size_t>(n) * width_ + column]);
  std::fseek(fp, field.at + written_ * static_cast<long>(of_row), SEEK_SET);
  if (std::fwrite(bytes.data(), 1, bytes.size(), fp) != bytes.size() || std::fflush(fp) != 0)
    gasgrain::stop_everything_from_here(
        fmt::format("dump custom/vtk: \"{}\" cannot be written: is the disk full?", filename));
}

void DumpCustomVtk::write_box() const {
  std::string name = filename;
  const auto star = name.find('*');
  name.replace(star, 1, fmt::format("boundingBox_{}", update->ntimestep));
  std::ofstream file(name);
  file << "# vtk DataFile Version 5.1\ngasgrain, the box\nASCII\nDATASET RECTILINEAR_GRID\n"
          "DIMENSIONS 2 2 2\n";
  for (int d = 0; d < 3; ++d)
    file << fmt::format("{}_COORDINATES 2 double\n{} {}\n", "XYZ"[d], domain -> boxlo[d],
                        domain -> boxhi[d]);
}

}  // namespace LAMMPS_NS
