#include "coupling/exchange/effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "coupling/base/error.h"
#include "coupling/base/listed.h"

namespace gasgrain {
namespace {

const std::string drag_word = "drag";
const std::string method_word = "void_fraction";
const std::string sharing_word = "momentum_sharing";
const std::string polydisperse_word = "polydisperse";
const std::string self_word = "self_disturbance";
const std::string factor_word = "drag_factor";
const ForceParameter factor{"drag_factor", 1, "1", 1e-3, 1e3};

// Whether the gas velocity that a particle sees is corrected for what the particle did to it.
struct SelfUndone {
  static constexpr std::string_view name = "undone";
};
struct SelfIgnored {
  static constexpr std::string_view name = "ignored";
};
using SelfChoice = std::variant<SelfUndone, SelfIgnored>;

class EffectsParser {
 public:
  EffectsParser(const std::vector<std::string>& words, const std::string& where)
      : words_(words), where_(where) {}

  Effects parse() {
    while (next_ < words_.size()) {
      const std::string word = words_[next_++];
      if (word == drag_word)
        read_choice<DragModel>(word, [&](const DragModel& model) { effects_.drag = model; });
      else if (word == method_word)
        read_void_fraction(word);
      else if (word == sharing_word)
        read_choice<MomentumSharing>(
            word, [&](const MomentumSharing& sharing) { effects_.sharing = sharing; });
      else if (word == polydisperse_word)
        effects_.polydisperse = is_new(word);
      else if (word == factor_word)
        read_factor(word);
      else if (word == self_word)
        read_choice<SelfChoice>(word, [&](const SelfChoice& choice) {
          effects_.ignore_self_disturbance = std::holds_alternative<SelfIgnored>(choice);
        });
      else
        read_force(word);
    }
    if (!effects_.drag)
      for (const std::string& word : {polydisperse_word, sharing_word, self_word, factor_word})
        if (std::find(seen_.begin(), seen_.end(), word) != seen_.end())
          fault("\"{}\" changes drag, and there is none. Add \"drag NAME\", or remove it.", word);
    if (!faults_.empty()) throw Error(fmt::format("{}", fmt::join(faults_, "\n")));
    return effects_;
  }

 private:
  template <class... Args>
  void fault(fmt::format_string<Args...> text, Args&&... args) {
    faults_.push_back(where_ + ": " + fmt::format(text, std::forward<Args>(args)...));
  }

  bool is_new(const std::string& word) {
    if (std::find(seen_.begin(), seen_.end(), word) != seen_.end()) {
      fault("\"{}\" is named twice. Remove one of them.", word);
      return false;
    }
    seen_.push_back(word);
    return true;
  }

  void read_force(const std::string& word) {
    const auto force = choice_named<Force>(word);
    if (!force)
      fault("the effect \"{}\" is unknown.{}", word, suggestion(word, effect_words()));
    else {
      Force named = *force;
      std::visit(
          [&](auto& chosen) {
            if constexpr (HasParameters<std::decay_t<decltype(chosen)>>::value)
              read_parameters(word, chosen);
          },
          named);
      if (is_new(word)) effects_.forces.push_back(named);
    }
  }

  void read_factor(const std::string& word) {
    if (is_new(word)) read_number("the word", factor, effects_.drag_factor);
  }

  // Pairs of a parameter's name and its numbers, in any order, up to a word that is no parameter.
  template <class Chosen>
  void read_parameters(const std::string& force, Chosen& chosen) {
    while (next_ < words_.size()) {
      std::size_t n = 0;
      while (n < Chosen::parameters.size() && words_[next_] != Chosen::parameters[n].name) ++n;
      if (n == Chosen::parameters.size()) return;
      ++next_;
      for (int k = 0; k < Chosen::parameters[n].values; ++k)
        if (!read_number(force, Chosen::parameters[n], chosen.values(n)[k])) return;
    }
  }

  bool read_number(const std::string& force, const ForceParameter& parameter, double& value) {
    const std::string word = next_ < words_.size() ? words_[next_] : "";
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    const bool is_number = !word.empty() && *end == '\0' && std::isfinite(number);
    if (is_number) ++next_;
    if (is_number && number >= parameter.least && number <= parameter.most) {
      value = number;
      return true;
    }
    fault("{} {} must be followed by {} number(s) in {}{}, found \"{}\".", force, parameter.name,
          parameter.values, parameter.unit,
          std::isfinite(parameter.least)
              ? fmt::format(" from {:g} to {:g}", parameter.least, parameter.most)
              : "",
          word);
    return false;
  }

  void read_void_fraction(const std::string& word) {
    const MethodWords read = read_method(words_, next_, effect_words());
    next_ += read.taken;
    if (!read.named)
      fault("{}", read.fault);
    else if (is_new(word)) {
      effects_.method = read.named->method;
      effects_.choose_method = read.named->automatic;
    }
  }

