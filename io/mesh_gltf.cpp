#include <cmath>
#include <cstring>
#include <sstream>

#include <Eigen/Geometry>
#include <tiny_gltf.h>

#include "core/error.h"
#include "io/mesh_formats.h"

namespace hada {
namespace {

constexpr double mm_per_metre = 1000.0;

// Pictures are none of a mesh's business, and need not be there.
bool skip_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*,
                int, void*) {
  return true;
}

template <class Items>
const auto& item(const Items& items, int at, const std::string& name, const char* what) {
  if (at < 0 || std::size_t(at) >= items.size()) {
    throw Error(name + ": names a " + what + " that it does not have; export the mesh again");
  }
  return items[std::size_t(at)];
}

// Numbers of an accessor, with every offset checked: the file may lie about all of them.
struct Numbers {
  const tinygltf::Model& model;
  const tinygltf::Accessor& accessor;
  const unsigned char* first = nullptr;
  std::size_t stride = 0;

  Numbers(const tinygltf::Model& from, int at, int type, const std::string& name)
      : model(from), accessor(item(from.accessors, at, name, "set of numbers")) {
    const auto fail = [&](const std::string& what) { throw Error(name + ": " + what); };
    const auto& view = item(model.bufferViews, accessor.bufferView, name, "part of a buffer");
    const auto& data = item(model.buffers, view.buffer, name, "buffer").data;
    if (accessor.type != type || accessor.sparse.isSparse) fail("stores numbers in a way not read");
    const int each = tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType));
    const int parts = tinygltf::GetNumComponentsInType(std::uint32_t(type));
    if (each <= 0 || parts <= 0) fail("stores numbers of an unknown kind");
    const std::size_t bytes = std::size_t(each) * std::size_t(parts);
    stride = view.byteStride == 0 ? bytes : view.byteStride;
    const std::size_t begin = view.byteOffset + accessor.byteOffset;
    if (stride < bytes || begin < view.byteOffset || begin > data.size() ||
        (accessor.count > 0 && (data.size() - begin < bytes ||
                                accessor.count - 1 > (data.size() - begin - bytes) / stride))) {
      fail("a buffer ends early; copy the file again");
    }
    first = data.data() + begin;
  }

  double at(std::size_t index, std::size_t part) const {
    const auto as = [&](auto value) {
      std::memcpy(&value, first + index * stride + part * sizeof value, sizeof value);
      return double(value);
    };
    const double shrink = accessor.normalized ? 1.0 : 0.0;
    switch (accessor.componentType) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return as(std::uint8_t{}) / (1.0 + 254.0 * shrink);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return as(std::uint16_t{}) / (1.0 + 65534.0 * shrink);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return as(std::uint32_t{});
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return as(float{});
      default:
        return std::nan("");
    }
  }
};

Eigen::Affine3d transform_of(const tinygltf::Node& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.matrix.size() == 16) {
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    return transform;
  }
  if (node.translation.size() == 3) {
    transform.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
  }
  if (node.rotation.size() == 4) {
    const auto& q = node.rotation;
    transform.rotate(Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized());
  }
  if (node.scale.size() == 3) {
    transform.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
  }
  return transform;
}

struct GltfReader {
  const tinygltf::Model& model;
  const std::string& name;
  TriangleMesh mesh;
  bool all_uv = true;
  std::vector<bool> seen = std::vector<bool>(model.nodes.size(), false);

  void add(const tinygltf::Primitive& primitive, const Eigen::Affine3d& transform) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) return;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return;
    const int base = int(mesh.vertices_mm.size());
    const Numbers places(model, position->second, TINYGLTF_TYPE_VEC3, name);
    for (std::size_t k = 0; k < places.accessor.count; ++k) {
      const Eigen::Vector3d place(places.at(k, 0), places.at(k, 1), places.at(k, 2));
      mesh.vertices_mm.push_back(mm_per_metre * (transform * place));
    }
    const auto texture = primitive.attributes.find("TEXCOORD_0");
    all_uv = all_uv && texture != primitive.attributes.end();
    if (all_uv) {
      const Numbers uv(model, texture->second, TINYGLTF_TYPE_VEC2, name);
      for (std::size_t k = 0; k < uv.accessor.count; ++k) {
        mesh.uv.emplace_back(uv.at(k, 0), 1.0 - uv.at(k, 1));  // glTF counts v downward
      }
    }
    std::vector<int> corners(places.accessor.count);
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = int(k);
    if (primitive.indices >= 0) {
      const Numbers indices(model, primitive.indices, TINYGLTF_TYPE_SCALAR, name);
      corners.resize(indices.accessor.count);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const double at = indices.at(k, 0);
        if (!(at >= 0.0 && at < double(places.accessor.count))) {
          throw Error(name + ": a face names a vertex that is not there; export the mesh again");
        }
        corners[k] = int(at);
      }
    }
    for (std::size_t k = 2; k < corners.size(); k += 3) {
      mesh.triangles.push_back({base + corners[k - 2], base + corners[k - 1], base + corners[k]});
    }
  }

  void visit(int at, const Eigen::Affine3d& parent, int depth) {
    constexpr int deepest = 256;
    const auto& node = item(model.nodes, at, name, "node");
    if (seen[std::size_t(at)] || depth > deepest) {
      throw Error(name + ": its nodes do not form a tree; export the mesh again");
    }
    seen[std::size_t(at)] = true;
    const Eigen::Affine3d transform = parent * transform_of(node);
    if (node.mesh >= 0) {
      const auto& shape = item(model.meshes, node.mesh, name, "mesh");
      for (const auto& primitive : shape.primitives) add(primitive, transform);
    }
    for (const int child : node.children) visit(child, transform, depth + 1);
  }
};

