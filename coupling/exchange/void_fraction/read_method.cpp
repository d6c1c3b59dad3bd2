#include "coupling/exchange/void_fraction/read_method.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "coupling/base/error.h"
#include "coupling/base/listed.h"

namespace gasgrain {
namespace {

const std::string auto_word = "auto";

// The number that a method may have after its name [diameters].
struct Number {
  double* value = nullptr;
  std::string_view what;
  double least = 0.0;
  double most = 0.0;
  double usual = 0.0;
};

Number number_of(VoidFractionMethod& method) {
  if (auto* kernel = chosen_as<VoidFractionKernel>(method))
    return {&kernel->width, "width", 0.5, 20.0, VoidFractionKernel::default_width};
  if (auto* grid = chosen_as<VoidFractionParticleGrid>(method))
    return {&grid->size, "size", 1.0, 20.0, VoidFractionParticleGrid::default_size};
  return {};
}

bool looks_like_a_number(const std::string& word) {
  return !word.empty() && std::string("+-.0123456789").find(word[0]) != std::string::npos;
}

}  // namespace

std::string NamedMethod::text() const {
  if (automatic) return auto_word;
  VoidFractionMethod copy = method;
  const Number number = number_of(copy);
  if (number.value == nullptr) return std::string(name_of(method));
  return fmt::format("{} {}", name_of(method), *number.value);
}

std::vector<std::string> method_names() {
  std::vector<std::string> names = choice_names<VoidFractionMethod>();
  names.push_back(auto_word);
  return names;
}

MethodWords read_method(const std::vector<std::string>& words, std::size_t next,
                        const std::vector<std::string>& others) {
  const std::string effect = "void_fraction";
  if (next == words.size() || std::find(others.begin(), others.end(), words[next]) != others.end())
    return {{},
            fmt::format("\"{}\" must be followed by one of: {}.", effect,
                        fmt::join(method_names(), ", ")),
            0};
  const std::string& name = words[next];
  if (name == auto_word) return {NamedMethod{}, "", 1};
  const auto choice = choice_named<VoidFractionMethod>(name);
  if (!choice)
    return {{},
            fmt::format("{} \"{}\" is unknown.{}", effect, name, suggestion(name, method_names())),
            1};
  NamedMethod named{*choice, false};
  const Number number = number_of(named.method);
  if (number.value == nullptr || next + 1 == words.size() || !looks_like_a_number(words[next + 1]))
    return {named, "", 1};
  const std::string& word = words[next + 1];
  char* end = nullptr;
  *number.value = std::strtod(word.c_str(), &end);
  if (*end != '\0' || !(*number.value >= number.least && *number.value <= number.most))
    return {{},
            fmt::format("{} {} {}: the {} must be a number of particle diameters from {:g} to "
                        "{:g}. Leave it out for {:g}.",
                        effect, name, word, number.what, number.least, number.most, number.usual),
            2};
  return {named, "", 2};
}

}  // namespace gasgrain
