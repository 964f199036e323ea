#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bosk {

// One object of the current OpenGL context, deleted with this handle. Moved, not copied; a default
// one stands for none. The context must be current when a handle is made, used or dropped.
class GlObject {
 public:
  enum class Kind { none, buffer, texture_2d, texture_array, program, framebuffer, vertex_array };

  GlObject() = default;
  explicit GlObject(Kind kind);
  ~GlObject();
  GlObject(GlObject&& other) noexcept
      : kind_(std::exchange(other.kind_, Kind::none)), name_(std::exchange(other.name_, 0u)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(name_, other.name_);
    return *this;
  }

  unsigned name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  Kind kind_ = Kind::none;
  unsigned name_ = 0;
};

// A buffer that never changes, and what it takes on the GPU. Empty data takes four bytes: shaders
// may not read a buffer of none.
struct FixedBuffer {
  GlObject object;
  std::size_t bytes = 0;
};
FixedBuffer make_buffer(std::span<const std::byte> data);
template <class T>
FixedBuffer make_buffer(const std::vector<T>& data) {
  return make_buffer(std::as_bytes(std::span(data)));
}

// A buffer that is written anew each frame and grows as needed.
class StreamBuffer {
 public:
  // The buffer's content becomes `data`; what earlier commands read of it is not disturbed.
  void write(std::span<const std::byte> data);
  template <class T>
  void write(const std::vector<T>& data) {
    write(std::as_bytes(std::span(data)));
  }
  // At least so large, content undefined.
  void reserve(std::size_t bytes);
  unsigned name() const { return object_.name(); }
  std::size_t bytes() const { return bytes_; }

 private:
  GlObject object_;
  std::size_t bytes_ = 0;
};

// Renderer and version of the current context, in the driver's words.
std::string driver_description();

// Throws Error unless a context is current that has at least OpenGL 4.5 and wasn't lost.
void require_gl_context();

// Throws Error naming `doing` when OpenGL reported a failure since the last call: out of memory as
// ErrorKind::resource.
void check_gl(const char* doing);

}  // namespace bosk
