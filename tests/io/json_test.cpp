#include "io/json.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/random.h"
#include "tests/io/temporary_folder.h"

namespace hada {
namespace {

using testing::HasSubstr;

std::string error_of_text(const std::string& text) {
  const TemporaryFolder folder;
  put(folder / "a.json", text);
  return error_of([&] { read_json(folder / "a.json", "lights/1"); });
}

TEST(ReadJson, ReturnsTheObjectWithoutItsKind) {
  const TemporaryFolder folder;
  put(folder / "a.json", R"({"hada": "lights/1", "x": [1, 2.5]})");
  const Json json = read_json(folder / "a.json", "lights/1");
  EXPECT_EQ(json.dump(), R"({"x":[1,2.5]})");
}

TEST(ReadJson, NamesWhatIsWrongAndWhere) {
  EXPECT_THAT(error_of_text(R"({"hada": "material/1"})"), HasSubstr("\"material/1\""));
  EXPECT_THAT(error_of_text(R"({"hada": "lights/2"})"), HasSubstr("\"lights/1\" is needed"));
  EXPECT_THAT(error_of_text(R"({"lights": []})"), HasSubstr("does not say what it is"));
  EXPECT_THAT(error_of_text("[1, 2]"), HasSubstr("does not say what it is"));
  EXPECT_THAT(error_of_text("{\"hada\": \"lights/1\",\n  oops}"), HasSubstr("line 2, column 3"));
  EXPECT_THAT(error_of_text(""), HasSubstr("line 1"));
  EXPECT_THAT(error_of_text(R"({"hada": "lights/1", "a": 1, "a": 2})"),
              HasSubstr("\"a\" is given twice"));
  EXPECT_THAT(error_of_text(R"({"hada": "lights/1", "a": NaN})"), HasSubstr("not valid JSON"));
  EXPECT_THAT(error_of_text(R"({"hada": "lights/1", "a": Infinity})"), HasSubstr("not valid"));
  EXPECT_THAT(error_of_text(R"({"hada": "lights/1", "a": 1e999})"), HasSubstr("too large"));
  EXPECT_THAT(error_of_text("{\"hada\": \"lights/1\", \"a\": \"\xff\"}"), HasSubstr("not valid"));
}

TEST(ReadJson, AllowsTheSameKeyInDifferentObjects) {
  EXPECT_EQ(error_of_text(R"({"hada": "lights/1", "a": {"b": 1}, "c": [{"b": 1}, {"b": 2}]})"), "");
}

TEST(ReadJson, RefusesEndlessNesting) {
  const std::string open(1000000, '[');
  EXPECT_THAT(error_of_text(R"({"hada": "lights/1", "a": )" + open), HasSubstr("nested too deep"));
}

TEST(ReadJson, RefusesMissingFilesAndFolders) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { read_json(folder / "no.json", "lights/1"); }), HasSubstr("no such"));
  EXPECT_THAT(error_of([&] { read_json(folder.path(), "lights/1"); }), HasSubstr("not a file"));
}

TEST(ReadJson, RefusesAFileThatIsFarTooLarge) {
  const TemporaryFolder folder;
  put(folder / "a.json", "{");
  std::filesystem::resize_file(folder / "a.json", (64u << 20) + 1);  // sparse: costs no disk
  EXPECT_THAT(error_of([&] { read_json(folder / "a.json", "lights/1"); }), HasSubstr("64 MB"));
}

