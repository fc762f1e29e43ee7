#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace hada {

/// One nodegraph of a MaterialX document, read as version 1.38 defines its nodes
/// (libraries/stdlib/stdlib_defs.mtlx) and worked out at a place. What that does not define, a
/// node, an input or a link of another type, is an error.
class MaterialxGraph {
 public:
  using Value = std::array<double, 3>;
  /// What a picture shows at (u, v), the origin at its lower left.
  using Look = std::function<Value(const std::string& file, double u, double v,
                                   const std::string& across, const std::string& up)>;

  MaterialxGraph(const std::string& document, const std::string& name) {
    const std::regex part("<nodegraph name=\"" + name + "\">([^]*?)</nodegraph>");
    std::smatch found;
    if (!std::regex_search(document, found, part)) throw std::runtime_error("no graph " + name);
    const std::string body = found[1];
    const std::regex tag("<(/?)([a-z0-9_]+)((?:\\s+[a-z]+=\"[^\"]*\")*)\\s*(/?)>");
    std::string open;
    for (std::sregex_iterator it(body.begin(), body.end(), tag), end; it != end; ++it) {
      const std::string element = (*it)[2];
      auto with = attributes((*it)[3]);
      if ((*it)[1] == "/") {
        open.clear();
      } else if (element == "input") {
        add_input(nodes_.at(open), with);
      } else if (element == "output") {
        out_ = with.at("nodename");
        if (nodes_.at(out_).type != with.at("type")) throw std::runtime_error("type of output");
      } else {
        open = with.at("name");
        if (!inputs_of(element, with.at("type"))) throw std::runtime_error("no node " + element);
        if (!nodes_.insert({open, {element, with.at("type"), {}}}).second)
          throw std::runtime_error("two nodes " + open);
        if ((*it)[4] == "/") open.clear();
      }
    }
  }

  Value value_at(const Value& place, const Look& look) const {
    std::map<std::string, Value> known;
    return value_of(out_, place, look, known);
  }

 private:
  using Attributes = std::map<std::string, std::string>;

  struct Input {
    std::string type, value, node;
  };
  struct Node {
    std::string category, type;
    std::map<std::string, Input> inputs;
  };

  static Attributes attributes(const std::string& text) {
    Attributes found;
    const std::regex pair("([a-z]+)=\"([^\"]*)\"");
    for (std::sregex_iterator it(text.begin(), text.end(), pair), end; it != end; ++it)
      found[(*it)[1]] = (*it)[2];
    return found;
  }

  /// Names and types of the inputs of a node; null if there is none of this type.
  static const Attributes* inputs_of(const std::string& category, const std::string& type) {
    static const Attributes two = {{"in1", "float"}, {"in2", "float"}}, one = {{"in", "float"}};
    static const Attributes image = {{"file", "filename"},       {"texcoord", "vector2"},
                                     {"uaddressmode", "string"}, {"vaddressmode", "string"},
                                     {"filtertype", "string"},   {"default", type}};
    static const std::map<std::string, std::pair<std::string, Attributes>> others = {
        {"position", {"vector3", {{"space", "string"}}}},
        {"extract", {"float", {{"in", "vector3"}, {"index", "integer"}}}},
        {"constant", {"float", {{"value", "float"}}}},
        {"combine2", {"vector2", two}},
        {"add", {"float", two}},
        {"subtract", {"float", two}},
        {"multiply", {"float", two}},
        {"divide", {"float", two}},
        {"modulo", {"float", two}},
        {"min", {"float", two}},
        {"max", {"float", two}},
        {"atan2", {"float", two}},
        {"sin", {"float", one}},
        {"cos", {"float", one}},
        {"sqrt", {"float", one}}};
    if (category == "image") return type == "float" || type == "color3" ? &image : nullptr;
    const auto found = others.find(category);
    return found != others.end() && found->second.first == type ? &found->second.second : nullptr;
  }

  void add_input(Node& node, const Attributes& with) const {
    const auto& allowed = *inputs_of(node.category, node.type);
    const std::string &name = with.at("name"), &type = with.at("type");
    if (!allowed.count(name) || allowed.at(name) != type)
      throw std::runtime_error("no input " + name + " of type " + type + " at " + node.category);
    Input input{type, "", ""};
    if (with.count("nodename")) {
      input.node = with.at("nodename");
      if (nodes_.at(input.node).type != type) throw std::runtime_error("type of " + input.node);
    } else {
      input.value = with.at("value");
    }
    node.inputs[name] = input;
  }

  Value value_of(const std::string& name, const Value& place, const Look& look,
                 std::map<std::string, Value>& known) const {
    if (const auto found = known.find(name); found != known.end()) return found->second;
    const Node& node = nodes_.at(name);
    const auto text = [&](const char* input, const char* otherwise) {
      const auto found = node.inputs.find(input);
      return found == node.inputs.end() ? std::string(otherwise) : found->second.value;
    };
    const auto read = [&](const char* input, double otherwise) -> Value {
      const auto found = node.inputs.find(input);
      if (found == node.inputs.end()) return {otherwise, 0.0, 0.0};
      if (!found->second.node.empty()) return value_of(found->second.node, place, look, known);
      return {std::stod(found->second.value), 0.0, 0.0};
    };
    const std::string& category = node.category;
    const double second = category == "multiply" || category == "divide" || category == "modulo" ||
                                  category == "atan2"
                              ? 1.0
                              : 0.0;
    const double a = read(category == "constant" ? "value" : "in1", 0.0)[0];
    const double b = read("in2", second)[0];
    Value value{};
    if (category == "position") {
      if (text("space", "object") != "object") throw std::runtime_error("space");
      value = place;
    } else if (category == "extract") {
      value[0] = read("in", 0.0).at(std::stoul(text("index", "0")));
    } else if (category == "constant") {
      value[0] = a;
    } else if (category == "combine2") {
      value = {a, b, 0.0};
    } else if (category == "image") {
      const Value at = read("texcoord", 0.0);
      value = look(text("file", ""), at[0], at[1], text("uaddressmode", "periodic"),
                   text("vaddressmode", "periodic"));
    } else if (category == "sin" || category == "cos" || category == "sqrt") {
      const double in = read("in", 0.0)[0];
      value[0] = category == "sin"   ? std::sin(in)
                 : category == "cos" ? std::cos(in)
                                     : std::sqrt(in);
    } else {
      value[0] = category == "add"        ? a + b
                 : category == "subtract" ? a - b
                 : category == "multiply" ? a * b
                 : category == "divide"   ? a / b
                 : category == "modulo"   ? a - b * std::floor(a / b)
                 : category == "min"      ? std::fmin(a, b)
                 : category == "max"      ? std::fmax(a, b)
                                          : std::atan2(a, b);
    }
    return known[name] = value;
  }

  std::map<std::string, Node> nodes_;
  std::string out_;
};

}  // namespace hada
