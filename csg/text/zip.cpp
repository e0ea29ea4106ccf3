// Each part behind a header of its own, then a directory with the same once more and where each part is, then
// where the directory is (PKWARE's APPNOTE, 4.3). Parts are raw deflate (RFC 1951).
#include "csg/text/zip.h"

#include <zlib.h>

#include <cstdint>
#include <limits>
#include <new>

#include "kernel/base/error.h"

namespace cnrg {
namespace {

constexpr int kLevel = 4;  // a tenth of the time of the best one, an eighth more bytes
constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();

/// Numbers, each with its bytes.
void append(std::string& text, std::initializer_list<std::pair<std::uint32_t, int>> numbers) {
  for (const auto& [number, bytes] : numbers) {
    for (int k = 0; k < bytes; ++k) text += static_cast<char>(number >> (8 * k) & 0xff);
  }
}

std::uint32_t size_of(std::string_view text) { return static_cast<std::uint32_t>(text.size()); }

void require_size(std::size_t size) {
  if (size > kMost) throw InputError("the file would be larger than the 4 GB that a ZIP archive holds");
}

std::string deflated(std::string_view content) {
  z_stream stream{};
  int done = deflateInit2(&stream, kLevel, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL, Z_DEFAULT_STRATEGY);
  if (done == Z_MEM_ERROR) throw std::bad_alloc();
  require(done == Z_OK, "zip: zlib refuses its options");
  std::string bytes;
  try {
    bytes.resize(deflateBound(&stream, content.size()));
    require_size(bytes.size());
  } catch (...) {
    deflateEnd(&stream);
    throw;
  }
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  done = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  require(done == Z_STREAM_END, "zip: zlib failed");
  return bytes;
}

}  // namespace

std::string zip(const std::vector<ZipPart>& parts) {
  constexpr std::uint32_t kVersion = 20, kDeflated = 8, kFirstDay = 1 << 5 | 1;  // 1 January 1980
  std::string archive, directory;
  for (const ZipPart& part : parts) {
    require_size(part.content.size());
    const std::string bytes = deflated(part.content);
    const auto checksum = static_cast<std::uint32_t>(
        crc32_z(0, reinterpret_cast<const Bytef*>(part.content.data()), part.content.size()));
    std::string common;  // of both headers: no flags, midnight, nothing extra
    append(common, {{kVersion, 2},
                    {0, 2},
                    {kDeflated, 2},
                    {0, 2},
                    {kFirstDay, 2},
                    {checksum, 4},
                    {size_of(bytes), 4},
                    {size_of(part.content), 4},
                    {size_of(part.name), 2},
                    {0, 2}});
    directory += "PK\1\2";
    append(directory, {{kVersion, 2}});
    directory += common;
    append(directory, {{0, 2}, {0, 2}, {0, 2}, {0, 4}, {size_of(archive), 4}});  // the first disk, no attributes
    directory += part.name;
    archive += "PK\3\4" + common;
    archive += part.name;
    archive += bytes;
    require_size(archive.size() + directory.size());
  }
  const auto end = size_of(archive), count = static_cast<std::uint32_t>(parts.size());
  archive += directory + "PK\5\6";
  append(archive, {{0, 4}, {count, 2}, {count, 2}, {size_of(directory), 4}, {end, 4}, {0, 2}});  // one disk
  return archive;
}

}  // namespace cnrg
