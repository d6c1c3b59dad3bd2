#include "fix_cfd_coupling/dem_physics/contact/contact_words.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "fix_cfd_coupling/dem_physics/contact/contact_stacks.h"

namespace gasgrain::contact {
namespace {

std::optional<double> as_number(const std::string& word) {
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc{} || at != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

// Takes the values that a script gives to the words of the laws.
class GivenWords : public LawWords {
 public:
  void number(const char* word, double& value, double otherwise) override {
    value = otherwise;
    setters_[word].push_back([this, word, &value](const std::string& text) {
      const auto number = as_number(text);
      if (number)
        value = *number;
      else
        fault(fmt::format("{} needs a number, not \"{}\".", word, text));
    });
  }
  void on_off(const char* word, bool& value, bool otherwise) override {
    value = otherwise;
    setters_[word].push_back([this, word, &value](const std::string& text) {
      if (text == "on" || text == "off")
        value = text == "on";
      else
        fault(fmt::format("{} is on or off, not \"{}\".", word, text));
    });
  }
  void set(const std::string& word, const std::string& text) {
    const auto at = setters_.find(word);
    if (at != setters_.end()) {
      for (const auto& setter : at->second) setter(text);
      return;
    }
    std::vector<std::string> known;
    for (const auto& [name, setters] : setters_) known.push_back(name);
    fault(fmt::format("the word \"{}\" is unknown to these models.{}", word,
                      known.empty() ? " They have no words." : suggestion(word, known)));
  }
  void fault(const std::string& text) { faults_ += "\n" + text; }
  void throw_faults() const {
    if (!faults_.empty()) throw Error(faults_.substr(1));
  }

 private:
  std::map<std::string, std::vector<std::function<void(const std::string&)>>> setters_;
  std::string faults_;
};

using Words = std::vector<std::string>;
using WordPairs = std::vector<std::pair<std::string, std::string>>;

bool is_lammps_law(const std::string& word) {
  return word == "hertz/history" || word == "hooke/history";
}

// Kn Kt gamma_n gamma_t xmu dampflag [limit_damping]; returns where they end.
std::size_t read_lammps_law(const Words& words, ContactChoice& choice, WordPairs& pairs) {
  const std::string& law = words[0];
  choice.name.normal = law == "hertz/history" ? "hertz/stiffness" : "hooke/stiffness";
  choice.name.tangential = "damped_history";
  if (words.size() < 7)
    fail("{} needs Kn Kt gamma_n gamma_t xmu dampflag, and has {} words.", law, words.size() - 1);
  double values[6] = {};
  std::string faults;
  const char* names[] = {"Kn", "Kt", "gamma_n", "gamma_t", "xmu", "dampflag"};
  for (int n = 0; n < 6; ++n) {
    const std::string& word = words[n + 1];
    const auto number = as_number(word);
    if (word == "NULL" && (n == 1 || n == 3))
      values[n] = n == 1 ? values[0] * 2.0 / 7.0 : 0.5 * values[2];
    else if (!number || *number < 0.0 || (n == 5 && *number != 0.0 && *number != 1.0))
      faults += fmt::format("\n{} of {} is \"{}\"; allowed: {}.", names[n], law, word,
                            n == 5 ? "0 or 1" : "a number from 0");
    else
      values[n] = *number;
  }
  if (!faults.empty()) throw Error(faults.substr(1));
  choice.properties = {{"kn", values[0]},
                       {"kt", values[1]},
                       {"gamman", values[2]},
                       {"gammat", values[3]},
                       {"coefficientFriction", values[4]}};
  if (values[5] == 0.0) pairs.emplace_back("tangential_damping", "off");
  if (words.size() > 7 && words[7] == "limit_damping") {
    pairs.emplace_back("limitForce", "on");
    return 8;
  }
  return 7;
}

}  // namespace

ContactChoice read_contact(const Words& words, bool of_wall) {
  ContactChoice choice;
  WordPairs pairs;
  if (words.empty())
    fail(
        "it needs a contact: 'model hertz tangential history', or 'hertz/history Kn Kt gamma_n "
        "gamma_t xmu dampflag'.");
  std::size_t at = is_lammps_law(words[0]) ? read_lammps_law(words, choice, pairs) : 0;
  const bool of_lammps = at > 0;
  for (; at < words.size(); at += 2) {
    const std::string& word = words[at];
    if (at + 1 == words.size()) fail("\"{}\" has no value after it.", word);
    const std::string& value = words[at + 1];
    if (!of_lammps && word == "model")
      choice.name.normal = value;
    else if (!of_lammps && word == "tangential")
      choice.name.tangential = value;
    else if (!of_lammps && word == "rolling_friction")
      choice.name.rolling = value;
    else if (word == "cohesion")
      choice.name.cohesion = value;
    else if (word == "surface") {
      if (value != "default") fail("surface \"{}\" is unknown. Known: default.", value);
    } else
      pairs.emplace_back(word, value);
  }
  if (choice.name.normal.empty())
    fail(
        "it begins with a contact, not with \"{}\": 'model NAME tangential NAME', or "
        "'hertz/history Kn Kt gamma_n gamma_t xmu dampflag'.",
        words[0]);
  if (choice.name.tangential.empty())
    fail("it needs 'tangential NAME' beside 'model {}'. Known: history, no_history.",
         choice.name.normal);
  choice.stack = ContactStacks::known().make(choice.name, of_wall);
  GivenWords given;
  choice.stack->words(given);
  for (const auto& [word, value] : pairs) given.set(word, value);
  given.throw_faults();
  return choice;
}

}  // namespace gasgrain::contact
