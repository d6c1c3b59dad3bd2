#include "fix_cfd_coupling/dem_physics/contact/law_library.h"

#include <dlfcn.h>
#include <unistd.h>

#include "coupling/base/error.h"

namespace gasgrain::contact {
namespace {

// Else the loader looks for a name without a folder in the system's folders alone.
std::string path_of(const std::string& file) {
  const bool is_here =
      file.find('/') == std::string::npos && access(("./" + file).c_str(), R_OK) == 0;
  return is_here ? "./" + file : file;
}

template <class Function>
Function symbol(void* library, const char* name) {
  return reinterpret_cast<Function>(dlsym(library, name));
}

}  // namespace

void load_law(const std::string& file, const std::string& host) {
  const std::string path = path_of(file);
  if (path.find('/') != std::string::npos && access(path.c_str(), R_OK) != 0)
    fail("plugin load {}: there is no such file, or it may not be read.", file);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* why = dlerror();
    fail("plugin load {}: {}", file, why);
  }
  const auto host_of = symbol<const char* (*)()>(library, "gasgrain_law_host");
  const auto version_of = symbol<const char* (*)()>(library, "gasgrain_law_version");
  const auto add = symbol<void (*)()>(library, "gasgrain_law_add");
  if (host_of == nullptr || version_of == nullptr || add == nullptr)
    fail("plugin load {}: it holds no contact law. Build it with gasgrain_add_law(LAW.h).", file);
  if (host_of() != host)
    fail(
        "plugin load {}: it is built for {}, and this is {}. Load the library that the same build "
        "made as ...-{}.so.",
        file, host_of(), host, host);
  if (version_of() != std::string(GASGRAIN_VERSION))
    fail("plugin load {}: it is built with gasgrain {}, and this is {}. Build it anew.", file,
         version_of(), GASGRAIN_VERSION);
  add();
}

}  // namespace gasgrain::contact
