#pragma once

#include <string>
#include <vector>

namespace bosk {

// An OpenGL 4.5 core context without window or display server, current on the thread that makes it
// until it is dropped. Throws Error, with what to install, when there is no driver or an older one.
class HeadlessContext {
 public:
  // With `debug`, the driver's complaints are collected in errors().
  explicit HeadlessContext(bool debug = false);
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  // Errors and undefined behaviour that KHR_debug reported so far.
  const std::vector<std::string>& errors() const { return errors_; }
  // Renderer and version, in the driver's words.
  std::string description() const;

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
  std::vector<std::string> errors_;
};

}  // namespace bosk
