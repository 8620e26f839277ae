#pragma once
/// Damage to bytes, and memory behind which there is none.
#include <graze/oracle/random_bits.hpp>
#include <span>
#include <string>
#include <vector>

namespace graze::fuzz::self {

/// What was done: enough to say whether a checksum of 32 bits must have noticed.
struct damage {
  std::string what;
  bool within_32_bits = true; ///< no more than one change, of bytes next to each other
};

/// Changes `bytes` once or a few times; never by nothing, but what is written may be what was
/// there. `other`: valid bytes to splice in.
template <class Bytes>
damage damaged(Bytes& bytes, const Bytes& other, oracle::random_bits& random) {
  using byte = typename Bytes::value_type;
  damage d;
  const std::uint64_t times = random() % 4 == 0 ? 1 + random() % 4 : 1;
  for (std::uint64_t i = 0; i < times; ++i) {
    const std::size_t size = bytes.size(), at = size != 0 ? random() % size : 0;
    const auto place = [&](std::size_t k) {
      return bytes.begin() + static_cast<typename Bytes::difference_type>(k);
    };
    const std::uint64_t kind = size != 0 ? random() % 9 : 5;
    d.within_32_bits = d.within_32_bits && times == 1 && kind < 4;
    switch (kind) {
    case 0:
    case 1:
      bytes[at] = static_cast<byte>(bytes[at] ^ static_cast<byte>(1u << random() % 8));
      d.what += " flip at " + std::to_string(at);
      break;
    case 2: {
      static constexpr unsigned char list[] = {0, 1, 2, 0x7f, 0x80, 0xff, 54, '"', '[', '}', '-'};
      bytes[at] = static_cast<byte>(list[random() % std::size(list)]);
      d.what += " byte at " + std::to_string(at);
      break;
    }
    case 3: { // a number of four bytes, about the ends of its range
      static constexpr std::uint32_t list[] = {0, 1, 2, 0x7fffffff, 0x80000000, 0xffffffff, 53, 54};
      const std::uint32_t value = list[random() % std::size(list)];
      const std::size_t from = random() % 2 == 0 ? at : at / 4 * 4;
      for (std::size_t k = 0; k < 4 && from + k < size; ++k)
        bytes[from + k] = static_cast<byte>(value >> 8 * k);
      d.what += " number at " + std::to_string(from);
      break;
    }
    case 4:
      bytes.resize(at);
      d.what += " cut to " + std::to_string(at);
      break;
    case 5: {
      const std::size_t more = 1 + random() % 20;
      for (std::size_t k = 0; k < more; ++k)
        bytes.push_back(static_cast<byte>(random() % 3 == 0 ? random() : 0));
      d.what += " longer by " + std::to_string(more);
      break;
    }
    case 6: // the head of this one, the tail of the other
      if (!other.empty()) {
        const std::size_t from = random() % 2 == 0 ? at % other.size() : random() % other.size();
        bytes.resize(at);
        bytes.insert(bytes.end(),
                     other.begin() + static_cast<typename Bytes::difference_type>(from),
                     other.end());
        d.what += " splice at " + std::to_string(at) + " from " + std::to_string(from);
      }
      break;
    case 7: { // a piece taken out
      const std::size_t length = std::min(size - at, 1 + random() % 16);
      bytes.erase(place(at), place(at + length));
      d.what += " without " + std::to_string(length) + " at " + std::to_string(at);
      break;
    }
    default: { // a piece twice
      const std::size_t length = std::min(size - at, 1 + random() % 32);
      const Bytes piece(place(at), place(at + length));
      bytes.insert(place(at), piece.begin(), piece.end());
      d.what += " twice " + std::to_string(length) + " at " + std::to_string(at);
    }
    }
  }
  return d;
}

/// Memory whose end is the end of what can be read.
class guarded_memory {
public:
  explicit guarded_memory(std::size_t most);
  ~guarded_memory();
  guarded_memory(const guarded_memory&) = delete;
  guarded_memory& operator=(const guarded_memory&) = delete;

  /// A copy that ends there; at most `most` bytes.
  std::span<const unsigned char> copy(std::span<const unsigned char> bytes);

private:
  unsigned char* at_;
  std::size_t size_;
};

} // namespace graze::fuzz::self
