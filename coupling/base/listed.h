// Choices of a LIST that a build may leave out: a LIST is a std::variant, and a build for some
// scenes only may list fewer alternatives than there are (tests/properties/zero_cost).
#pragma once

#include <type_traits>
#include <utility>
#include <variant>

#include "coupling/base/error.h"

namespace gasgrain {

template <class Choice, class List>
struct IsListed;
template <class Choice, class... Choices>
struct IsListed<Choice, std::variant<Choices...>>
    : std::bool_constant<(std::is_same_v<Choice, Choices> || ...)> {};

// The choice if it is this one; else null, as for one that is not listed.
template <class Choice, class List>
const Choice* chosen_as(const List& list) {
  if constexpr (IsListed<Choice, List>::value)
    return std::get_if<Choice>(&list);
  else
    return nullptr;
}
template <class Choice, class List>
Choice* chosen_as(List& list) {
  return const_cast<Choice*>(chosen_as<Choice>(std::as_const(list)));
}

// The LIST with this choice made by `make()`; throws Error when the build has left it out.
template <class List, class Make>
List listed(Make&& make) {
  if constexpr (IsListed<std::decay_t<decltype(make())>, List>::value)
    return make();
  else
    fail("this build has left out what is asked for.");
}

namespace detail {
template <class F, class... Choices>
[[gnu::noipa]] void apart(const F& f, const Choices&... choices) {
  f(choices...);
}
}  // namespace detail

// std::visit for loops: f is called in a function of its own for each listed type, so that a loop
// is compiled to the same instructions whatever else is listed.
template <class F, class... Lists>
void visit_apart(const F& f, const Lists&... lists) {
  std::visit([&](const auto&... choices) { detail::apart(f, choices...); }, lists...);
}

}  // namespace gasgrain
