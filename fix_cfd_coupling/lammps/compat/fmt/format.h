// Stands before the system's fmt for files that include the host's headers: these name a function
// of the older fmt that the host carries inside. What would call it cannot be linked (the types
// differ), and is refused here: give the host's functions a std::string.
#pragma once

#include_next <fmt/format.h>

namespace fmt {

template <class... Args, class Format, class... Given>
format_args make_args_checked(const Format&, const Given&...) = delete;

}  // namespace fmt
