// ELF: the header is at the beginning and names the table of sections, which linkers put at the end. Each entry of
// the table says where its section lies, so a file that was cut short, or whose end is no longer what it was, is
// known without a look at the rest.
#include "csg/text/module_file.h"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#if defined(__GLIBC__) && __has_include(<elf.h>)  // others do not tell where they look
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

namespace cnrg {
namespace {

using Header = ElfW(Ehdr);
using Section = ElfW(Shdr);

/// Folders in which the loader looks for what this code opens.
std::vector<std::string> search_path() {
  Dl_info self;
  if (dladdr(reinterpret_cast<void*>(&module_path), &self) == 0) return {};
  // The main program has no name to be opened by.
  void* opened = dlopen(self.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  if (opened == nullptr) opened = dlopen(nullptr, RTLD_LAZY);
  const std::unique_ptr<void, int (*)(void*)> module(opened, dlclose);
  Dl_serinfo size;
  if (module == nullptr || dlinfo(module.get(), RTLD_DI_SERINFOSIZE, &size) != 0) return {};
  std::vector<std::max_align_t> room(size.dls_size / sizeof(std::max_align_t) + 1);
  auto* const info = reinterpret_cast<Dl_serinfo*>(room.data());
  std::memcpy(info, &size, offsetof(Dl_serinfo, dls_serpath));
  std::vector<std::string> out;
  if (dlinfo(module.get(), RTLD_DI_SERINFO, info) == 0) {
    const Dl_serpath* const folders = info->dls_serpath;
    for (unsigned i = 0; i < info->dls_cnt; ++i) out.emplace_back(folders[i].dls_name);
  }
  return out;
}

template <typename T>
bool read_at(std::ifstream& file, std::uint64_t place, T* values, std::size_t count) {
  file.seekg(std::streamoff(place));
  file.read(reinterpret_cast<char*>(values), std::streamsize(count * sizeof(T)));
  return bool(file);
}

/// `place + length` may be more than 64 bits hold.
bool lies_within(std::uint64_t place, std::uint64_t length, std::uint64_t size) {
  return place <= size && length <= size - place;
}

}  // namespace

std::string module_path(const std::string& name) {
  for (const std::string& folder : search_path()) {
    const std::string path = folder + "/" + name;
    if (std::error_code error; std::filesystem::is_regular_file(path, error)) return path;
  }
  return {};
}

std::string module_damage(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return "it cannot be read";
  const auto size = std::uint64_t(file.tellg());
  Header header;
  if (!read_at(file, 0, &header, 1) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return "it is no module";
  const std::string cut = "it is cut short: " + std::to_string(size) + " bytes are left";
  if (header.e_shentsize != sizeof(Section) || header.e_shnum == 0 || header.e_shstrndx >= header.e_shnum)
    return "its header is damaged";
  if (!lies_within(header.e_shoff, std::uint64_t(header.e_shnum) * sizeof(Section), size)) return cut;
  std::vector<Section> sections(header.e_shnum);
  if (!read_at(file, header.e_shoff, sections.data(), sections.size())) return "it cannot be read";
  if (sections[header.e_shstrndx].sh_type != SHT_STRTAB) return "its table of sections is damaged";
  const bool whole = std::ranges::all_of(sections, [&](const Section& section) {
    return section.sh_type == SHT_NOBITS || lies_within(section.sh_offset, section.sh_size, size);
  });
  return whole ? "" : cut;
}

}  // namespace cnrg

#else

namespace cnrg {

std::string module_path(const std::string&) { return {}; }
std::string module_damage(const std::string&) { return {}; }

}  // namespace cnrg

#endif
