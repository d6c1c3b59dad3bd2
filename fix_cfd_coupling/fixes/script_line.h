// The line of an input script that a host is working on, found from the file that it reads.
#pragma once

#include <cstdio>
#include <string>

namespace gasgrain {

// 'in.liggghts:17: "fix gas all couple/gas": ' of the line that ends where `script` stands; '' when
// there is no file (standard input, another rank).
std::string place_in_script(std::FILE* script);

}  // namespace gasgrain