TEST(JsonObject, ReturnsWhatItsKeysSay) {
  const Json json = Json::parse(
      R"({"n": 2.5, "i": -3, "t": "word", "f": true, "l": [1, 2, 3], "o": {"inner": 1}})");
  JsonObject object(json, "a.json");
  EXPECT_EQ(object.number("n"), 2.5);
  EXPECT_EQ(object.number("none", 7.0), 7.0);
  EXPECT_EQ(object.integer("i"), -3);
  EXPECT_EQ(object.text("t"), "word");
  EXPECT_EQ(object.text("none", "other"), "other");
  EXPECT_TRUE(object.flag("f", false));
  EXPECT_TRUE(object.flag("none", true));
  EXPECT_EQ(object.numbers("l", 3), (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(object.is_list("l"));
  EXPECT_FALSE(object.is_list("n"));
  JsonObject inner = object.object("o");
  EXPECT_EQ(inner.where(), "a.json: o");
  EXPECT_EQ(inner.number("inner"), 1.0);
  EXPECT_NO_THROW(inner.finish());
  EXPECT_NO_THROW(object.finish());
}

TEST(JsonObject, NamesThePlaceAndTheKeyOfEveryFlaw) {
  const Json json = Json::parse(R"({"a": "x", "b": 1.5, "c": [1, "y"], "d": 1e10})");
  JsonObject object(json, "f.json: lights[2]");
  EXPECT_EQ(error_of([&] { object.number("none"); }),
            "f.json: lights[2]: \"none\" is missing; add it");
  EXPECT_THAT(error_of([&] { object.number("a"); }), HasSubstr("\"a\" must be a number"));
  EXPECT_THAT(error_of([&] { object.integer("b"); }), HasSubstr("\"b\" must be a whole number"));
  EXPECT_THAT(error_of([&] { object.integer("d"); }), HasSubstr("\"d\" must be a whole number"));
  EXPECT_THAT(error_of([&] { object.text("b"); }), HasSubstr("\"b\" must be a text"));
  EXPECT_THAT(error_of([&] { object.flag("b", true); }), HasSubstr("true or false"));
  EXPECT_THAT(error_of([&] { object.numbers("c", 2); }), HasSubstr("list of 2 finite numbers"));
  EXPECT_THAT(error_of([&] { object.list("a"); }), HasSubstr("must be a list"));
  EXPECT_THAT(error_of([&] { object.object("b"); }), HasSubstr("must be an object"));
}

TEST(JsonObject, NamesAKeyThatNobodyAskedFor) {
  const Json json = Json::parse(R"({"direction": 1, "directoin": 2})");
  JsonObject object(json, "f.json");
  object.number("direction");
  EXPECT_EQ(error_of([&] { object.finish(); }),
            "f.json: \"directoin\" is not a known key; known are direction");
}

// Whatever happens to a file, reading it ends in an object or in an Error.
RC_GTEST_PROP(ReadJson, SurvivesCutsAndChangedBytes, (std::uint16_t place, char byte, bool cut)) {
  std::string text = R"({"hada": "lights/1", "lights": [{"image": "a.png", "x": [0, -1.5e3]}]})";
  const std::size_t at = place % text.size();
  if (cut)
    text.resize(at);
  else
    text[at] = byte;
  error_of_text(text);
}

template <class T = double>
struct Part {
  T size_mm{1.0};
  static constexpr auto fields() {
    return std::array{Field<Part, T>{"size_mm", &Part::size_mm, 0.1, 10.0, Scale::log, "mm", ""}};
  }
};

template <class T = double>
struct Cloth {
  static constexpr std::string_view name = "cloth";
  T turn_rad{0.5};
  std::vector<Part<T>> parts_list{{}, {}};
  std::vector<T> widths_mm{1.0, 2.0};
  std::string weave = "twill";
  static constexpr auto lists() {
    return std::tuple{
        NumberList<Cloth, T>{"widths_mm", &Cloth::widths_mm, 1, 2, 0.5, 5.0, Scale::log, "mm", ""}};
  }
  static constexpr auto words() {
    return std::array{Word<Cloth>{"weave", &Cloth::weave,
                                  [](std::string_view text) { return text.ends_with("ll"); },
                                  "a weave", ""}};
  }
  static constexpr auto fields() {
    return std::array{
        Field<Cloth, T>{"turn_rad", &Cloth::turn_rad, 0.0, 3.2, Scale::half_turn, "rad", ""}};
  }
  static constexpr auto parts() {
    return std::tuple{PartList<Cloth, Part<T>>{"pieces", &Cloth::parts_list, 1, 3}};
  }
};

template <class T = double>
struct Sail {
  T area_mm2{1.0};
  T bend{0.0};
  static constexpr auto fields() {
    using F = Field<Sail, T>;
    return std::array{F{"area_mm2", &Sail::area_mm2, 0.0, 10.0, Scale::linear, "mm^2", ""},
                      F{"bend", &Sail::bend, -1.0, 1.0, Scale::linear, "", "", true}};
  }
};

TEST(MaterialJson, LeavesOutWhatIsOptionalAndZero) {
  Sail<> sail{.area_mm2 = 0.0};
  EXPECT_EQ(json_of(sail), Json::parse(R"({"area_mm2": 0.0})"));
  const auto plain = material_from<Sail<>>(JsonObject(json_of(sail), "sail.json"));
  EXPECT_EQ(plain.bend, 0.0);
  sail.bend = -0.5;
  const auto bent = material_from<Sail<>>(JsonObject(json_of(sail), "sail.json"));
  EXPECT_EQ(bent.bend, -0.5);
  const Json no_area = Json::parse(R"({"bend": 0.5})");
  EXPECT_THROW(material_from<Sail<>>(JsonObject(no_area, "sail.json")), Error);
}

TEST(MaterialJson, ReturnsTheMaterialItCameFrom) {
  Cloth<> cloth;
  cloth.turn_rad = 1.25;
  cloth.parts_list = {{0.1}, {1.0 / 3.0}, {10.0}};
  cloth.widths_mm = {2.0 / 3.0};
  cloth.weave = "drill";
  const Json json = Json::parse(json_of(cloth).dump());
  const auto again = material_from<Cloth<>>(JsonObject(json, "f.json: parameters"));
  EXPECT_EQ(again.turn_rad, cloth.turn_rad);
  EXPECT_EQ(again.widths_mm, cloth.widths_mm);
  EXPECT_EQ(again.weave, cloth.weave);
  ASSERT_EQ(again.parts_list.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.parts_list[i].size_mm, cloth.parts_list[i].size_mm);
  }
}

TEST(MaterialJson, WrapsDirectionsAndHoldsBounds) {
  const auto read = [](const std::string& pieces, const std::string& others) {
    const Json json = Json::parse("{\"pieces\": " + pieces + ", " + others + "}");
    return material_from<Cloth<>>(JsonObject(json, "f.json: parameters"));
  };
  const std::string good = R"("widths_mm": [1], "weave": "twill")";
  EXPECT_NEAR(read(R"([{"size_mm": 1}])", R"("turn_rad": -1, )" + good).turn_rad,
              std::numbers::pi - 1.0, 1e-15);
  const auto said = [&](const std::string& pieces, const std::string& others) {
    return error_of([&] { read(pieces, others); });
  };
  EXPECT_THAT(said(R"([{"size_mm": 11}])", R"("turn_rad": 0, )" + good),
              HasSubstr("pieces[0]: \"size_mm\" must lie between 0.1 and 10"));
  EXPECT_THAT(said("[]", R"("turn_rad": 0, )" + good),
              HasSubstr("\"pieces\" takes 1 to 3 entries"));
  EXPECT_THAT(said(R"([{"size_mm": 1}])", good), HasSubstr("\"turn_rad\" is missing"));
  const std::string rest = R"("turn_rad": 0, "weave": "twill", "widths_mm": )";
  EXPECT_THAT(said(R"([{"size_mm": 1}])", rest + "[1, 9]"),
              HasSubstr("\"widths_mm[1]\" must lie between 0.5 and 5"));
  EXPECT_THAT(said(R"([{"size_mm": 1}])", rest + "[1, 2, 3]"),
              HasSubstr("\"widths_mm\" takes 1 to 2 entries"));
  EXPECT_THAT(said(R"([{"size_mm": 1}])", rest + "[\"1\"]"),
              HasSubstr("\"widths_mm\" must be a list of 1 finite numbers"));
  EXPECT_THAT(said(R"([{"size_mm": 1}])", R"("turn_rad": 0, "widths_mm": [1], "weave": "felt")"),
              HasSubstr("\"weave\" must be a weave"));
}

}  // namespace
}  // namespace hada
