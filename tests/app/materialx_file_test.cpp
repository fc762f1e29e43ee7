#include "app/materialx_file.h"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "synth/wood_solid.h"
#include "tests/app/materialx_graph.h"
#include "tests/synth/slanted_stem.h"

namespace hada {
namespace {

constexpr Extent extent{.rows = 20, .cols = 24, .pitch = 1.0, .unit = Unit::mm};

std::string document() {
  Wood<> wood;
  wood.wave_amplitude = 0.1;
  wood.interlock_amplitude = 0.1;
  return materialx_document(wood_graph(wood, extent, 1), "albedo.exr");
}

TEST(MaterialxDocument, ReadsNodesThatComeBefore) {
  const std::string text = document();
  const std::regex word("(name|nodename|nodegraph)=\"([^\"]+)\"");
  std::set<std::string> known;
  int links = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
    if ((*it)[1] == "name") {
      known.insert((*it)[2]);
    } else {
      EXPECT_TRUE(known.count((*it)[2])) << (*it)[2];
      ++links;
    }
  }
  EXPECT_GT(links, 50);
}

TEST(MaterialxDocument, ClosesWhatItOpens) {
  const std::string text = document();
  const std::regex tag("<(/?)([a-z0-9_]+)[^>]*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    if ((*it)[3] == "/") continue;
    if ((*it)[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), (*it)[2]);
      open.pop_back();
    } else {
      open.push_back((*it)[2]);
    }
  }
  EXPECT_TRUE(open.empty());
}

TEST(MaterialxDocument, NamesItsPictures) {
  const std::string text = document();
  for (const char* name : {"section.exr", "lean.exr", "albedo.exr"})
    EXPECT_NE(text.find(std::string("value=\"") + name + "\""), std::string::npos) << name;
}

/// Linear between texels, origin at the lower left; a side is held or endless as `mode` says.
MaterialxGraph::Value looked_up(const Image& picture, double u, double v, const std::string& across,
                                const std::string& up) {
  const auto placed = [](int k, int count, const std::string& mode) {
    if (mode == "periodic") return (k % count + count) % count;
    if (mode != "clamp") throw std::runtime_error(mode);
    return std::clamp(k, 0, count - 1);
  };
  const int rows = picture.rows(), cols = picture.cols();
  const double x = u * cols - 0.5, y = (1.0 - v) * rows - 0.5;
  const int col = int(std::floor(x)), row = int(std::floor(y));
  const double right = x - col, down = y - row;
  MaterialxGraph::Value value{};
  for (std::size_t c = 0; c < picture.planes.size(); ++c) {
    for (int k = 0; k < 4; ++k) {
      const double share = (k / 2 ? down : 1.0 - down) * (k % 2 ? right : 1.0 - right);
      value[c] += share * double(picture.planes[c](placed(row + k / 2, rows, up),
                                                   placed(col + k % 2, cols, across)));
    }
  }
  return value;
}

TEST(MaterialxDocument, GivesTheColourOfTheSolid) {
  const Wood<> wood = slanted_stem();
  constexpr Extent fine{.rows = 160, .cols = 200, .pitch = 0.1, .unit = Unit::mm};
  const auto graph = wood_graph(wood, fine, 5);
  const MaterialxGraph read(materialx_document(graph, "albedo.exr"), "stem");
  const WoodSolid solid(wood, 5);
  const Cut cut = cut_of(wood);
  double sum = 0.0;
  int count = 0;
  for (int row = 2; row < fine.rows; row += 12) {
    for (int col = 2; col < fine.cols; col += 12) {
      const auto place = fine.place(row, col);
      const StemVector at = cut.at(place.x(), place.y());
      const auto seen = read.value_at(
          at, [&](const std::string& file, double u, double v, const auto& across, const auto& up) {
            return looked_up(graph.pictures.at(file.substr(0, file.find('.'))), u, v, across, up);
          });
      const auto colour = solid.colour_at(solid.place_at(at), 0.05);
      for (std::size_t c = 0; c < 3; ++c, ++count) sum += std::abs(seen[c] - double(colour[c]));
    }
  }
  // As the graph itself: only boundaries of rings between two texels differ. Another turn of the
  // fibres would show as 0.01 and more.
  EXPECT_LT(sum / count, 0.006);
}

TEST(MaterialxDocument, HasNothingThatMaterialxDoesNotDefine) {
  const std::string text = document();
  EXPECT_NO_THROW(MaterialxGraph(text, "stem"));
  // Version 1.39 calls the inputs of atan2 otherwise; the document says that it is of 1.38.
  const auto with = [&](const char* from, const char* to) {
    return MaterialxGraph(std::regex_replace(text, std::regex(from), to), "stem");
  };
  EXPECT_ANY_THROW(with("<(/?)atan2", "<$1arctan2"));
  EXPECT_ANY_THROW(with("name=\"in1\"", "name=\"iny\""));
  EXPECT_ANY_THROW(
      with("<image name=\"(n[0-9]+)\" type=\"color3\"", "<image name=\"$1\" type=\"float\""));
}

TEST(MaterialxDocument, ReadsTheMapOfTheCut) {
  const MaterialxGraph read(document(), "map");
  std::string seen;
  read.value_at({0.0, 0.0, 0.0}, [&](const std::string& file, auto&&...) {
    seen = file;
    return MaterialxGraph::Value{};
  });
  EXPECT_EQ(seen, "albedo.exr");
}

}  // namespace
}  // namespace hada
