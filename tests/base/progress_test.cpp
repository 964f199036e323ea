#include "core/base/progress.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <vector>

namespace bosk {
namespace {

TEST(Progress, MapsStepsIntoTheJob) {
  std::vector<ProgressReport> heard;
  Progress progress([&](const ProgressReport& report) { heard.push_back(report); }, {});
  progress.scope(0.5, 1.0);
  progress.begin("Half of the second half", 10, 0.5, 1.0);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_DOUBLE_EQ(heard.back().fraction, 0.75);
  EXPECT_EQ(heard.back().phrase, "Half of the second half");
}

TEST(Progress, PartsLieInPartsAndEndWhereTheyBegan) {
  double heard = 0.0;
  Progress progress([&](const ProgressReport& report) { heard = report.fraction; }, {});
  progress.scope(0.5, 1.0);
  {
    const ProgressPart half(progress, 0.0, 0.5);
    const ProgressPart quarter(progress, 0.5, 1.0);
    progress.begin("step", 10, 1.0, 1.0);
    EXPECT_DOUBLE_EQ(heard, 0.75);
    progress.begin("step", 10);
    EXPECT_DOUBLE_EQ(heard, 0.625);
  }
  progress.begin("step", 10, 1.0, 1.0);
  EXPECT_DOUBLE_EQ(heard, 1.0);
}

TEST(Progress, NamesThePartOfTheJob) {
  std::string heard;
  Progress progress([&](const ProgressReport& report) { heard = report.part; }, {});
  progress.scope(0.0, 1.0, "Opacity");
  progress.begin("step", 10);
  EXPECT_EQ(heard, "Opacity");
}

TEST(Progress, StopsAParallelLoop) {
  Progress progress;
  std::atomic<int> done{0};
  const auto loop = [&] {
    tbb::parallel_for(0, 1'000'000, [&](int) {
      if (++done == 100) progress.cancel();
      progress.advance();
    });
  };
  EXPECT_THROW(loop(), Cancelled);
  EXPECT_LT(done, 1'000'000);
}

TEST(Progress, IsNoStdExceptionWhenCancelled) {
  Progress progress;
  progress.cancel();
  bool swallowed = false;
  try {
    try {
      progress.check();
    } catch (const std::exception&) {
      swallowed = true;
    }
  } catch (const Cancelled&) {
  }
  EXPECT_FALSE(swallowed);
}

TEST(Progress, PassesWarningsOn) {
  std::vector<std::string> heard;
  Progress progress({}, [&](const std::string& sentence) { heard.push_back(sentence); });
  progress.warn("photo 7 is blurred");
  EXPECT_EQ(heard, std::vector<std::string>{"photo 7 is blurred"});
}

}  // namespace
}  // namespace bosk
