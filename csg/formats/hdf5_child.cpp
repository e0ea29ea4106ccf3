// The caller's part: a child that opens no plug-in, for another thread may hold the loader's lock at the fork.
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <new>

#include "csg/formats/hdf5_file.h"
#include "csg/text/child.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {
namespace {

/// What `ulimit -f` leaves for a list of bytes: it holds for files in memory, too.
std::size_t largest_file() {
  rlimit limit;
  if (getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::string::npos;
  return limit.rlim_cur - std::min<rlim_t>(limit.rlim_cur, sizeof(std::uint64_t));
}

}  // namespace

std::unique_ptr<Hdf5File> new_hdf5_file() {
  return std::unique_ptr<Hdf5File>(CNRG_PLUGIN_FUNCTION(kHdf5Plugin, cnrg_hdf5_file)());
}

void Hdf5File::add(const std::string& path, const std::vector<std::string>& texts, const Type& type) {
  std::string bytes;
  for (std::string text : texts) {
    text.resize(type.each, '\0');
    bytes += text;
  }
  add(path, type, {texts.size()}, bytes.data());
}

std::string hdf5_bytes(const std::string& format, const std::function<std::string()>& make) {
  plugin_symbol(kHdf5Plugin, "cnrg_hdf5_file");  // before the fork
  const MemoryFile made("HDF5");
  constexpr int kWhole = 0, kRefused = 1, kTooLarge = 2;
  const ChildEnd end = run_in_child("HDF5", {}, [&] {
    try {
      const std::string bytes = make();
      if (bytes.size() > largest_file()) return kTooLarge;
      made.write_list(bytes);
      return kWhole;
    } catch (const InputError& error) {
      made.write_list(std::string(error.what()));
      return kRefused;
    }
  });
  using Kind = ChildEnd::Kind;
  if (end.kind == Kind::memory) throw std::bad_alloc();
  if (end.kind != Kind::done) {
    const std::string how = end.kind == Kind::signal ? "crashed (signal " : "ended its process (";
    throw FileError("HDF5, which writes " + format + ", " + how + std::to_string(end.number) +
                    "), as it does where memory runs out: free some, or choose another format");
  }
  if (end.number == kTooLarge) throw FileError(std::string("cannot be written: ") + std::strerror(EFBIG));
  made.rewind();
  std::string text;
  made.read_list(text);
  if (end.number == kRefused) throw InputError(text);
  return text;
}

}  // namespace cnrg
