#include "refinement/sheets.h"

#include <random>

namespace hooke::bench {
namespace {

/// Of springs that do not ask for the mesh: right in the middle of a grid.
constexpr double naive_stretch = 0.75 * study_material.modulus, naive_shear = 0.375 * study_material.modulus;

SheetLaw law_of(Mode mode) {
  if (mode == Mode::springs) return CalibratedSprings{study_material};
  if (mode == Mode::triangles) return TensileSheet{study_material};
  return NaiveSprings{};
}

/// Corners on the rim stay on it, those of the sheet where they are.
std::vector<Vec3> vertices_of(const SheetShape& shape, Pattern pattern) {
  std::mt19937 random(20240229);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  std::vector<Vec3> vertices;
  for (Index j = 0; j <= shape.rows; ++j) {
    for (Index i = 0; i <= shape.columns; ++i) {
      double x = i, y = j;
      if (pattern == Pattern::jittered) {
        const double along_x = jitter(random), along_y = jitter(random);
        if (i > 0 && i < shape.columns) x += along_x;
        if (j > 0 && j < shape.rows) y += along_y;
      }
      vertices.emplace_back(shape.cell * x, -shape.cell * y, 0.0);
    }
  }
  return vertices;
}

double angle_at(const Vec3& corner, const Vec3& a, const Vec3& b) {
  return std::acos((a - corner).normalized().dot((b - corner).normalized()));
}

ClothMesh mesh_of(const SheetShape& shape, Pattern pattern) {
  ClothMesh mesh{.vertices = vertices_of(shape, pattern)};
  for (Index j = 0; j < shape.rows; ++j) {
    for (Index i = 0; i < shape.columns; ++i) {
      const Index a = shape.particle(i, j), b = shape.particle(i + 1, j), c = shape.particle(i, j + 1),
                  d = shape.particle(i + 1, j + 1);
      const auto& x = mesh.vertices;
      const bool from_b_to_c =
          pattern == Pattern::structured || (pattern == Pattern::alternating && (i + j) % 2 == 0) ||
          (pattern == Pattern::jittered && angle_at(x[a], x[b], x[c]) + angle_at(x[d], x[b], x[c]) <
                                               angle_at(x[b], x[a], x[d]) + angle_at(x[c], x[a], x[d]));
      if (from_b_to_c) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {b, c, d}});
      } else {
        mesh.triangles.insert(mesh.triangles.end(), {{a, c, d}, {a, d, b}});
      }
    }
  }
  return mesh;
}

}  // namespace

std::string_view to_string(Pattern pattern) {
  constexpr std::array names{"grid", "structured", "alternating", "jittered"};
  return names[std::size_t(pattern)];
}

std::string_view to_string(Mode mode) {
  constexpr std::array names{"naive", "springs", "triangles"};
  return names[std::size_t(mode)];
}

Scene make_sheet(const SheetShape& shape, Pattern pattern, Mode mode) {
  Scene scene;
  if (pattern == Pattern::grid) {
    add(scene, ClothGrid{.columns = shape.columns + 1,
                         .rows = shape.rows + 1,
                         .spacing = shape.cell,
                         .areal_density = study_material.areal_density,
                         .stretch = naive_stretch,
                         .shear = naive_shear,
                         .bend = 0.0,
                         .law = law_of(mode)});
  } else {
    ClothMesh mesh = mesh_of(shape, pattern);
    mesh.areal_density = study_material.areal_density;
    mesh.stretch = naive_stretch;
    mesh.bend = 0.0;
    mesh.law = law_of(mode);
    add(scene, mesh);
  }
  return scene;
}

}  // namespace hooke::bench
