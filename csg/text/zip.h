// Files in one: a ZIP archive, as packages of 3MF and of office programs are.
//
// An archive notes when each of its files was changed; that would make two archives of one result differ. Here all
// files are as old as the format can say, so that the same content gives the same bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cnrg {

struct ZipPart {
  std::string_view name;  ///< with `/` between folders, ASCII
  std::string_view content;
};

/// The archive, each part compressed. Throws InputError beyond 4 GB, for which ZIP has another format.
std::string zip(const std::vector<ZipPart>& parts);

}  // namespace cnrg
