#include "gas_solver/io/disk.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

constexpr double megabyte = 1e6;
constexpr double without_end = std::numeric_limits<double>::infinity();

std::string folder_of(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

double room_on_disk(const std::string& file) {
  struct statvfs disk {};
  // Some file systems know no size: what they cannot tell is not held against them.
  if (statvfs(folder_of(file).c_str(), &disk) != 0 || disk.f_blocks == 0) return without_end;
  return static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
}

double room_in_limit(const std::string& file) {
  rlimit limit{};
  if (getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return without_end;
  struct stat there {};
  const double size = stat(file.c_str(), &there) == 0 ? static_cast<double>(there.st_size) : 0;
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - size);
}

class Descriptor {
 public:
  Descriptor(const std::string& name, int flags)
      : fd_(open(name.c_str(), flags | O_CLOEXEC, 0600)) {}
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  operator int() const { return fd_; }

 private:
  int fd_;
};

int sync(const std::string& name, int flags) {
  const Descriptor file(name, flags);
  return file >= 0 && fsync(file) == 0 ? 0 : errno;
}

}  // namespace

void require_room(const std::string& file, double bytes, const Communicator& comm) {
  const double on_disk = -comm.max(comm.is_root() ? -room_on_disk(file) : -without_end);
  if (bytes > on_disk)
    fail(
        "{} cannot be written: {:.3g} MB are needed, {:.3g} MB are free on the disk of {}. Make "
        "room there, or choose another folder.",
        file, bytes / megabyte, on_disk / megabyte, folder_of(file));
  const double in_limit = comm.min(room_in_limit(file));
  if (bytes > in_limit)
    fail(
        "{} cannot be written: {:.3g} MB are needed, {:.3g} MB are left of the limit of a file's "
        "size. Raise it ('ulimit -f').",
        file, bytes / megabyte, in_limit / megabyte);
}

std::string why_not_written(const std::string& file) {
  constexpr std::size_t probe_bytes = 1 << 20;  // more than what a full disk's last block may take
  {
    const Descriptor itself(file, O_WRONLY);
    if (itself < 0 && errno != ENOENT) return std::strerror(errno);
  }
  const std::string name = file + ".probe";
  int failure = 0;
  {
    const Descriptor probe(name, O_WRONLY | O_CREAT | O_TRUNC);
    if (probe < 0) return std::strerror(errno);
    const std::array<char, 4096> block{};
    for (std::size_t done = 0; done < probe_bytes && failure == 0; done += block.size())
      if (write(probe, block.data(), block.size()) < 0) failure = errno;
  }
  std::remove(name.c_str());
  return failure != 0 ? std::strerror(failure) : "the system does not tell why; is the disk full?";
}

std::string why_not_opened(const std::string& file) {
  constexpr std::array<unsigned char, 8> signature{0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
  const Descriptor opened(file, O_RDONLY);
  if (opened < 0) return std::strerror(errno);
  std::array<unsigned char, 8> begin{};
  const ssize_t got = read(opened, begin.data(), begin.size());
  if (got < 0) return std::strerror(errno);
  if (got == 0) return "it is empty";
  if (begin != signature) return "it is not an HDF5 file";
  return "it is cut short or damaged";
}

int put_in_place(const std::string& written, const std::string& name) {
  if (const int failure = sync(written, O_RDONLY)) return failure;
  if (std::rename(written.c_str(), name.c_str()) != 0) return errno;
  const int failure = sync(folder_of(name), O_RDONLY | O_DIRECTORY);
  return failure == EINVAL ? 0 : failure;  // a file system that cannot sync folders
}

}  // namespace gasgrain
