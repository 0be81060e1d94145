#include "picture/gl_objects.h"

#include <string>

#include "picture/picture_error.h"

namespace hooke::picture {
namespace {

GLuint compiled(GLenum stage, std::string_view text) {
  const GLuint shader = glCreateShader(stage);
  const GLchar* start = text.data();
  const GLint length = GLint(text.size());
  glShaderSource(shader, 1, &start, &length);
  glCompileShader(shader);
  return shader;
}

/// What the driver says about a program that it did not take.
std::string complaint(GLuint program, GLuint vertex, GLuint fragment) {
  char text[1024] = "";
  std::string all;
  for (const GLuint shader : {vertex, fragment}) {
    glGetShaderInfoLog(shader, sizeof(text), nullptr, text);
    all += text;
  }
  glGetProgramInfoLog(program, sizeof(text), nullptr, text);
  return all + text;
}

}  // namespace

GLuint BufferKind::make() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(GL_TEXTURE_BUFFER, name);  // makes it one: until then the name is only kept
  return name;
}
void BufferKind::remove(GLuint name) {
  glDeleteBuffers(1, &name);
}

GLuint VertexArrayKind::make() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return name;
}
void VertexArrayKind::remove(GLuint name) {
  glDeleteVertexArrays(1, &name);
}

GLuint TextureKind::make() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return name;
}
void TextureKind::remove(GLuint name) {
  glDeleteTextures(1, &name);
}

GLuint FramebufferKind::make() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return name;
}
void FramebufferKind::remove(GLuint name) {
  glDeleteFramebuffers(1, &name);
}

GLuint RenderbufferKind::make() {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  return name;
}
void RenderbufferKind::remove(GLuint name) {
  glDeleteRenderbuffers(1, &name);
}

GLuint ProgramKind::make() {
  return glCreateProgram();
}
void ProgramKind::remove(GLuint name) {
  glDeleteProgram(name);
}

void Buffer::put(GLenum target, std::span<const std::byte> bytes, GLenum usage) {
  glBindBuffer(target, name());
  glBufferData(target, GLsizeiptr(bytes.size()), bytes.data(), usage);
}

BufferTexture::BufferTexture(const Buffer& buffer, GLenum format) {
  glBindTexture(GL_TEXTURE_BUFFER, name());
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.name());
  glBindTexture(GL_TEXTURE_BUFFER, 0);
}

void BufferTexture::bind(GLuint unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_BUFFER, name());
}

Program::Program(std::string_view vertex, std::string_view fragment) {
  const GLuint stages[] = {compiled(GL_VERTEX_SHADER, vertex), compiled(GL_FRAGMENT_SHADER, fragment)};
  for (const GLuint stage : stages) glAttachShader(name(), stage);
  glLinkProgram(name());
  GLint linked = GL_FALSE;
  glGetProgramiv(name(), GL_LINK_STATUS, &linked);
  const std::string problem = linked ? "" : complaint(name(), stages[0], stages[1]);
  for (const GLuint stage : stages) {
    glDetachShader(name(), stage);
    glDeleteShader(stage);
  }
  if (!linked) throw PictureError("the OpenGL driver does not take a shader: " + problem);
}

void Program::use() const {
  glUseProgram(name());
}

GLint Program::uniform(const char* uniform_name) const {
  return glGetUniformLocation(name(), uniform_name);
}

void Program::sampler(const char* sampler_name, GLint unit) const {
  use();
  glUniform1i(uniform(sampler_name), unit);
}

void Program::block(const char* block_name, GLuint point) const {
  const GLuint index = glGetUniformBlockIndex(name(), block_name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(name(), index, point);
}

}  // namespace hooke::picture
