// Files that are whole whenever they are there: written beside and renamed.
#pragma once

#include <filesystem>
#include <string>

namespace gasgrain {

// Throws Error when the file cannot be written.
void write_whole(const std::filesystem::path& file, const std::string& text);

}  // namespace gasgrain
