#pragma once
/// What graze-render and its plug-in graze_exr.so know of each other. OpenImageIO brings 250 libraries,
/// which take 0.2 s to load; so only those who want an EXR picture load them.
#include <graze/render/image.hpp>

namespace graze::render {

struct exr_plugin {
  const char* version; ///< of Graze: both are of one build
  expected<std::vector<unsigned char>> (*encode)(const picture&);
};

inline constexpr const char* exr_plugin_file = "graze_exr.so";
inline constexpr const char* exr_plugin_symbol = "graze_exr_plugin"; ///< an exr_plugin

} // namespace graze::render
