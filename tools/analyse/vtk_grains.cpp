#include "tools/analyse/vtk_grains.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

namespace {

// One big-endian value of a type of `Wire`'s size.
template <class Wire>
double value_of(const char* bytes) {
  char turned[sizeof(Wire)];
  std::reverse_copy(bytes, bytes + sizeof(Wire), turned);
  Wire value;
  std::memcpy(&value, turned, sizeof(Wire));
  return static_cast<double>(value);
}

struct Kind {
  std::size_t size;
  double (*value)(const char*);
};

template <class Wire>
constexpr Kind kind = {sizeof(Wire), value_of<Wire>};

const std::map<std::string, Kind>& kinds() {
  static const std::map<std::string, Kind> all{
      {"float", kind<float>},        {"double", kind<double>},
      {"int", kind<std::int32_t>},   {"unsigned_int", kind<std::uint32_t>},
      {"long", kind<std::int64_t>},  {"vtktypeint64", kind<std::int64_t>},
      {"short", kind<std::int16_t>}, {"vtkIdType", kind<std::int64_t>},
      {"char", kind<signed char>},   {"unsigned_char", kind<unsigned char>}};
  return all;
}

class VtkReader {
 public:
  explicit VtkReader(const std::filesystem::path& file) : file_(file), stream_(file) {
    const std::string head = line();
    if (head.rfind("# vtk DataFile", 0) != 0) fail("{} is no legacy VTK file.", file.string());
    line();  // title
    binary_ = line().rfind("BINARY", 0) == 0;
  }

  // Words of the next line that is not values; none at the end.
  std::vector<std::string> heading() {
    std::vector<std::string> words;
    while (words.empty() && stream_.peek() != std::ifstream::traits_type::eof()) {
      std::istringstream text(line());
      for (std::string word; text >> word;) words.push_back(word);
    }
    return words;
  }

  std::vector<double> values(std::size_t count, const std::string& type) {
    const auto found = kinds().find(type);
    if (found == kinds().end())
      fail("{}: values of the kind {} are unknown.", file_.string(), type);
    std::vector<double> read(count);
    if (binary_) {
      std::vector<char> bytes(count * found->second.size);
      stream_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      for (std::size_t n = 0; n < count && stream_; ++n)
        read[n] = found->second.value(&bytes[n * found->second.size]);
    } else {
      for (double& value : read) stream_ >> value;
    }
    if (!stream_) fail("{} is cut short.", file_.string());
    return read;
  }

  [[nodiscard]] std::size_t count(const std::string& word) const {
    char* end = nullptr;
    const long number = std::strtol(word.c_str(), &end, 10);
    if (word.empty() || *end != '\0' || number < 0)
      fail("{}: \"{}\" must be a count.", file_.string(), word);
    return static_cast<std::size_t>(number);
  }

  static bool is_kind(const std::string& word) { return kinds().count(word) > 0; }

 private:
  std::string line() {
    std::string text;
    std::getline(stream_, text);
    return text;
  }

  std::filesystem::path file_;
  std::ifstream stream_;
  bool binary_ = false;
};

// Names of the columns of a field; "f_mean[1-3]" is the host's for f_mean[1] f_mean[2] f_mean[3].
std::vector<std::string> columns_of(const std::string& name, std::size_t components) {
  const std::string field = components > 1 ? name.substr(0, name.find('[')) : name;
  if (components == 1) return {field};
  if (components == 3 && (field == "v" || field == "f" || field == "omega"))
    return {field + "x", field + "y", field + "z"};
  std::vector<std::string> names;
  for (std::size_t n = 1; n <= components; ++n) names.push_back(fmt::format("{}[{}]", field, n));
  return names;
}

}  // namespace

DumpFrame read_vtk_grains(const std::filesystem::path& file, long step) {
  VtkReader vtk(file);
  std::vector<std::string> columns{"x", "y", "z"};
  std::vector<std::vector<double>> rows;
  std::size_t offsets = 0;
  std::size_t corners = 0;
  for (auto words = vtk.heading(); !words.empty(); words = vtk.heading()) {
    if (words[0] == "POINTS" && words.size() == 3) {
      const std::size_t grains = vtk.count(words[1]);
      const auto values = vtk.values(3 * grains, words[2]);
      for (std::size_t n = 0; n < grains; ++n)
        rows.push_back({values[3 * n], values[3 * n + 1], values[3 * n + 2]});
    } else if (words[0] == "VERTICES" && words.size() == 3) {
      offsets = vtk.count(words[1]);
      corners = vtk.count(words[2]);
    } else if ((words[0] == "OFFSETS" || words[0] == "CONNECTIVITY") && words.size() == 2) {
      vtk.values(words[0] == "OFFSETS" ? offsets : corners, words[1]);
    } else if (words.size() == 4 && VtkReader::is_kind(words[3])) {
      const std::size_t components = vtk.count(words[1]);
      if (vtk.count(words[2]) != rows.size())
        fail("{}: the field {} has {} values for {} grains.", file.string(), words[0], words[2],
             rows.size());
      const auto values = vtk.values(components * rows.size(), words[3]);
      for (const auto& name : columns_of(words[0], components)) columns.push_back(name);
      for (std::size_t n = 0; n < rows.size(); ++n)
        for (std::size_t c = 0; c < components; ++c) rows[n].push_back(values[n * components + c]);
    }
  }
  DumpFrame frame(file.string(), step, std::move(columns));
  for (auto& row : rows) frame.add(std::move(row));
  return frame;
}

}  // namespace gasgrain