  template <class List, class Store>
  void read_choice(const std::string& word, Store&& store) {
    const auto names = choice_names<List>();
    const auto known = effect_words();
    const bool missing = next_ == words_.size() ||
                         std::find(known.begin(), known.end(), words_[next_]) != known.end();
    if (missing) {
      fault("\"{}\" must be followed by one of: {}.", word, fmt::join(names, ", "));
      return;
    }
    const std::string& value = words_[next_++];
    const auto choice = choice_named<List>(value);
    if (!choice) {
      fault("{} \"{}\" is unknown.{}", word, value, suggestion(value, names));
      return;
    }
    if (is_new(word)) store(*choice);
  }

  const std::vector<std::string>& words_;
  const std::string& where_;
  std::size_t next_ = 0;
  std::vector<std::string> seen_;
  std::vector<std::string> faults_;
  Effects effects_;
};

}  // namespace

FieldSet Effects::lent() const {
  FieldSet fields;
  if (drag) fields.add(GasField::void_fraction).add(GasField::velocity);
  if (drag && by_mean_velocity()) fields.add(GasField::solids_velocity);
  if (drag && polydisperse) fields.add(GasField::sauter_diameter);
  for (const auto& force : forces)
    fields = fields.united(std::visit([](const auto& chosen) { return chosen.lent(); }, force));
  return fields;
}

FieldSet Effects::taken() const {
  FieldSet fields = FieldSet().add(GasField::solid_volume);
  if (drag) fields.add(GasField::drag_coefficient);
  if (drag && by_mean_velocity()) fields.add(GasField::solid_flux);
  if (drag && polydisperse) fields.add(GasField::solid_surface);
  if (any_reacts()) fields.add(GasField::drag_source);
  return fields;
}

std::vector<std::string> Effects::names() const {
  std::vector<std::string> list;
  if (drag) list.push_back(drag_word);
  for (const auto& force : forces) list.emplace_back(name_of(force));
  return list;
}

bool Effects::any_reacts() const {
  return drag || std::any_of(forces.begin(), forces.end(), [](const Force& force) {
           return std::visit([](const auto& chosen) { return chosen.reacts; }, force);
         });
}

bool Effects::by_mean_velocity() const {
  return std::visit([](auto scheme) { return scheme.by_mean_velocity; }, sharing);
}

bool Effects::own_drag() const {
  return std::visit([](auto scheme) { return scheme.own_drag; }, sharing);
}

RecordLayout Effects::layout(bool overlapped) const {
  RecordLayout layout;
  bool steady_reacts = drag && !own_drag();
  for (const auto& force : forces)
    std::visit(
        [&](const auto& chosen) {
          steady_reacts |= chosen.kind == ForceKind::steady && chosen.reacts;
        },
        force);
  if (steady_reacts) layout.reaction = layout.add(3);
  if (lent().has(GasField::vorticity)) layout.vorticity = layout.add(3);
  if (lent().has(GasField::acceleration)) layout.acceleration = layout.add(3);
  if (drag && by_mean_velocity()) {
    layout.mean_coefficient = layout.add(1);
    layout.mean_velocity = layout.add(3);
  }
  for (const auto& force : forces)
    if (const auto* basset = chosen_as<ForceBasset>(force))
      layout.history = layout.add(static_cast<int>(basset->memory(1.0).state_size()));
  if (overlapped) {
    layout.position = layout.add(3);
    layout.velocity = layout.add(3);
  }
  return layout;
}

std::string Effects::text() const {
  std::string words = method_word + " " + NamedMethod{method, choose_method}.text();
  if (drag) words += fmt::format(" {} {}", drag_word, name_of(*drag));
  if (drag && drag_factor != 1.0) words += fmt::format(" {} {}", factor_word, drag_factor);
  if (drag && polydisperse) words += " " + polydisperse_word;
  if (drag && by_mean_velocity()) words += fmt::format(" {} {}", sharing_word, name_of(sharing));
  if (drag && ignore_self_disturbance) words += fmt::format(" {} {}", self_word, SelfIgnored::name);
  for (Force force : forces) {
    words += " " + std::string(name_of(force));
    std::visit(
        [&](auto& chosen) {
          using Chosen = std::decay_t<decltype(chosen)>;
          if constexpr (HasParameters<Chosen>::value)
            for (std::size_t n = 0; n < Chosen::parameters.size(); ++n) {
              words += fmt::format(" {}", Chosen::parameters[n].name);
              for (int k = 0; k < Chosen::parameters[n].values; ++k)
                words += fmt::format(" {}", chosen.values(n)[k]);
            }
        },
        force);
  }
  return words;
}

std::vector<std::string> effect_words() {
  std::vector<std::string> words = choice_names<Force>();
  words.insert(words.begin(),
               {drag_word, method_word, sharing_word, self_word, polydisperse_word, factor_word});
  return words;
}

Effects parse_effects(const std::vector<std::string>& words, const std::string& where) {
  return EffectsParser(words, where).parse();
}

}  // namespace gasgrain
