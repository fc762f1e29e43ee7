#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// The table of docs/architecture.md, held against every `#include` line of the rooms.
namespace hada {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

// What each room may use besides itself.
const std::map<std::string, Names> rooms_for = {
    {"core", {}},
    {"io", {"core"}},
    {"capture", {"core", "io"}},
    {"reconstruct", {"core"}},
    {"measure", {"core"}},
    {"mechanics", {"core"}},
    {"sheet", {"core", "mechanics"}},
    {"synth", {"core", "mechanics", "sheet"}},
    {"fit", {"core", "measure", "mechanics", "synth"}},
    {"app",
     {"core", "io", "capture", "reconstruct", "measure", "mechanics", "sheet", "synth", "fit"}},
    {"studio",
     {"core", "io", "capture", "reconstruct", "measure", "mechanics", "sheet", "synth", "fit",
      "app"}},
};

// Third parties by the folder of their headers. Eigen is spoken everywhere, {fmt} in every source.
const std::map<std::string, Names> third_parties_for = {
    {"core", {"opencv2"}},
    {"io", {"OpenImageIO", "nlohmann"}},
    {"capture", {"opencv2", "ceres", "glog"}},
    {"reconstruct", {"opencv2"}},
    {"measure", {"opencv2"}},
    {"mechanics", {"embree3"}},
    {"fit", {"ceres", "glog"}},
    {"app", {"CLI", "spdlog"}},
};

// The headers that may include a third party; only sources, or another of them, include these.
const std::map<std::string, Names> doors = {
    {"app/command_list.h", {"CLI"}},
    {"io/json.h", {"nlohmann"}},
    {"io/json_light.h", {}},
    {"fit/solve.h", {"ceres"}},
    {"fit/whittle.h", {"ceres"}},
    {"fit/spectral_distance.h", {}},
    {"capture/joint_problem.h", {"ceres"}},
    {"capture/opencv_view.h", {"opencv2"}},
};

bool is_header(const std::string& file) {
  return file.ends_with(".h");
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find('/'));
}

bool may_include_own(const std::string& file, const std::string& header) {
  const std::string room = folder_of(file);
  const std::string other = folder_of(header);
  if (other != room && !rooms_for.at(room).contains(other)) return false;
  return !doors.contains(header) || !is_header(file) || doors.contains(file);
}

bool may_include_third_party(const std::string& file, const std::string& header) {
  const std::string room = folder_of(file);
  const std::string party = folder_of(header);
  if (party == header || party == "sys") return true;  // the standard library, the system
  if (party == "Eigen") return room != "synth" || !is_header(file);
  // What Eigen ships without promising to keep it stays in sources.
  if (party == "unsupported") return !is_header(file);
  if (is_header(file)) return doors.contains(file) && doors.at(file).contains(party);
  if (party == "fmt") return true;
  if (file == "core/fft.cpp" || room != "core") {
    const auto allowed = third_parties_for.find(room);
    return allowed != third_parties_for.end() && allowed->second.contains(party);
  }
  return false;
}

