// The caller's part: a child that opens no plug-in, for another thread may hold the loader's lock at the fork.
#include <new>

#include "csg/formats/hdf5_file.h"
#include "csg/text/child.h"
#include "csg/text/plugin.h"
#include "kernel/base/error.h"

namespace cnrg {

std::unique_ptr<Hdf5File> new_hdf5_file() {
  return std::unique_ptr<Hdf5File>(CNRG_PLUGIN_FUNCTION(kHdf5Plugin, cnrg_hdf5_file)());
}

std::string hdf5_bytes(const std::string& format, const std::function<std::string()>& make) {
  plugin_symbol(kHdf5Plugin, "cnrg_hdf5_file");  // before the fork
  const MemoryFile made("HDF5");
  constexpr int kWhole = 0, kRefused = 1;
  const ChildEnd end = run_in_child("HDF5", {}, [&] {
    try {
      made.write_list(make());
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
  made.rewind();
  std::string text;
  made.read_list(text);
  if (end.number == kRefused) throw InputError(text);
  return text;
}

}  // namespace cnrg
