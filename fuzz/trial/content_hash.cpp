#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid.hpp>
#include <fmt/format.h>
#include <trial/content_hash.hpp>

namespace graze::fuzz {

std::string content_hash(std::string_view content) {
  std::string hash;
  const boost::uuids::name_generator_sha1 name_of_content{boost::uuids::uuid{}};
  for (const std::uint8_t byte : name_of_content(content.data(), content.size()))
    hash += fmt::format("{:02x}", byte);
  return hash;
}

} // namespace graze::fuzz
