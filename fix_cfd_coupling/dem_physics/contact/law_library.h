// Contact laws that are built outside of this tree: the script's `plugin load FILE` opens the
// shared library that gasgrain_add_law() (gasgrain-config.cmake) made, which adds its law to the
// host's.
#pragma once

#include <string>

namespace gasgrain::contact {

// `host` is 'liggghts' or 'lammps': a library is of one host and of one version of gasgrain.
// Loading it again does nothing new. Throws Error.
void load_law(const std::string& file, const std::string& host);

}  // namespace gasgrain::contact
