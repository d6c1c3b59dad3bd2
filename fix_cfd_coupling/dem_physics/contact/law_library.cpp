#include "fix_cfd_coupling/dem_physics/contact/law_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string_view>

#include "coupling/base/error.h"

namespace gasgrain::contact {
namespace {

// The loader looks for a name without a folder in the system's folders alone.
std::string path_of(const std::string& file) {
  return file.find('/') == std::string::npos ? "./" + file : file;
}

// What a library says of itself (law_module.cpp.in of each host), '' where it is none of ours. Read
// from the file: the library of another host cannot be opened, its symbols are nowhere.
std::string rest_of_mark(const std::string& path) {
  constexpr std::string_view mark = "gasgrain law for ";
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto at = bytes.find(mark);
  return at == std::string::npos ? "" : bytes.c_str() + at + mark.size();
}

}  // namespace

void load_law(const std::string& file, const std::string& host) {
  const std::string path = path_of(file);
  if (access(path.c_str(), R_OK) != 0)
    fail("plugin load {}: there is no such file, or it may not be read.", file);
  const std::string it_is = rest_of_mark(path);
  const auto between = it_is.find(" of ");
  if (between == std::string::npos)
    fail("plugin load {}: it holds no contact law. Build it with gasgrain_add_law(LAW.h).", file);
  if (it_is.substr(0, between) != host)
    fail(
        "plugin load {}: it is built for {}, and this is {}. Load the library that the same build "
        "made as ...-{}.so.",
        file, it_is.substr(0, between), host, host);
  if (it_is.substr(between + 4) != GASGRAIN_VERSION)
    fail("plugin load {}: it is built with gasgrain {}, and this is {}. Build it anew.", file,
         it_is.substr(between + 4), GASGRAIN_VERSION);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto add = library == nullptr
                       ? nullptr
                       : reinterpret_cast<void (*)()>(dlsym(library, "gasgrain_law_add"));
  if (add == nullptr) {
    const char* why = dlerror();
    fail("plugin load {}: {}. Build it anew, with the gasgrain that runs.", file, why);
  }
  add();
}

}  // namespace gasgrain::contact
