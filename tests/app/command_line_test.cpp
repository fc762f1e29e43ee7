#include <gtest/gtest.h>

#include "program.h"

namespace hada {
namespace {

TEST(CommandLine, EveryCommandExplainsItselfWithAnExample) {
  for (const std::string name : {"demo", "run", "calibrate", "reconstruct", "measure", "fit",
                                 "synth", "compare", "photograph", "validate", "materials"}) {
    const Answer said = answer(name + " --help");
    EXPECT_EQ(said.code, 0) << name;
    EXPECT_NE(said.out.find("Example:\n  hada " + name), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("--threads"), std::string::npos) << name;
  }
}

TEST(CommandLine, TellsItsVersion) {
  const Answer said = answer("--version");
  EXPECT_EQ(said.code, 0);
  EXPECT_EQ(said.out.rfind("hada ", 0), 0u);
}

TEST(CommandLine, RefusesWhatItDoesNotKnowInOneSentence) {
  for (const std::string words :
       {"", "frobnicate", "calibrate", "calibrate a --unknown", "measure x --pitch nan",
        "measure x --pitch -1", "demo --threads 0", "reconstruct a -o b --levelling wavy",
        "run a --seed minus", "synth m.json -o out --size 10", "materials straw"}) {
    const Answer said = answer(words);
    EXPECT_EQ(said.code, 2) << words;
    EXPECT_EQ(said.err.rfind("hada: ", 0), 0u) << said.err;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    EXPECT_TRUE(said.out.empty()) << said.out;
  }
}

TEST(CommandLine, MaterialsAreListedForPeopleAndPrograms) {
  EXPECT_NE(answer("materials").out.find("amplitude_mm"), std::string::npos);
  EXPECT_NE(answer("materials wrinkle --json").out.find("\"materials/1\""), std::string::npos);
  EXPECT_EQ(answer("materials --markdown").out.rfind("# Materials", 0), 0u);
}

}  // namespace
}  // namespace hada
