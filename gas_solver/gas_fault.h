// A gas that cannot go on: its fields are no numbers any more, or the flow runs away. Found while
// the run goes on, and worth an autopsy of the state it leaves. The same on all ranks.
#pragma once

#include "coupling/base/error.h"

namespace gasgrain {

class GasFault : public Error {
 public:
  using Error::Error;
};

}  // namespace gasgrain
