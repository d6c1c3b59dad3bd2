// What LISTs share. A LIST is a std::variant whose alternatives are small
// structs with a `name`; a choice is made once by name and visited outside of the loops.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gasgrain {

namespace detail {

template <class List>
struct ChoiceVisitor;

template <class... Choices>
struct ChoiceVisitor<std::variant<Choices...>> {
  template <class F>
  static void apply(F&& f) {
    (f(Choices{}), ...);
  }
};

}  // namespace detail

// Calls f with a default-made object of every listed type, in the order of the LIST.
template <class List, class F>
void for_each_choice(F&& f) {
  detail::ChoiceVisitor<List>::apply(f);
}

template <class List>
std::vector<std::string> choice_names() {
  std::vector<std::string> names;
  for_each_choice<List>([&](auto choice) { names.emplace_back(choice.name); });
  return names;
}

// The listed choice of that name; empty when there is none.
template <class List>
std::optional<List> choice_named(std::string_view name) {
  std::optional<List> found;
  for_each_choice<List>([&](auto choice) {
    if (choice.name == name) found = choice;
  });
  return found;
}

template <class List>
std::string_view name_of(const List& choice) {
  return std::visit([](const auto& chosen) { return chosen.name; }, choice);
}

}  // namespace gasgrain
