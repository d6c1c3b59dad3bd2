#include "tools/dem_script.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <set>

#include "coupling/base/error.h"
#include "tools/dem_formula.h"

namespace gasgrain {

namespace fs = std::filesystem;

namespace {

constexpr int deepest = 8;  // includes within includes: a script may include itself

bool is_quote(char c) {
  return c == '"' || c == '\'';
}

// Without its comment: from a # that is not within quotes.
std::string without_comment(const std::string& line) {
  char open = '\0';
  for (std::size_t n = 0; n < line.size(); ++n) {
    const char c = line[n];
    if (open != '\0')
      open = c == open ? '\0' : open;
    else if (is_quote(c))
      open = c;
    else if (c == '#')
      return line.substr(0, n);
  }
  return line;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::string ScriptCommand::place() const {
  return fmt::format("{}:{}", file, line);
}

std::string ScriptCommand::after(const std::string& key, std::size_t from) const {
  for (std::size_t n = from; n + 1 < words.size(); ++n)
    if (words[n] == key) return words[n + 1];
  return "";
}

std::vector<std::string> script_words(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t n = 0; n < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[n])) != 0) {
      ++n;
    } else if (is_quote(text[n])) {
      const auto end = std::min(text.find(text[n], n + 1), text.size());
      words.push_back(text.substr(n + 1, end - n - 1));
      n = end + 1;
    } else {
      const auto end = std::min(text.find_first_of(" \t\r", n), text.size());
      words.push_back(text.substr(n, end - n));
      n = end;
    }
  }
  return words;
}

DemScript::DemScript(const fs::path& script,
                     const std::vector<std::pair<std::string, std::string>>& given) {
  for (const auto& [name, text] : given) variables_[name] = {"index", text, "--var", 0};
  read(script, "", 0);
}

std::vector<DemScript::Line> DemScript::lines_of(const fs::path& script, const std::string& from) {
  std::ifstream stream(script);
  if (!stream || fs::is_directory(script))
    fail("{}{} is absent or cannot be read.", from, script.string());
  std::vector<Line> lines;
  Line open;
  int number = 0;
  for (std::string raw; std::getline(stream, raw);) {
    ++number;
    if (open.first == 0) open.first = number;
    open.last = number;
    const std::string text = trimmed(without_comment(raw));
    const bool continued = !text.empty() && text.back() == '&';
    open.text += continued ? text.substr(0, text.size() - 1) : text;
    if (continued) continue;
    if (!open.text.empty()) lines.push_back(open);
    open = Line{};
  }
  if (!open.text.empty()) lines.push_back(open);
  return lines;
}

void DemScript::read(const fs::path& script, const std::string& from, int depth) {
  if (depth > deepest)
    fail("{}{} includes itself, or files are included more than {} deep.", from, script.string(),
         deepest);
  const std::vector<Line> lines = lines_of(script, from);
  std::string label;  // being looked for
  Line jump;          // where
  std::set<std::string> passed;
  for (const Line& line : lines) {
    if (ended_) return;
    const auto words = script_words(line.text);
    if (words.size() > 1 && words[0] == "label") {
      passed.insert(words[1]);
      if (words[1] == label) label.clear();
      continue;
    }
    if (!label.empty()) continue;
    run(script.string(), line, script.parent_path(), label, depth);
    if (label.empty()) continue;
    if (passed.count(label) > 0)
      label.clear();  // back: the end of a loop
    else
      jump = line;
  }
  if (!label.empty())
    fail("{}:{}: there is no 'label {}' to jump to.", script.string(), jump.first, label);
}

void DemScript::run(const std::string& file, const Line& line, const fs::path& folder,
                    std::string& label, int depth) {
  ScriptCommand command{file, line.first, line.last, line.text, {}};
  try {
    command.words = script_words(substituted(line.text));
    if (command.words.empty()) return;
    const std::string& verb = command.words[0];
    const auto needs = [&](std::size_t count, const char* usage) {
      if (command.words.size() < count) fail("{} needs more words: {}", verb, usage);
    };
    if (verb == "variable") {
      needs(4, "variable NAME index VALUE");
      return set_variable(command);
    }
    if (verb == "jump") {
      needs(2, "jump SELF LABEL");
      if (command.words[1] != "SELF")
        fail("a jump to another file, {}, cannot be followed. Use 'include' instead.",
             command.words[1]);
      if (command.words.size() > 2) label = command.words[2];
      return;
    }
    if (verb == "quit") {
      ended_ = true;
      return;
    }
    if (verb == "if") {
      for (const std::string& text : chosen(command)) {
        if (!label.empty() || ended_) return;
        run(file, {line.first, line.last, text}, folder, label, depth);
      }
      return;
    }
  } catch (const Error& e) {
    // An error of an inner command, of an `if`, has its place already.
    const std::string place = command.place() + ": ";
    const std::string what = e.what();
    throw Error(what.rfind(place, 0) == 0 ? what : place + what);
  }
  if (command.words[0] == "include") {
    if (command.words.size() < 2) fail("{}: include needs a file.", command.place());
    return read(folder / command.words[1], command.place() + ": ", depth + 1);
  }
  commands_.push_back(std::move(command));
}

