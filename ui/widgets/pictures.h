#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <map>
#include <string>

#include "core/image/image.h"

namespace bosk {

// Where textures live: OpenGL, or nowhere in tests.
struct PictureDevice {
  // Makes a texture of straight-alpha sRGB pixels, or puts the pixels into `old`, a texture of the
  // same size, when it isn't null.
  std::function<ImTextureID(const Image<glm::u8vec4>& picture, ImTextureID old)> upload;
  std::function<void(ImTextureID)> free;
};

// A picture on the screen's side. Null and zero until there is one.
struct Texture {
  ImTextureID id = nullptr;
  glm::ivec2 size_px{0};

  explicit operator bool() const { return id != nullptr; }
};

// Textures by name. One is made anew when its revision is another than the one held, and freed when
// it was not asked for during some frames. On the interface thread alone; must not outlive the
// device's context.
class Pictures {
 public:
  explicit Pictures(PictureDevice device) : device_(std::move(device)) {}
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;
  ~Pictures();

  // `make` is called only where the revision is new. An empty picture is shown as none.
  Texture show(const std::string& name, std::uint64_t revision,
               const std::function<Image<glm::u8vec4>()>& make);
  // The newest texture of that name, whatever its revision: to be shown while another is made.
  Texture newest(const std::string& name);
  // Frees all: what is asked for next has nothing to do with what was.
  void clear();
  // Frees what nobody asked for lately. Once a frame.
  void end_frame();
  std::size_t size() const { return held_.size(); }

 private:
  struct Held {
    Texture texture;
    std::uint64_t revision = 0, last_frame = 0;
  };
  void release(Held& held);

  PictureDevice device_;
  std::map<std::string, Held> held_;
  std::uint64_t frame_ = 0;
};

}  // namespace bosk