int add_buffer_view(tinygltf::Model& model, const std::vector<float>& numbers, int target) {
  auto& data = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = numbers.size() * sizeof(float);
  view.target = target;
  const auto* bytes = reinterpret_cast<const unsigned char*>(numbers.data());
  data.insert(data.end(), bytes, bytes + view.byteLength);
  model.bufferViews.push_back(view);
  return int(model.bufferViews.size()) - 1;
}

tinygltf::Accessor accessor_of(int view, int component, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  return accessor;
}

int add_texture(tinygltf::Model& model, const std::string& picture) {
  if (picture.empty()) return -1;
  tinygltf::Image image;
  image.uri = picture;
  model.images.push_back(image);
  tinygltf::Texture texture;
  texture.source = int(model.images.size()) - 1;
  model.textures.push_back(texture);
  return int(model.textures.size()) - 1;
}

tinygltf::Material material_of(tinygltf::Model& model, const MeshLook& look) {
  tinygltf::Material material;
  material.doubleSided = true;
  if (look.see_through) material.alphaMode = "BLEND";
  material.pbrMetallicRoughness.metallicFactor = look.metallic;
  material.pbrMetallicRoughness.roughnessFactor = look.roughness;
  material.pbrMetallicRoughness.baseColorTexture.index = add_texture(model, look.base_color);
  material.pbrMetallicRoughness.metallicRoughnessTexture.index =
      add_texture(model, look.metallic_roughness);
  material.normalTexture.index = add_texture(model, look.normal);
  return material;
}

void add_places(tinygltf::Model& model, const TriangleMesh& mesh, tinygltf::Primitive& primitive) {
  std::vector<float> numbers;
  Eigen::Vector3f low = Eigen::Vector3f::Constant(INFINITY), high = -low;
  for (const auto& vertex : mesh.vertices_mm) {
    const Eigen::Vector3f place = (vertex / mm_per_metre).cast<float>();
    numbers.insert(numbers.end(), place.begin(), place.end());
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const int view = add_buffer_view(model, numbers, TINYGLTF_TARGET_ARRAY_BUFFER);
  auto accessor =
      accessor_of(view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, mesh.vertices_mm.size());
  accessor.minValues.assign(low.begin(), low.end());
  accessor.maxValues.assign(high.begin(), high.end());
  model.accessors.push_back(accessor);
  primitive.attributes["POSITION"] = int(model.accessors.size()) - 1;
}

void add_uv(tinygltf::Model& model, const TriangleMesh& mesh, tinygltf::Primitive& primitive) {
  std::vector<float> numbers;
  for (const auto& uv : mesh.uv) {
    numbers.push_back(float(uv.x()));
    numbers.push_back(float(1.0 - uv.y()));
  }
  const int view = add_buffer_view(model, numbers, TINYGLTF_TARGET_ARRAY_BUFFER);
  model.accessors.push_back(
      accessor_of(view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, mesh.uv.size()));
  primitive.attributes["TEXCOORD_0"] = int(model.accessors.size()) - 1;
}

void add_corners(tinygltf::Model& model, const TriangleMesh& mesh, tinygltf::Primitive& primitive) {
  std::vector<float> numbers;  // the bytes of whole numbers, both have four
  for (const auto& triangle : mesh.triangles) {
    for (const int corner : triangle) {
      float bits = 0.0f;
      std::memcpy(&bits, &corner, sizeof bits);
      numbers.push_back(bits);
    }
  }
  const int view = add_buffer_view(model, numbers, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  model.accessors.push_back(accessor_of(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                        TINYGLTF_TYPE_SCALAR, 3 * mesh.triangles.size()));
  primitive.indices = int(model.accessors.size()) - 1;
}

}  // namespace

TriangleMesh mesh_from_gltf(std::string_view bytes, const std::string& name,
                            const std::filesystem::path& folder) {
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(skip_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  bool good = false;
  try {
    good = bytes.starts_with("glTF")
               ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                             reinterpret_cast<const unsigned char*>(bytes.data()),
                                             unsigned(bytes.size()), folder.string())
               : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(),
                                            unsigned(bytes.size()), folder.string());
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!good) {
    const std::string first_line = error.substr(0, error.find('\n'));
    throw Error(name + ": is no whole glTF file (" + first_line + "); export the mesh again");
  }
  GltfReader reader{model, name, {}};
  const int scene = std::max(model.defaultScene, 0);
  if (model.scenes.empty()) {
    for (const auto& shape : model.meshes) {
      for (const auto& part : shape.primitives) reader.add(part, Eigen::Affine3d::Identity());
    }
  } else {
    for (const int node : item(model.scenes, scene, name, "scene").nodes) {
      reader.visit(node, Eigen::Affine3d::Identity(), 0);
    }
  }
  if (reader.mesh.uv.size() != reader.mesh.vertices_mm.size()) reader.mesh.uv.clear();
  return std::move(reader.mesh);
}

std::string gltf_of(const TriangleMesh& mesh, const MeshLook& look, bool binary) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "hada";
  model.buffers.emplace_back();
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  add_places(model, mesh, primitive);
  if (!mesh.uv.empty()) add_uv(model, mesh, primitive);
  add_corners(model, mesh, primitive);
  model.materials.push_back(material_of(model, look));
  model.meshes.emplace_back().primitives.push_back(primitive);
  model.nodes.emplace_back().mesh = 0;
  model.scenes.emplace_back().nodes.push_back(0);
  model.defaultScene = 0;
  std::ostringstream stream;
  tinygltf::TinyGLTF writer;
  writer.SetImageWriter(nullptr, nullptr);
  if (!writer.WriteGltfSceneToStream(&model, stream, true, binary)) {
    throw Error("the mesh cannot be written as glTF; choose .obj or .ply");
  }
  return stream.str();
}

}  // namespace hada
