#include "tools/script_edit.h"

#include <algorithm>

#include "coupling/base/error.h"

namespace gasgrain {

std::string variable_in(const std::string& word) {
  if (word.size() > 3 && word.compare(0, 2, "${") == 0 && word.back() == '}')
    return word.substr(2, word.size() - 3);
  return word.size() == 2 && word[0] == '$' ? word.substr(1) : "";
}

std::string raw_after(const ScriptCommand& command, const std::string& key) {
  const auto raw = script_words(command.text);
  const auto found = std::find(raw.begin(), raw.end(), key);
  return found == raw.end() || found + 1 == raw.end() ? "" : *(found + 1);
}

void ScriptEdit::tell(const std::string& what, const std::string& from, const std::string& to) {
  told_.push_back(fmt::format("{}: {} -> {}", what, from, to.empty() ? "nothing" : to));
}

void ScriptEdit::by_hand(const std::string& what, const std::string& how) {
  told_.push_back(fmt::format("not put in: {}. {}", what, how));
}

bool ScriptEdit::put(const ScriptCommand& where, const std::string& raw, const std::string& value) {
  const std::string name = variable_in(raw);
  if (!name.empty()) return put_variable(name, value);
  if (raw.empty() || where.file != copy_.script_path()) return false;
  for (int line = where.line; line <= where.last_line; ++line) {
    try {
      copy_.replace_in_script(line, raw, value);
    } catch (const Error&) {
      continue;  // it is on another of the command's lines
    }
    tell(fmt::format("in.liggghts:{}", line), raw, value);
    return true;
  }
  return false;
}

bool ScriptEdit::put_after(const ScriptCommand& where, const std::string& key,
                           const std::string& value) {
  const std::string raw = raw_after(where, key);
  if (!variable_in(raw).empty()) return put(where, raw, value);
  // With its key, as the word alone may stand elsewhere in the line too.
  const std::string both = key + " " + raw;
  return !raw.empty() && where.text.find(both) != std::string::npos
             ? put(where, both, key + " " + value)
             : put(where, raw, value);
}

bool ScriptEdit::put_variable(const std::string& name, const std::string& value) {
  if (!copy_.has_variable(name)) return false;
  tell("variable " + name, copy_.variable(name), value);
  copy_.set_variable(name, value);
  return true;
}

bool ScriptEdit::append(const ScriptCommand& where, const std::string& words) {
  const std::string last = script_words(where.text).back();
  const std::string name = variable_in(last);
  if (name.empty()) return put(where, last, last + " " + words);
  return copy_.has_variable(name) && put_variable(name, copy_.variable(name) + " " + words);
}

bool ScriptEdit::remove(const ScriptCommand& where, const std::string& words) {
  for (const std::string& raw : script_words(where.text)) {
    const std::string name = variable_in(raw);
    if (name.empty() || !copy_.has_variable(name)) continue;
    std::string value = copy_.variable(name);
    const auto place = value.find(words);
    if (place == std::string::npos) continue;
    value.erase(place, words.size());
    const auto blanks = value.find("  ");
    if (blanks != std::string::npos) value.erase(blanks, 1);
    while (value.size() > 1 && value.back() == ' ') value.pop_back();
    return put_variable(name, value);
  }
  return put(where, words, "");
}

}  // namespace gasgrain
