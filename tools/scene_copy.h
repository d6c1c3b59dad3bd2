// A copy of a scene's folder with some of its dials turned: a scene like any other, to be run, read
// and changed by hand. Comments stay; the scene itself is never touched.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toml {
inline namespace v3 {
class table;
}  // namespace v3
}  // namespace toml

namespace gasgrain {

class SceneCopy {
 public:
  // Copies the files of the scene, links as what they point to, into `folder`, which is made. An
  // earlier copy there is replaced. Throws Error when `folder` is the scene.
  SceneCopy(const std::filesystem::path& scene, std::filesystem::path folder);

  // The value of a `variable NAME index VALUE` line of in.liggghts. Throws an Error that names the
  // line to add and the nearest variable when the scene has none of this name.
  void set_variable(const std::string& name, const std::string& value);
  // The words after `index` of that line, without quotes.
  [[nodiscard]] std::string variable(const std::string& name) const;
  [[nodiscard]] bool has_variable(const std::string& name) const;

  // Replaces text of the script's line of this number, from 1 on, where it occurs first. Throws
  // Error where it does not occur.
  void replace_in_script(int line, const std::string& text, const std::string& by);

  // A key of a table of gas.toml, "grid.cells": its value is replaced, or the key is added, with
  // its table where that is absent. `value` is TOML text.
  void set_gas_key(const std::string& key, const std::string& value);
  // Takes a table of gas.toml out, up to the next one.
  void remove_gas_table(const std::string& name);
  [[nodiscard]] bool has_gas_key(const std::string& key) const;
  // The numbers of a key's value, a number or a list of them; none where the key is absent.
  [[nodiscard]] std::vector<double> gas_numbers(const std::string& key) const;

  // Writes both files.
  void write() const;
  // Both files in one text: what tells two copies apart.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  // Where the script and the input of the scene are, for messages.
  [[nodiscard]] std::string script_path() const { return (scene_ / "in.liggghts").string(); }
  [[nodiscard]] std::string gas_path() const { return (scene_ / "gas.toml").string(); }

 private:
  [[nodiscard]] toml::table gas_table() const;
  [[nodiscard]] std::size_t variable_line(const std::string& name) const;

  std::filesystem::path scene_;
  std::filesystem::path folder_;
  std::vector<std::string> script_;  // lines
  std::vector<std::string> gas_;
};

}  // namespace gasgrain
