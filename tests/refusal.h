// The words in which a law refuses its numbers, for tests of its check().
#pragma once

#include <string>

#include "coupling/base/error.h"

namespace gasgrain {

// What check(law) says; empty when it takes the law.
template <class Law>
std::string message(const Law& law) {
  try {
    check(law);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace gasgrain
