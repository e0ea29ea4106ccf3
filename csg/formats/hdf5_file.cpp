// The plug-in's part: the library itself.
#include "csg/formats/hdf5_file.h"

#include <hdf5.h>

#include <new>
#include <utility>

#include "csg/text/plugin.h"

namespace cnrg {
namespace {

/// A handle of the library, closed by the function that its kind has.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {
    if (id < 0) throw std::bad_alloc();
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): what the library takes

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require_ok(herr_t result) {
  if (result < 0) throw std::bad_alloc();
}

/// The types are those of the file, the least byte first; this program's numbers are converted where they differ.
hid_t stored(Hdf5File::Kind kind) {
  switch (kind) {
    case Hdf5File::Kind::i8: return H5T_STD_I8LE;
    case Hdf5File::Kind::u8: return H5T_STD_U8LE;
    case Hdf5File::Kind::i32: return H5T_STD_I32LE;
    case Hdf5File::Kind::i64: return H5T_STD_I64LE;
    case Hdf5File::Kind::u64: return H5T_STD_U64LE;
    default: break;
  }
  return H5T_IEEE_F64LE;
}

Handle type_of(const Hdf5File::Type& type) {
  if (type.kind == Hdf5File::Kind::opaque) return {H5Tcreate(H5T_OPAQUE, type.each), H5Tclose};
  const hsize_t size = type.each;
  return {size == 0 ? H5Tcopy(stored(type.kind)) : H5Tarray_create2(stored(type.kind), 1, &size), H5Tclose};
}

/// Groups on the way are made.
Handle with_groups() {
  Handle list(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  require_ok(H5Pset_create_intermediate_group(list, 1));
  return list;
}

/// A file of the library in memory.
class MemoryHdf5File : public Hdf5File {
 public:
  MemoryHdf5File() {
    require_ok(H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr));  // the library prints nothing
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    require_ok(H5Pset_fapl_core(access, std::size_t{1} << 20, false));
    file_ = H5Fcreate("memory", H5F_ACC_TRUNC, H5P_DEFAULT, access);
    if (file_ < 0) throw std::bad_alloc();
  }
  ~MemoryHdf5File() override { H5Fclose(file_); }
  MemoryHdf5File(const MemoryHdf5File&) = delete;
  MemoryHdf5File& operator=(const MemoryHdf5File&) = delete;

  void add_group(const std::string& path) override {
    const Handle links = with_groups();
    const Handle group(H5Gcreate2(file_, path.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  }

  void add(const std::string& path, const Type& of, const Sizes& sizes, const void* items) override {
    const std::vector<hsize_t> size(sizes.begin(), sizes.end());
    const Handle links = with_groups(), type = type_of(of);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    require_ok(H5Pset_obj_track_times(creation, false));
    const Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
    const Handle set(H5Dcreate2(file_, path.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose);
    std::uint64_t count = 1;
    for (const std::uint64_t n : sizes) count *= n;
    if (count > 0) require_ok(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, items));
  }

  void add_type(const std::string& path, const Type& type) override { commit(path, type_of(type)); }
  void add_enumeration(const std::string& path, const std::vector<std::string>& names) override {
    const Handle type(H5Tenum_create(stored(Kind::u8)), H5Tclose);
    std::uint8_t number = 0;
    for (const std::string& name : names) {
      ++number;
      require_ok(H5Tenum_insert(type, name.c_str(), &number));
    }
    commit(path, type);
  }

  void set(const std::string& path, const std::string& attribute, Kind kind, std::int64_t value) override {
    // Converted by the library from eight bytes to those of the kind.
    set(path, attribute, stored(kind), H5T_NATIVE_INT64, &value);
  }
  void set(const std::string& path, const std::string& attribute, const Type& of, const void* value) override {
    const Handle type = type_of(of);
    set(path, attribute, type, type, value);
  }
  void set(const std::string& path, const std::string& attribute, const std::string& value) override {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    require_ok(H5Tset_size(type, value.size() + 1));
    set(path, attribute, type, type, value.c_str());
  }
  void set_of_type(const std::string& path, const std::string& attribute, const std::string& type,
                   int value) override {
    const Handle named(H5Topen2(file_, type.c_str(), H5P_DEFAULT), H5Tclose);
    const auto byte = static_cast<std::uint8_t>(value);
    set(path, attribute, named, named, &byte);
  }

  std::string bytes() override {
    require_ok(H5Fflush(file_, H5F_SCOPE_LOCAL));
    const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
    if (size < 0) throw std::bad_alloc();
    std::string image(static_cast<std::size_t>(size), '\0');
    if (H5Fget_file_image(file_, image.data(), image.size()) < 0) throw std::bad_alloc();
    return image;
  }

 private:
  hid_t file_ = -1;

  void commit(const std::string& path, const Handle& type) const {
    require_ok(H5Tcommit2(file_, path.c_str(), type, with_groups(), H5P_DEFAULT, H5P_DEFAULT));
  }
  void set(const std::string& path, const std::string& attribute, hid_t type, hid_t given,
           const void* value) const {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle made(H5Acreate_by_name(file_, path.c_str(), attribute.c_str(), type, space, H5P_DEFAULT,
                                        H5P_DEFAULT, H5P_DEFAULT),
                      H5Aclose);
    require_ok(H5Awrite(made, given, value));
  }
};

}  // namespace
}  // namespace cnrg

CNRG_PLUGIN_EXPORT cnrg::Hdf5File* cnrg_hdf5_file() { return new cnrg::MemoryHdf5File; }

CNRG_PLUGIN_EXPORT const char* cnrg_hdf5_version() {
  static const std::string text = [] {
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    return "HDF5 " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
  }();
  return text.c_str();
}