// One sentence for each include of `text` that the table forbids to `file` ("room/name.cpp").
std::vector<std::string> forbidden_includes(const std::string& file, const std::string& text) {
  static const std::regex include(R"(^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"])",
                                  std::regex::multiline);
  std::vector<std::string> complaints;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), include);
       i != std::sregex_iterator(); ++i) {
    const std::string header = (*i)[2];
    const bool allowed =
        (*i)[1] == "\"" ? may_include_own(file, header) : may_include_third_party(file, header);
    if (!allowed) complaints.push_back(file + " must not include " + header);
  }
  return complaints;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<fs::path> sources_of(const fs::path& room) {
  std::vector<fs::path> files;
  if (!fs::exists(room)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(room)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Architecture, RoomsIncludeOnlyWhatTheTableAllows) {
  const fs::path root = HADA_SOURCE_DIR;
  std::size_t files = 0;
  for (const auto& [room, allowed] : rooms_for) {
    for (const fs::path& path : sources_of(root / room)) {
      ++files;
      const std::string file = fs::relative(path, root).generic_string();
      for (const auto& complaint : forbidden_includes(file, text_of(path)))
        ADD_FAILURE() << complaint;
    }
  }
  EXPECT_GT(files, 50u);
}

TEST(Architecture, KnowsEveryFolderThatHoldsSources) {
  const Names others = {"tests", "bench"};
  for (const auto& entry : fs::directory_iterator(HADA_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || name.starts_with(".") || name.starts_with("build") ||
        name.starts_with("out") || others.contains(name) || sources_of(entry.path()).empty()) {
      continue;
    }
    EXPECT_TRUE(rooms_for.contains(name)) << name << " is no room of the table";
  }
}

TEST(Architecture, BuildsEveryTest) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(HADA_SOURCE_DIR) / "tests")) {
    if (!entry.is_directory()) continue;
    const std::string list = text_of(entry.path() / "CMakeLists.txt");
    for (const fs::path& path : sources_of(entry.path())) {
      const std::string name = path.filename().string();
      if (!name.ends_with("_test.cpp")) continue;
      ++files;
      EXPECT_NE(list.find(name), std::string::npos) << path << " is in no list of sources";
    }
  }
  EXPECT_GT(files, 200u);
}

TEST(Architecture, SaysWhatLiesInTheRooms) {
  const fs::path root = HADA_SOURCE_DIR;
  const std::string page = text_of(root / "docs" / "architecture.md");
  for (const auto& [room, allowed] : rooms_for) {
    if (room == "app") continue;  // there, folders are named
    for (const fs::path& path : sources_of(root / room)) {
      if (!is_header(path.string())) continue;
      const std::string name = path.stem().string();
      EXPECT_TRUE(std::regex_search(page, std::regex("\\b" + name + "\\b")))
          << room << "/" << name << " is not on the page";
    }
  }
}

TEST(Architecture, SeesArrowsThatTurnBack) {
  EXPECT_EQ(forbidden_includes("core/a.h", "#include \"synth/wood.h\"\n").size(), 1u);
  EXPECT_EQ(forbidden_includes("reconstruct/a.cpp", "  # include \"synth/wood.h\"").size(), 1u);
  EXPECT_EQ(forbidden_includes("capture/a.cpp", "#include \"fit/solve.h\"").size(), 1u);
  EXPECT_EQ(forbidden_includes("fit/a.cpp", "#include \"synth/wood.h\"").size(), 0u);
  EXPECT_EQ(forbidden_includes("app/a.h", "// #include \"nowhere/a.h\"").size(), 0u);
}

TEST(Architecture, SeesThirdPartiesInTheWrongPlace) {
  EXPECT_EQ(forbidden_includes("measure/a.h", "#include <opencv2/core.hpp>").size(), 1u);
  EXPECT_EQ(forbidden_includes("measure/a.cpp", "#include <opencv2/core.hpp>").size(), 0u);
  EXPECT_EQ(forbidden_includes("core/image.cpp", "#include <opencv2/core.hpp>").size(), 1u);
  EXPECT_EQ(forbidden_includes("app/a.h", "#include \"io/json.h\"").size(), 1u);
  EXPECT_EQ(forbidden_includes("app/a.cpp", "#include \"io/json.h\"").size(), 0u);
  EXPECT_EQ(forbidden_includes("io/a.cpp", "#include <nlohmann/json.hpp>").size(), 0u);
  EXPECT_EQ(forbidden_includes("synth/a.h", "#include <Eigen/Core>\n#include <cmath>").size(), 1u);
  EXPECT_EQ(forbidden_includes("measure/a.h", "#include <unsupported/Eigen/FFT>").size(), 1u);
  EXPECT_EQ(forbidden_includes("fit/a.h", "#include <ceres/jet.h>").size(), 1u);
  EXPECT_EQ(forbidden_includes("app/a.cpp", "#include <boost/any.hpp>").size(), 1u);
}

}  // namespace
}  // namespace hada
