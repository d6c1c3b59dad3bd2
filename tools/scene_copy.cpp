#include "tools/scene_copy.h"

#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) fail("{} is absent or cannot be read.", file.string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void write_lines(const fs::path& file, const std::vector<std::string>& lines) {
  std::ofstream stream(file);
  for (const auto& line : lines) stream << line << '\n';
  stream.close();
  if (!stream) fail("{} cannot be written.", file.string());
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

// Where the parts of `variable NAME index VALUE  # comment` are in a line.
struct VariableLine {
  std::string name;
  std::size_t value_begin = 0;
  std::size_t value_end = 0;
};

VariableLine parsed_variable(const std::string& line) {
  std::istringstream words(line);
  std::string verb;
  std::string name;
  std::string style;
  words >> verb >> name >> style;
  if (verb != "variable" || style != "index") return {};
  VariableLine parts;
  parts.name = name;
  const std::size_t after =
      line.find(style, line.find(name, line.find(verb) + verb.size()) + name.size()) + style.size();
  parts.value_begin = std::min(line.find_first_not_of(" \t", after), line.size());
  const std::size_t end = std::min(line.find('#', after), line.size());
  parts.value_end = end;
  while (parts.value_end > parts.value_begin &&
         std::isspace(static_cast<unsigned char>(line[parts.value_end - 1])) != 0)
    --parts.value_end;
  return parts;
}

}  // namespace

SceneCopy::SceneCopy(const fs::path& scene, fs::path folder)
    : scene_(scene),
      folder_(std::move(folder)),
      script_(lines_of(scene / "in.liggghts")),
      gas_(lines_of(scene / "gas.toml")) {
  if (fs::exists(folder_) && fs::equivalent(scene_, folder_))
    fail("{} is the scene itself: name another folder for its copy.", folder_.string());
  fs::create_directories(folder_);
  for (const auto& entry : fs::directory_iterator(scene_))
    if (entry.is_regular_file())
      fs::copy_file(entry.path(), folder_ / entry.path().filename(),
                    fs::copy_options::overwrite_existing);
}

std::size_t SceneCopy::variable_line(const std::string& name) const {
  for (std::size_t n = 0; n < script_.size(); ++n)
    if (parsed_variable(script_[n]).name == name) return n;
  return script_.size();
}

bool SceneCopy::has_variable(const std::string& name) const {
  return variable_line(name) < script_.size();
}

std::string SceneCopy::variable(const std::string& name) const {
  const std::size_t n = variable_line(name);
  if (n == script_.size()) {
    std::vector<std::string> names;
    for (const auto& line : script_)
      if (const auto parts = parsed_variable(line); !parts.name.empty())
        names.push_back(parts.name);
    const std::string nearest = nearest_name(name, names);
    fail(
        "{}: this needs a line 'variable {} index VALUE' whose ${{{}}} the script uses.{} "
        "inputs/spouted_bed_small/in.liggghts shows all of them.",
        script_path(), name, name,
        nearest.empty() ? "" : fmt::format(" There is \"{}\".", nearest));
  }
  const auto parts = parsed_variable(script_[n]);
  std::string value = script_[n].substr(parts.value_begin, parts.value_end - parts.value_begin);
  if (value.size() >= 2 && (value.front() == '"' || value.front() == '\'') &&
      value.back() == value.front())
    value = value.substr(1, value.size() - 2);
  return value;
}

void SceneCopy::set_variable(const std::string& name, const std::string& value) {
  static_cast<void>(variable(name));  // an error when there is none
  std::string& line = script_[variable_line(name)];
  const auto parts = parsed_variable(line);
  const bool quotes = value.empty() || value.find(' ') != std::string::npos;
  line.replace(parts.value_begin, parts.value_end - parts.value_begin,
               quotes ? '"' + value + '"' : value);
}

void SceneCopy::replace_in_script(int line, const std::string& text, const std::string& by) {
  const auto n = static_cast<std::size_t>(line - 1);
  const std::size_t place = n < script_.size() ? script_[n].find(text) : std::string::npos;
  if (place == std::string::npos)
    fail("{}:{}: there is no \"{}\" to be replaced.", script_path(), line, text);
  script_[n].replace(place, text.size(), by);
}

toml::table SceneCopy::gas_table() const {
  try {
    return toml::parse(joined(gas_));
  } catch (const toml::parse_error& e) {
    fail("{}:{}: {}", gas_path(), e.source().begin.line, e.description());
  }
}

void SceneCopy::set_gas_key(const std::string& key, const std::string& value) {
  const auto dot = key.rfind('.');
  const std::string table = key.substr(0, dot);
  const std::string name = key.substr(dot + 1);
  const toml::table whole = gas_table();
  if (const auto node = whole.at_path(key)) {
    const toml::source_region& place = node.node()->source();
    const std::size_t first = place.begin.line - 1;
    const std::size_t last = place.end.line - 1;
    const std::string before = gas_[first].substr(0, place.begin.column - 1);
    const std::string after = gas_[last].substr(place.end.column - 1);
    gas_.erase(gas_.begin() + static_cast<long>(first), gas_.begin() + static_cast<long>(last));
    gas_[first] = before + value + after;
  } else if (const auto home = whole.at_path(table)) {
    const auto row = static_cast<long>(home.node()->source().begin.line);
    gas_.insert(gas_.begin() + row, name + " = " + value);
  } else {
    gas_.insert(gas_.end(), {"", "[" + table + "]", name + " = " + value});
  }
}

bool SceneCopy::has_gas_key(const std::string& key) const {
  return static_cast<bool>(gas_table().at_path(key));
}

void SceneCopy::remove_gas_table(const std::string& name) {
  const auto begins_table = [](const std::string& line) {
    return line.substr(0, line.find_first_not_of(" \t") + 1).find('[') != std::string::npos;
  };
  const toml::table whole = gas_table();
  const auto table = whole.at_path(name);
  if (!table) return;
  const auto first = gas_.begin() + static_cast<long>(table.node()->source().begin.line) - 1;
  gas_.erase(first, std::find_if(first + 1, gas_.end(), begins_table));
}

std::vector<double> SceneCopy::gas_numbers(const std::string& key) const {
  const toml::table whole = gas_table();
  const auto node = whole.at_path(key);
  std::vector<double> numbers;
  if (const auto one = node.value<double>()) numbers.push_back(*one);
  if (const toml::array* list = node.as_array())
    for (const auto& element : *list) numbers.push_back(element.value<double>().value_or(0.0));
  return numbers;
}

std::string SceneCopy::text() const {
  return joined(script_) + joined(gas_);
}

void SceneCopy::write() const {
  write_lines(folder_ / "in.liggghts", script_);
  write_lines(folder_ / "gas.toml", gas_);
}

}  // namespace gasgrain
