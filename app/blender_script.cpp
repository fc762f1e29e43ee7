#include "app/blender_script.h"

#include <utility>

#include <fmt/format.h>

namespace hada {
namespace {

using Op = NodeGraph::Op;

constexpr const char* head =
    R"(# Made by hada for Blender 3.4: a stem of wood, solid, as a material of native nodes.
#
#   blender -P wood.py                                 opens the stem and the cut that hada made
#   blender -b -P wood.py -- --render slice.exr        draws that cut, linear, as hada sees it
#
# One unit is one mm. Give the material "hada wood" to any mesh: it is carved out of the stem, whose
# frame is that of the object: x and y span the end grain, z runs up the stem.
# The pictures (NAME.exr) must lie beside this script; "section" is what the fibres meet at z = 0.
import os
import sys

import bpy

)";

constexpr const char* body = R"(
MATH = {"add": "ADD", "subtract": "SUBTRACT", "multiply": "MULTIPLY", "divide": "DIVIDE",
        "least": "MINIMUM", "most": "MAXIMUM", "sine": "SINE", "cosine": "COSINE",
        "arctangent": "ARCTAN2", "root": "SQRT", "fraction": "FRACT"}


def picture(tree, name):
    node = tree.nodes.new("ShaderNodeTexImage")
    folder = os.path.dirname(os.path.abspath(__file__))
    node.image = bpy.data.images.load(os.path.join(folder, name + ".exr"))
    node.image.colorspace_settings.name = "Non-Color"  # linear already
    node.interpolation, node.extension = "Linear", "REPEAT"
    return node


def wood_colour(tree):
    """The socket with the colour of the stem, at the coordinates of the object."""
    axes = tree.nodes.new("ShaderNodeSeparateXYZ")
    place = tree.nodes.new("ShaderNodeTexCoord")
    tree.links.new(place.outputs["Object"], axes.inputs[0])
    sockets = []
    for k, (kind, *given) in enumerate(NODES):
        if kind in ("x", "y", "z"):
            socket = axes.outputs[kind.upper()]
        elif kind == "number":
            node = tree.nodes.new("ShaderNodeValue")
            node.outputs[0].default_value = given[0]
            socket = node.outputs[0]
        elif kind == "lookup":
            joined = tree.nodes.new("ShaderNodeCombineXYZ")
            tree.links.new(sockets[given[1]], joined.inputs[0])
            tree.links.new(sockets[given[2]], joined.inputs[1])
            node = picture(tree, given[0])
            tree.links.new(joined.outputs[0], node.inputs["Vector"])
            socket = node.outputs["Color"]
        else:
            node = tree.nodes.new("ShaderNodeMath")
            node.operation = MATH[kind]
            for into, a in zip(node.inputs, given):
                tree.links.new(sockets[a], into)
            socket = node.outputs[0]
        socket.node.location = (200 * (k // 12), -160 * (k % 12))
        sockets.append(socket)
    return sockets[-1]


def wood_material(shines):
    material = bpy.data.materials.new("hada wood" if shines else "hada wood, colour only")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    colour = wood_colour(tree)
    shader = tree.nodes.new("ShaderNodeBsdfPrincipled" if shines else "ShaderNodeEmission")
    if shines:
        shader.inputs["Roughness"].default_value = 0.5
    tree.links.new(colour, shader.inputs["Base Color" if shines else "Color"])
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return material


def cut(material):
    mesh = bpy.data.meshes.new("cut")
    mesh.from_pydata(CORNERS, [], [(0, 1, 2, 3)])
    mesh.materials.append(material)
    scene_object = bpy.data.objects.new("cut", mesh)
    bpy.context.scene.collection.objects.link(scene_object)
    return scene_object


def camera():
    """Looks straight at the cut, which fills the picture."""
    from mathutils import Matrix
    data = bpy.data.cameras.new("above the cut")
    data.type = "ORTHO"
    data.ortho_scale = max(WIDTH_PX, HEIGHT_PX) * PITCH_MM
    distance = data.ortho_scale
    data.clip_end = 2.0 * distance
    view = bpy.data.objects.new("above the cut", data)
    place = [o + distance * e for o, e in zip(ORIGIN, EYE)]
    columns = (RIGHT, UP, EYE, place)
    rows = [[column[k] for column in columns] for k in range(3)] + [[0.0, 0.0, 0.0, 1.0]]
    view.matrix_world = Matrix(rows)
    bpy.context.scene.collection.objects.link(view)
    bpy.context.scene.camera = view


def render(path):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 0.01  # the middle of each pixel
    scene.render.resolution_x, scene.render.resolution_y = WIDTH_PX, HEIGHT_PX
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = os.path.abspath(path)
    bpy.ops.render.render(write_still=True)


for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
words = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
drawn = "--render" in words
cut(wood_material(shines=not drawn))
camera()
if drawn:
    render(words[words.index("--render") + 1])
)";

const char* word_of(Op op) {
  constexpr std::pair<Op, const char*> words[] = {{Op::number, "number"},
                                                  {Op::x, "x"},
                                                  {Op::y, "y"},
                                                  {Op::z, "z"},
                                                  {Op::add, "add"},
                                                  {Op::subtract, "subtract"},
                                                  {Op::multiply, "multiply"},
                                                  {Op::divide, "divide"},
                                                  {Op::least, "least"},
                                                  {Op::most, "most"},
                                                  {Op::sine, "sine"},
                                                  {Op::cosine, "cosine"},
                                                  {Op::arctangent, "arctangent"},
                                                  {Op::root, "root"},
                                                  {Op::fraction, "fraction"},
                                                  {Op::lookup, "lookup"}};
  for (const auto& [known, word] : words) {
    if (known == op) return word;
  }
  return "";
}

std::string row_of(const NodeGraph::Node& node) {
  const std::string kind = word_of(node.op);
  switch (node.op) {
    case Op::number:
      return fmt::format("    (\"{}\", {}),\n", kind, node.value);
    case Op::x:
    case Op::y:
    case Op::z:
      return fmt::format("    (\"{}\",),\n", kind);
    case Op::lookup:
      return fmt::format("    (\"{}\", \"{}\", {}, {}),\n", kind, node.picture, node.in[0],
                         node.in[1]);
    case Op::sine:
    case Op::cosine:
    case Op::root:
    case Op::fraction:
      return fmt::format("    (\"{}\", {}),\n", kind, node.in[0]);
    default:
      return fmt::format("    (\"{}\", {}, {}),\n", kind, node.in[0], node.in[1]);
  }
}

std::string tuple_of(const StemVector& v) {
  return fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

}  // namespace

std::string blender_script(const WoodGraph& graph, const Wood<>& wood, const Extent& extent) {
  std::string text = head;
  if (!graph.complete)
    text +=
        "# Wobble of the rings and figure are left out: no picture of two coordinates holds "
        "them.\n";
  text += "# Each row is a node: what it is, and the rows or the value it works with.\nNODES = [\n";
  for (const auto& node : graph.nodes.nodes()) text += row_of(node);
  text += "]\n";
  const Cut cut = cut_of(wood);
  const double right = 0.5 * extent.width(), up = 0.5 * extent.height();
  text += fmt::format("WIDTH_PX, HEIGHT_PX, PITCH_MM = {}, {}, {}\n", extent.cols, extent.rows,
                      extent.pitch);
  text += fmt::format("ORIGIN, RIGHT, UP = {}, {}, {}\nEYE = {}  # from the cut towards it\n",
                      tuple_of(cut.origin), tuple_of(cut.right), tuple_of(cut.up),
                      tuple_of(cut.towards_eye()));
  text += fmt::format("CORNERS = [{}, {},\n           {}, {}]\n", tuple_of(cut.at(-right, -up)),
                      tuple_of(cut.at(right, -up)), tuple_of(cut.at(right, up)),
                      tuple_of(cut.at(-right, up)));
  return text + body;
}

}  // namespace hada
