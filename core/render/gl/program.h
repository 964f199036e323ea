#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "core/render/gl/gl_object.h"

namespace bosk {

struct ShaderText {
  const char* name;  // of the file in shaders/
  const char* text;
};
// Every file of shaders/, as it was when the program was built.
const std::vector<ShaderText>& shader_texts();

// Compiles and links files of shaders/, each a stage that its ending names: .vert, .frag or .comp.
// A line `#include "NAME"` stands for another file of shaders/; `defines` are lines that follow
// each stage's #version. Throws Error with file, line and the driver's log.
GlObject make_program(std::initializer_list<const char*> files, const std::string& defines = {});

}  // namespace bosk
