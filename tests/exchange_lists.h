// A LIST as the types of a GoogleTest suite, so that a model is tested by being listed.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace gasgrain {

template <class List>
struct ListedTypes;
template <class... Choices>
struct ListedTypes<std::variant<Choices...>> {
  using type = testing::Types<Choices...>;
};

struct ListedName {
  template <class Choice>
  static std::string GetName(int) {
    return std::string(Choice::name);
  }
};

}  // namespace gasgrain
