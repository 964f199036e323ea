// What help, usage and machine-readable output promise.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/project/recipe.h"
#include "tests/app/program.h"
#include "tests/base/scratch_folder.h"

namespace bosk {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

const std::vector<std::string> kSubcommands = {
    "new", "calibrate", "matte", "opacity", "radiance", "texture", "compress", "pack",
    "run", "render",    "view",  "info",    "evaluate", "phantom", "export"};

TEST(CommandLine, HelpListsEverySubcommandAndOnlyThose) {
  const ScratchFolder folder;
  const ProgramEnd end = run_bosk({"--help"}, folder.path());
  EXPECT_EQ(end.status, 0);
  for (const std::string& name : kSubcommands) EXPECT_THAT(end.out, HasSubstr("\n  " + name + " "));
  for (const std::string name : {"chart", "stress"}) {
    EXPECT_EQ(end.out.find("\n  " + name + " "), std::string::npos) << name;
  }
  EXPECT_THAT(end.out, HasSubstr("75 temporary"));
}

TEST(CommandLine, EverySubcommandTeachesWithAnExample) {
  const ScratchFolder folder;
  for (const std::string& name : kSubcommands) {
    const ProgramEnd end = run_bosk({name, "--help"}, folder.path());
    EXPECT_EQ(end.status, 0) << name;
    EXPECT_THAT(end.out, HasSubstr("Example:\n  bosk " + name)) << name;
  }
}

TEST(CommandLine, HelpOfRunDescribesEveryOptionOfEveryStage) {
  const ScratchFolder folder;
  const std::string help = run_bosk({"run", "--help"}, folder.path()).out;
  Recipe recipe;
  for (const OptionGroup& group : option_groups(recipe)) {
    for (const Option& option : group.options) {
      EXPECT_THAT(help, HasSubstr("--" + group.stage + "." + option.name));
    }
  }
}

TEST(CommandLine, HelpOfAStageLeavesLaterStagesOut) {
  const ScratchFolder folder;
  const std::string help = run_bosk({"opacity", "--help"}, folder.path()).out;
  EXPECT_THAT(help, HasSubstr("--opacity.passes"));
  EXPECT_EQ(help.find("--radiance."), std::string::npos);
}

TEST(CommandLine, BadUsageIsStatus2AndSaysWhatIsWrong) {
  const ScratchFolder folder;
  const std::vector<std::vector<std::string>> wrong = {
      {"nothing"},
      {"run"},
      {"run", "a", "b"},
      {"run", "a", "--no-such-option"},
      {"run", "a", "--threads", "0"},
      {"render", "a.bosk"},
      {"evaluate", "a", "--truth", "b"},
      {"evaluate", "a", "--hold-out", "3", "--cameras", "c", "--truth", "t"},
      {"export", "a", "--to", "nothing", "out"}};
  for (const auto& arguments : wrong) {
    const ProgramEnd end = run_bosk(arguments, folder.path());
    EXPECT_EQ(end.status, 2) << testing::PrintToString(arguments);
    EXPECT_FALSE(end.err.empty()) << testing::PrintToString(arguments);
  }
}

TEST(CommandLine, AnOptionOutOfItsRangeIsBadUsageAndNamesIt) {
  const ScratchFolder folder;
  make_tiny_capture(folder / "capture");
  const ProgramEnd end = run_bosk({"new", "p", "capture/photos", "--cameras",
                                   "capture/transforms.json", "--opacity.passes=many"},
                                  folder.path());
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("opacity.passes=many"));
  EXPECT_FALSE(std::filesystem::exists(folder / "p"));
}

TEST(CommandLine, JsonIsAllThatGoesToStandardOutput) {
  const ScratchFolder folder;
  make_tiny_capture(folder / "capture");
  const ProgramEnd made =
      run_bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json", "--mattes",
                "capture/mattes", "--json"},
               folder.path());
  EXPECT_EQ(made.status, 0) << made.err;
  const Json json = Json::parse(made.out);
  EXPECT_EQ(json.at("photos_used"), 6);
  EXPECT_EQ(json.at("photos").at(0).at("accepted"), true);
  const Json info = Json::parse(run_bosk({"info", "p", "--json"}, folder.path()).out);
  EXPECT_EQ(info.at("kind"), "project");
  EXPECT_EQ(info.at("finished").at("photo"), true);
  EXPECT_EQ(info.at("finished").at("matte"), false);
}

TEST(CommandLine, JsonOfAFailureSaysWhy) {
  const ScratchFolder folder;
  const ProgramEnd end = run_bosk({"info", "nowhere.bosk", "--json"}, folder.path());
  EXPECT_EQ(end.status, 3);
  EXPECT_EQ(Json::parse(end.out).at("exit_status"), 3);
}

TEST(CommandLine, QuietMeansNoProgress) {
  const ScratchFolder folder;
  make_tiny_capture(folder / "capture");
  const ProgramEnd end =
      run_bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json", "--mattes",
                "capture/mattes", "--quiet"},
               folder.path());
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, "");
}

TEST(CommandLine, OptionsOfARunStayWithTheProject) {
  const ScratchFolder folder;
  make_tiny_capture(folder / "capture");
  run_bosk({"new", "p", "capture/photos", "--cameras", "capture/transforms.json", "--mattes",
            "capture/mattes"},
           folder.path());
  EXPECT_EQ(run_bosk({"matte", "p", "--matte.clusters=9", "--quiet"}, folder.path()).status, 0);
  const Json info = Json::parse(run_bosk({"info", "p", "--json"}, folder.path()).out);
  EXPECT_EQ(info.at("options").at("matte.clusters"), "9");
}

}  // namespace
}  // namespace bosk
