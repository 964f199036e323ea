#include "core/render/gl/program.h"

#include <GL/glcorearb.h>

#include <cassert>
#include <sstream>

#include "core/base/error.h"

namespace bosk {
namespace {

std::string text_of(const std::string& name) {
  for (const ShaderText& shader : shader_texts())
    if (shader.name == name) return shader.text;
  assert(false && "no such file in shaders/");
  return {};
}

// A stage's text with its includes in place; `files` are the names that the driver's log numbers.
struct Source {
  std::string text;
  std::vector<std::string> files;
};

void append_file(const std::string& name, Source& source) {
  const std::size_t number = source.files.size();
  source.files.push_back(name);
  std::istringstream lines(text_of(name));
  std::string line;
  for (int at = 1; std::getline(lines, line); ++at) {
    constexpr const char* kInclude = "#include \"";
    if (line.rfind(kInclude, 0) == 0) {
      const std::size_t first = std::string(kInclude).size();
      source.text += "#line 1 " + std::to_string(source.files.size()) + "\n";
      append_file(line.substr(first, line.find('"', first) - first), source);
      source.text += "#line " + std::to_string(at + 1) + " " + std::to_string(number) + "\n";
    } else {
      source.text += line + "\n";
    }
  }
}

GLenum stage_of(const std::string& file) {
  if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
  if (file.ends_with(".frag")) return GL_FRAGMENT_SHADER;
  assert(file.ends_with(".comp"));
  return GL_COMPUTE_SHADER;
}

// The log of a shader or program, by its pair of functions.
template <class GetNumber, class GetLog>
std::string log_of(GLuint name, GetNumber get_number, GetLog get_log) {
  GLint length = 0;
  get_number(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(std::size_t(length) + 1, '\0');
  get_log(name, length + 1, nullptr, log.data());
  return log.c_str();
}

Error refused(const std::string& what, const std::string& log) {
  return Error("this OpenGL driver refuses the shader " + what + ": " + log +
               "; update the driver or draw without OpenGL");
}

// #version must come first.
void insert_defines(const std::string& defines, std::string& text) {
  const std::size_t second_line = text.find('\n') + 1;
  text.insert(second_line, defines + "#line 2 0\n");
}

void attach(GLuint program, const std::string& file, const std::string& defines) {
  Source source;
  append_file(file, source);
  insert_defines(defines, source.text);
  const GLuint shader = glCreateShader(stage_of(file));
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // once the program lets go of it
  if (done) return;
  std::string names;
  for (std::size_t i = 0; i < source.files.size(); ++i)
    names += (i ? ", " : "") + std::to_string(i) + " = " + source.files[i];
  throw refused(file + " (" + names + ")", log_of(shader, glGetShaderiv, glGetShaderInfoLog));
}

}  // namespace

GlObject make_program(std::initializer_list<const char*> files, const std::string& defines) {
  GlObject program(GlObject::Kind::program);
  std::string names;
  for (const char* file : files) {
    attach(program.name(), file, defines);
    names += (names.empty() ? "" : " + ") + std::string(file);
  }
  glLinkProgram(program.name());
  GLint done = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &done);
  if (!done) throw refused(names, log_of(program.name(), glGetProgramiv, glGetProgramInfoLog));
  return program;
}

}  // namespace bosk
