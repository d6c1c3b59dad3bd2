#include "coupling/base/toml_input.h"

#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>

#include "coupling/base/error.h"

namespace gasgrain {

struct TomlInput::Document {
  toml::table table;
};

TomlInput::TomlInput() : document_(std::make_unique<Document>()), describes_(true) {}

TomlInput::TomlInput(const std::string& file)
    : file_(file), document_(std::make_unique<Document>()) {
  try {
    document_->table = toml::parse_file(file);
  } catch (const toml::parse_error& e) {
    const auto line = e.source().begin.line;
    if (line == 0) fail("{}: cannot be read: {}.", file, e.description());
    fail("{}:{}: this is not TOML: {}.", file, line, e.description());
  }
}

TomlInput::~TomlInput() = default;

InputTable TomlInput::root() {
  return {this, &document_->table, "", "", 1};
}

std::string TomlInput::key_table(const std::function<void(InputTable root)>& read) {
  TomlInput input;
  read(input.root());
  return markdown_of(input.known_);
}

void TomlInput::remember(InputKey key) {
  const auto is_it = [&](const InputKey& known) { return known.path == key.path; };
  if (std::none_of(known_.begin(), known_.end(), is_it)) known_.push_back(std::move(key));
}

std::vector<std::string> TomlInput::known_in(const std::string& path) const {
  const std::string before = path.empty() ? "" : path + ".";
  std::vector<std::string> names;
  for (const InputKey& known : known_)
    if (known.path.size() == before.size() + known.key.size() &&
        known.path.compare(0, before.size(), before) == 0)
      names.push_back(known.key);
  return names;
}

void TomlInput::find_unknown(const toml::table& table, const std::string& path) {
  const std::vector<std::string> names = known_in(path);
  for (const auto& [key, node] : table) {
    const std::string word(key.str());
    const std::string name = path.empty() ? word : fmt::format("{}.{}", path, word);
    if (std::find(names.begin(), names.end(), word) == names.end()) {
      faults_.emplace_back(node.source().begin.line,
                           fmt::format("the key {} is unknown.{}", name, suggestion(word, names)));
      continue;
    }
    if (const auto* inner = node.as_table()) find_unknown(*inner, name);
    if (const auto* list = node.as_array())
      for (const auto& element : *list)
        if (const auto* inner = element.as_table()) find_unknown(*inner, name);
  }
}

void TomlInput::finish() {
  find_unknown(document_->table, "");
  if (faults_.empty()) return;
  std::stable_sort(faults_.begin(), faults_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string message;
  for (const auto& [line, text] : faults_)
    message += fmt::format("{}{}:{}: {}", message.empty() ? "" : "\n", file_, line, text);
  throw Error(message);
}

}  // namespace gasgrain
