// Opening mesh files and choosing their reader.
#include "csg/imports/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "csg/leaves/leaf.h"

namespace cnrg {

std::string read_file(const std::string& path) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError("there is no file '" + path + "': check the path, it is relative to the tree file");
  }
  if (std::filesystem::is_directory(status)) {
    throw FileError("'" + path + "' cannot be read: it is a directory, give a file");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw FileError("'" + path + "' cannot be opened: " + std::strerror(errno));
  std::string content;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (!code) content.resize(static_cast<std::size_t>(size));
  std::size_t filled = 0;
  for (;;) {
    if (filled == content.size()) {
      const int next = std::fgetc(file.get());
      if (next == EOF) break;
      content.resize(std::max<std::size_t>(content.size() * 2, 4096));
      content[filled++] = static_cast<char>(next);
    }
    const std::size_t count = std::fread(content.data() + filled, 1, content.size() - filled, file.get());
    filled += count;
    if (count == 0) break;
  }
  if (std::ferror(file.get())) throw FileError("'" + path + "' cannot be read: " + std::strerror(errno));
  content.resize(filled);
  return content;
}

MeshData read_mesh(const std::string& path, bool decimal) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  using Reader = MeshData (*)(const std::string&, const std::string&, bool);
  const std::pair<const char*, Reader> readers[] = {
      {".off", &read_off}, {".obj", &read_obj}, {".stl", &read_stl}, {".ply", &read_ply}};
  for (const auto& [name, reader] : readers) {
    if (extension != name) continue;
    const std::string text = read_file(path);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
      throw LeafFileError(path + ":1: error: the file is empty: write the mesh again");
    }
    return reader(path, text, decimal);
  }
  throw InputError("mesh: '" + path +
                   "' has an unknown format: give a file with the extension .off, .obj, .stl or .ply");
}

}  // namespace cnrg
