#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include <epoxy/gl.h>

/// OpenGL's objects, each deleted with its owner. They need the context that they were made in.

namespace hooke::picture {

/// A name that OpenGL gave out; 0 is none.
template <class Kind>
class GlObject {
 public:
  GlObject() : name_(Kind::make()) {}
  ~GlObject() {
    if (name_ != 0) Kind::remove(name_);
  }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

struct BufferKind {
  static GLuint make();
  static void remove(GLuint name);
};
struct VertexArrayKind {
  static GLuint make();
  static void remove(GLuint name);
};
struct TextureKind {
  static GLuint make();
  static void remove(GLuint name);
};
struct FramebufferKind {
  static GLuint make();
  static void remove(GLuint name);
};
struct RenderbufferKind {
  static GLuint make();
  static void remove(GLuint name);
};
struct ProgramKind {
  static GLuint make();
  static void remove(GLuint name);
};

using VertexArray = GlObject<VertexArrayKind>;
using Texture = GlObject<TextureKind>;
using Framebuffer = GlObject<FramebufferKind>;
using Renderbuffer = GlObject<RenderbufferKind>;

/// Values on the graphics card.
class Buffer : public GlObject<BufferKind> {
 public:
  /// Takes values that stay.
  template <class T>
  void set(GLenum target, std::span<const T> values) {
    put(target, std::as_bytes(values), GL_STATIC_DRAW);
  }

  /// Takes the values of one frame, in fresh memory: the card may still be reading those of the last one.
  template <class T>
  void stream(GLenum target, std::span<const T> values) {
    put(target, std::as_bytes(values), GL_STREAM_DRAW);
  }

 private:
  void put(GLenum target, std::span<const std::byte> bytes, GLenum usage);
};

/// A buffer that shaders read at any place, as a texture.
class BufferTexture : public Texture {
 public:
  BufferTexture(const Buffer& buffer, GLenum format);
  void bind(GLuint unit) const;
};

/// A program of two shaders.
class Program : public GlObject<ProgramKind> {
 public:
  /// Throws PictureError with what the driver says, should it not take them.
  Program(std::string_view vertex, std::string_view fragment);
  void use() const;
  GLint uniform(const char* name) const;
  /// Ties a sampler to a texture unit.
  void sampler(const char* name, GLint unit) const;
  /// Ties a block of uniforms to a binding point.
  void block(const char* name, GLuint point) const;
};

}  // namespace hooke::picture
