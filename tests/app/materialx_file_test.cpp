#include "app/materialx_file.h"

#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace hada
