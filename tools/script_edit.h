// Edits of a scene's script by what its words mean: a word, or the variable that stands there, gets
// another value. Each edit is told as a line for people.
#pragma once

#include <string>
#include <vector>

#include "tools/dem_script.h"
#include "tools/scene_copy.h"

namespace gasgrain {

class ScriptEdit {
 public:
  explicit ScriptEdit(SceneCopy& copy) : copy_(copy) {}

  // Replaces a word of a command as it is written: itself, in the lines of the command, or the
  // value of the variable `${name}` it is. False where it is neither: in an included file, or a
  // formula.
  bool put(const ScriptCommand& where, const std::string& raw, const std::string& value);
  // The same of the word after `key`.
  bool put_after(const ScriptCommand& where, const std::string& key, const std::string& value);
  bool put_variable(const std::string& name, const std::string& value);
  // Adds words at the end of a command, or of the variable that ends it.
  bool append(const ScriptCommand& where, const std::string& words);
  // Takes out words that follow each other in a command, or in a variable of it.
  bool remove(const ScriptCommand& where, const std::string& words);

  void tell(const std::string& what, const std::string& from, const std::string& to);
  void by_hand(const std::string& what, const std::string& how);
  [[nodiscard]] const std::vector<std::string>& told() const { return told_; }

 private:
  SceneCopy& copy_;
  std::vector<std::string> told_;
};

// The name in "${name}" or "$x"; empty when a word is something else.
std::string variable_in(const std::string& word);
// The word after `key` as it is written; empty when there is none.
std::string raw_after(const ScriptCommand& command, const std::string& key);

}  // namespace gasgrain
