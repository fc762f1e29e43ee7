#include "app/materialx_file.h"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace hada {
namespace {

using Op = NodeGraph::Op;

/// How MaterialX calls an operation, and the names of what it works with.
struct Category {
  const char* name;
  std::array<const char*, 2> inputs;
};

Category category_of(Op op) {
  switch (op) {
    case Op::add:
      return {"add", {"in1", "in2"}};
    case Op::subtract:
      return {"subtract", {"in1", "in2"}};
    case Op::multiply:
      return {"multiply", {"in1", "in2"}};
    case Op::divide:
      return {"divide", {"in1", "in2"}};
    case Op::least:
      return {"min", {"in1", "in2"}};
    case Op::most:
      return {"max", {"in1", "in2"}};
    case Op::arctangent:
      return {"atan2", {"in1", "in2"}};
    case Op::sine:
      return {"sin", {"in", nullptr}};
    case Op::cosine:
      return {"cos", {"in", nullptr}};
    case Op::root:
      return {"sqrt", {"in", nullptr}};
    case Op::fraction:
      return {"modulo", {"in1", nullptr}};  // by 1, its default
    default:
      return {"", {nullptr, nullptr}};
  }
}

std::string from_node(const char* input, int id) {
  return fmt::format("      <input name=\"{}\" type=\"float\" nodename=\"n{}\" />\n", input, id);
}

std::string node_text(const NodeGraph::Node& node, int id, bool last) {
  switch (node.op) {
    case Op::number:
      return fmt::format(
          "    <constant name=\"n{}\" type=\"float\">\n"
          "      <input name=\"value\" type=\"float\" value=\"{}\" />\n    </constant>\n",
          id, node.value);
    case Op::x:
    case Op::y:
    case Op::z:
      return fmt::format(
          "    <extract name=\"n{}\" type=\"float\">\n"
          "      <input name=\"in\" type=\"vector3\" nodename=\"place\" />\n"
          "      <input name=\"index\" type=\"integer\" value=\"{}\" />\n    </extract>\n",
          id, int(node.op) - int(Op::x));
    case Op::lookup:
      return fmt::format(
                 "    <combine2 name=\"uv{0}\" type=\"vector2\">\n{1}{2}    </combine2>\n"
                 "    <image name=\"n{0}\" type=\"{3}\">\n"
                 "      <input name=\"file\" type=\"filename\" value=\"{4}.exr\" />\n",
                 id, from_node("in1", node.in[0]), from_node("in2", node.in[1]),
                 last ? "color3" : "float", node.picture) +
             fmt::format(
                 "      <input name=\"texcoord\" type=\"vector2\" nodename=\"uv{}\" />\n"
                 "      <input name=\"uaddressmode\" type=\"string\" value=\"clamp\" />\n"
                 "      <input name=\"vaddressmode\" type=\"string\" value=\"periodic\" />\n"
                 "      <input name=\"filtertype\" type=\"string\" value=\"linear\" />\n"
                 "    </image>\n",
                 id);
    default: {
      const Category category = category_of(node.op);
      std::string text = fmt::format("    <{} name=\"n{}\" type=\"float\">\n", category.name, id);
      for (std::size_t k = 0; k < 2; ++k) {
        if (category.inputs[k]) text += from_node(category.inputs[k], node.in[k]);
      }
      return text + fmt::format("    </{}>\n", category.name);
    }
  }
}

/// A shader whose colour comes from the nodegraph `graph`, and the material `name` that wears it.
std::string material_text(const std::string& name, const std::string& graph) {
  return fmt::format(
      "  <standard_surface name=\"{0}_surface\" type=\"surfaceshader\">\n"
      "    <input name=\"base\" type=\"float\" value=\"1\" />\n"
      "    <input name=\"base_color\" type=\"color3\" nodegraph=\"{1}\" output=\"colour\" />\n"
      "    <input name=\"specular_roughness\" type=\"float\" value=\"0.5\" />\n"
      "  </standard_surface>\n"
      "  <surfacematerial name=\"{0}\" type=\"material\">\n"
      "    <input name=\"surfaceshader\" type=\"surfaceshader\" nodename=\"{0}_surface\" />\n"
      "  </surfacematerial>\n",
      name, graph);
}

}  // namespace

std::string materialx_document(const WoodGraph& graph, const std::string& cut_map) {
  const auto& nodes = graph.nodes.nodes();
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<!-- Made by hada: a stem of wood. \"wood\" carves a mesh out of it, 1 unit 1 mm, z up the "
      "stem; \"cut\" lays the map of one cut over the texture coordinates. -->\n"
      "<materialx version=\"1.38\" colorspace=\"lin_rec709\">\n"
      "  <nodegraph name=\"stem\">\n"
      "    <position name=\"place\" type=\"vector3\">\n"
      "      <input name=\"space\" type=\"string\" value=\"object\" />\n    </position>\n";
  for (std::size_t k = 0; k < nodes.size(); ++k)
    text += node_text(nodes[k], int(k), k + 1 == nodes.size());
  text += fmt::format(
      "    <output name=\"colour\" type=\"color3\" nodename=\"n{}\" />\n  </nodegraph>\n",
      nodes.size() - 1);
  text += fmt::format(
      "  <nodegraph name=\"map\">\n"
      "    <image name=\"picture\" type=\"color3\">\n"
      "      <input name=\"file\" type=\"filename\" value=\"{}\" />\n    </image>\n"
      "    <output name=\"colour\" type=\"color3\" nodename=\"picture\" />\n  </nodegraph>\n",
      cut_map);
  return text + material_text("wood", "stem") + material_text("cut", "map") + "</materialx>\n";
}

}  // namespace hada
