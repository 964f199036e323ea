#include "core/project/recipe.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/project/presets.h"
#include "core/project/stages.h"

namespace bosk {
namespace {

TEST(Recipe, SetsAnOptionByTheNameOfTheCommandLine) {
  Recipe recipe;
  set_option(recipe, "opacity.passes", "3");
  EXPECT_EQ(recipe.opacity.passes, 3);
  EXPECT_EQ(option_text(recipe, "opacity.passes"), "3");
}

TEST(Recipe, RefusesUnknownNames) {
  Recipe recipe;
  EXPECT_THROW(set_option(recipe, "opacity.nothing", "3"), Error);
  EXPECT_THROW(set_option(recipe, "passes", "3"), Error);
  EXPECT_THROW(set_option(recipe, "", ""), Error);
}

TEST(Recipe, NamesTheWholeOptionWhenItRefusesAValue) {
  Recipe recipe;
  try {
    set_option(recipe, "opacity.passes", "-1");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("opacity.passes"), std::string::npos) << error.what();
  }
}

TEST(Recipe, EveryOptionIsDescribedOnceWithHelpAndADefaultInRange) {
  Recipe recipe;
  std::set<std::string> names;
  for (const OptionGroup& group : option_groups(recipe)) {
    for (const Option& option : group.options) {
      EXPECT_TRUE(names.insert(group.stage + "." + option.name).second) << option.name;
      EXPECT_FALSE(option.help.empty()) << option.name;
      const std::string text = value_text(option);
      EXPECT_NO_THROW(set_value(option, text)) << group.stage << "." << option.name << "=" << text;
    }
  }
}

TEST(Presets, SetOnlyOptionsThatExistAndToValuesThatFit) {
  for (const Preset& preset : presets()) {
    Recipe recipe;
    EXPECT_NO_THROW(apply_preset(recipe, preset.name)) << preset.name;
  }
}

TEST(Presets, GoBackToTheDefaults) {
  Recipe plain, changed;
  for (const Preset& preset : presets()) apply_preset(changed, preset.name);
  apply_preset(changed, "default");
  apply_preset(plain, "default");
  for (const Preset& preset : presets()) {
    for (const auto& [name, value] : preset.values) {
      EXPECT_EQ(option_text(changed, name), option_text(plain, name)) << name;
    }
  }
}

TEST(Presets, RefuseAnUnknownNameAndListTheKnown) {
  Recipe recipe;
  try {
    apply_preset(recipe, "quick");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("fast, default, best"), std::string::npos);
  }
}

TEST(Stages, ComeAfterTheirInputs) {
  std::set<std::string> seen;
  for (const Stage& stage : stages()) {
    for (const std::string& input : stage.inputs) EXPECT_TRUE(seen.count(input)) << stage.name;
    EXPECT_TRUE(seen.insert(stage.name).second) << stage.name;
  }
}

TEST(Stages, KnowWhatTheyNeed) {
  EXPECT_EQ(stages_up_to("matte"), (std::vector<std::string>{"photo", "matte"}));
  EXPECT_EQ(stages_up_to("pack").size(), stages().size());
}

}  // namespace
}  // namespace bosk
