#include "coupling/base/word_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gasgrain {

std::optional<double> WordReader::as_number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return std::nullopt;
  return value;
}

void WordReader::read_keywords(const Keywords& keywords) {
  std::vector<std::string> names;
  for (const auto& [name, action] : keywords) names.push_back(name);
  while (at_ < words_.size()) {
    const std::string word = words_[at_++];
    if (const auto found = keywords.find(word); found != keywords.end()) {
      met_.push_back(word);
      found->second();
    } else {
      fault("\"{}\" is no keyword.{}", word, suggestion(word, names));
    }
  }
}

void WordReader::throw_faults(std::string_view who) const {
  if (faults_.empty()) return;
  std::string text = fmt::format("{} cannot be used:", who);
  for (const std::string& one : faults_) text += "\n  " + one;
  throw Error(text);
}

std::optional<std::string> WordReader::word(std::string_view key, std::string_view what) {
  if (at_ < words_.size()) return words_[at_++];
  fault("{}: its value is missing: {}.", key, what);
  return std::nullopt;
}

double WordReader::number(std::string_view key, double low, double high, std::string_view what) {
  const auto text = word(key, what);
  if (!text) return 0.0;
  const auto value = as_number(*text);
  if (!value) {
    fault("{} {}: must be a number ({}).", key, *text, what);
    return 0.0;
  }
  if (!(*value >= low && *value <= high))
    fault("{} {}: must be from {} to {} ({}).", key, *text, low, high, what);
  return *value;
}

int WordReader::whole(std::string_view key, int least, std::string_view what) {
  const double value = number(key, least, 1e9, what);
  if (value != std::floor(value)) fault("{} {}: must be a whole number.", key, value);
  return static_cast<int>(value);
}

std::vector<double> WordReader::numbers() {
  std::vector<double> list;
  while (number_follows()) list.push_back(*as_number(words_[at_++]));
  return list;
}

bool WordReader::number_follows() const {
  return at_ < words_.size() && as_number(words_[at_]).has_value();
}

bool WordReader::take(std::string_view expected) {
  if (at_ >= words_.size() || words_[at_] != expected) return false;
  ++at_;
  return true;
}

bool WordReader::named(std::string_view key) const {
  return std::find(met_.begin(), met_.end(), key) != met_.end();
}

}  // namespace gasgrain
