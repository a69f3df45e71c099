// The only access to zlib.
#include "report/deflate.h"

#include <zlib.h>

#include "wythe/parts/error.h"

namespace wythe::report {

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                             reinterpret_cast<const Bytef*>(bytes.data()),
                             static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  if (code != Z_OK) throw IoError("out of memory while packing the report's data");
  out.resize(size);
  return out;
}

struct Inflater::Stream {
  z_stream z{};
  bool ended = false;
};

Inflater::Inflater(std::string_view packed) : stream_(std::make_unique<Stream>()) {
  // zlib does not change the input, although its type says so
  stream_->z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream_->z.avail_in = static_cast<uInt>(packed.size());
  if (inflateInit(&stream_->z) != Z_OK)
    throw IoError("out of memory while reading the report's data");
}

Inflater::~Inflater() { inflateEnd(&stream_->z); }

std::size_t Inflater::read(std::string& to) {
  z_stream& z = stream_->z;
  z.next_out = reinterpret_cast<Bytef*>(to.data());
  z.avail_out = static_cast<uInt>(to.size());
  int code = Z_OK;
  while (code == Z_OK && z.avail_out > 0) code = inflate(&z, Z_NO_FLUSH);
  stream_->ended = code == Z_STREAM_END;
  return to.size() - z.avail_out;
}

bool Inflater::ended() const { return stream_->ended; }

}  // namespace wythe::report