void DemScript::set_variable(const ScriptCommand& command) {
  const std::string& name = command.words[1];
  const std::string& style = command.words[2];
  if (style == "delete") {
    variables_.erase(name);
    return;
  }
  const bool fixed = style == "index" || style == "string" || style == "loop";
  if (style == "index" && variables_.count(name) > 0) return;  // keeps what it has
  std::string text = command.words[3];
  if (style == "loop") text = "1";
  if (style == "equal")
    for (std::size_t n = 4; n < command.words.size(); ++n) text += command.words[n];
  variables_[name] = {fixed ? "index" : style, text, command.file, command.line};
}

double DemScript::formula(const std::string& text) const {
  static const std::regex reference("v_([A-Za-z0-9_]+)");
  std::string numbers;
  std::size_t done = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), reference), end; match != end;
       ++match) {
    numbers += text.substr(done, match->position() - done) + "(" + value((*match)[1]) + ")";
    done = match->position() + match->length();
  }
  return formula_value(numbers + text.substr(done));
}

std::string DemScript::value(const std::string& name) const {
  const auto found = variables_.find(name);
  if (found == variables_.end()) {
    std::vector<std::string> names;
    for (const auto& [known, variable] : variables_) names.push_back(known);
    const std::string nearest = nearest_name(name, names);
    fail("the variable \"{0}\" is not set.{1} Add 'variable {0} index VALUE' above.", name,
         nearest.empty() ? "" : fmt::format(" Did you mean \"{}\"?", nearest));
  }
  const ScriptVariable& variable = found->second;
  if (variable.style == "index") return variable.value;
  if (variable.style == "equal") {
    constexpr int digits = 15;  // as many as the host puts in
    return fmt::format("{:.{}g}", formula(variable.value), digits);
  }
  fail("the variable \"{}\" is of the style {}, whose value only a run knows. Use index or equal.",
       name, variable.style);
}

std::string DemScript::substituted(const std::string& text) const {
  std::string result;
  char open = '\0';
  for (std::size_t n = 0; n < text.size(); ++n) {
    const char c = text[n];
    if (open != '\0' ? c == open : is_quote(c)) open = open != '\0' ? '\0' : c;
    if (c != '$' || open != '\0' || n + 1 == text.size()) {
      result += c;
    } else if (text[n + 1] == '{') {
      const auto end = text.find('}', n);
      if (end == std::string::npos) fail("\"${{\" has no \"}}\".");
      result += value(text.substr(n + 2, end - n - 2));
      n = end;
    } else {
      result += value(text.substr(n + 1, 1));
      ++n;
    }
  }
  return result;
}

// if "condition" then "command" ... [elif "condition" "command" ...] [else "command" ...]
std::vector<std::string> DemScript::chosen(const ScriptCommand& command) const {
  const auto& words = command.words;
  const auto holds = [&](std::size_t n) {
    if (n >= words.size()) fail("'if' has no condition there.");
    std::string condition = words[n];
    // Quotes keep their variables from being put in with the line's.
    std::replace_if(condition.begin(), condition.end(), is_quote, ' ');
    return formula(substituted(condition)) != 0.0;
  };
  std::vector<std::string> commands;
  if (words.size() < 4 || words[2] != "then")
    fail("'if' reads: if \"condition\" then \"command\".");
  bool taken = holds(1);
  for (std::size_t n = 3; n < words.size(); ++n) {
    if (words[n] == "elif" || words[n] == "else") {
      if (taken) break;
      taken = words[n] == "else" || holds(++n);
    } else if (taken) {
      commands.push_back(words[n]);
    }
  }
  return commands;
}

}  // namespace gasgrain
