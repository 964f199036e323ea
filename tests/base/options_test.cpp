#include "core/base/options.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace bosk {
namespace {

TEST(Options, ReadBackTheTextTheyPrint) {
  double step = 0.1;
  const Option option{"step", "m", "length of a step", &step, 0.0, 1.0, {}};
  const std::string text = value_text(option);
  step = 0.7;
  set_value(option, text);
  EXPECT_EQ(step, 0.1);
}

TEST(Options, RefuseANumberOutOfRangeAndKeepTheOldOne) {
  int codewords = 16;
  const Option option{"codewords", "", "size of the codebook", &codewords, 1, 4096, {}};
  EXPECT_THROW(set_value(option, "0"), Error);
  EXPECT_THROW(set_value(option, "12x"), Error);
  EXPECT_THROW(set_value(option, ""), Error);
  EXPECT_EQ(codewords, 16);
}

TEST(Options, NameTheChoicesWhenNoneFits) {
  std::string space = "lab";
  const Option option{"space", "", "where distances are taken", &space, 0, 0, {"lab", "srgb"}};
  try {
    set_value(option, "hsv");
    FAIL() << "accepted an unknown choice";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("lab, srgb"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace bosk
