#include "ui/workstation/jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/base/error.h"

namespace bosk {
namespace {

using namespace std::chrono_literals;

void collect_until(Jobs& jobs, const std::function<bool()>& reached) {
  for (int i = 0; i < 5000 && !reached(); ++i) {
    jobs.collect();
    std::this_thread::sleep_for(1ms);
  }
}

// Work that goes on until it is stopped.
int endless(Progress& progress) {
  while (true) {
    progress.check();
    std::this_thread::sleep_for(1ms);
  }
}

TEST(Jobs, InstallsAResultOnlyWhenItIsCollected) {
  Jobs jobs;
  std::atomic<bool> worked{false};
  int installed = 0;
  jobs.start(
      "count", [&](Progress&) { return worked = true, 7; }, [&](int value) { installed = value; });
  while (!worked) std::this_thread::sleep_for(1ms);
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(installed, 0);
  collect_until(jobs, [&] { return installed != 0; });
  EXPECT_EQ(installed, 7);
  ASSERT_EQ(jobs.records().size(), 1u);
  EXPECT_EQ(jobs.records()[0].end, JobRecord::End::done);
}

TEST(Jobs, RunBackgroundWorkInTheOrderItWasStarted) {
  Jobs jobs;
  std::vector<int> order;
  for (int i = 0; i < 5; ++i) {
    jobs.start(
        "job", [i](Progress&) { return i; }, [&](int value) { order.push_back(value); });
  }
  collect_until(jobs, [&] { return order.size() == 5; });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Jobs, ACancelledJobInstallsNothingAndIsRecorded) {
  Jobs jobs;
  bool installed = false;
  const int id = jobs.start("endless", endless, [&](int) { installed = true; });
  std::this_thread::sleep_for(10ms);
  jobs.cancel(id);
  collect_until(jobs, [&] { return !jobs.records().empty(); });
  EXPECT_FALSE(installed);
  EXPECT_EQ(jobs.records().at(0).end, JobRecord::End::cancelled);
  EXPECT_FALSE(jobs.busy(Lane::background));
}

TEST(Jobs, AJobThatEndedBeforeItHeardOfTheStopInstallsNothingEither) {
  Jobs jobs;
  std::atomic<bool> worked{false};
  bool installed = false;
  const int id = jobs.start(
      "quick", [&](Progress&) { return worked = true, 1; }, [&](int) { installed = true; });
  while (!worked) std::this_thread::sleep_for(1ms);
  while (jobs.busy(Lane::background)) std::this_thread::sleep_for(1ms);
  EXPECT_TRUE(jobs.is_open(id));
  jobs.cancel(id);  // too late: it has left the lane
  jobs.collect();
  EXPECT_TRUE(installed);
}

TEST(Jobs, AWaitingJobCanBeCancelled) {
  Jobs jobs;
  const int first = jobs.start("endless", endless, [](int) {});
  std::atomic<bool> second_ran{false};
  const int second = jobs.start(
      "second", [&](Progress&) { return second_ran = true, 0; }, [](int) {});
  jobs.cancel(second);
  jobs.cancel(first);
  collect_until(jobs, [&] { return jobs.records().size() == 2; });
  EXPECT_FALSE(second_ran);
}

TEST(Jobs, TellAFailureInItsOwnWords) {
  Jobs jobs;
  jobs.start(
      "reading", [](Progress&) -> int { throw Error("a.jpg: is no photo"); }, [](int) {});
  collect_until(jobs, [&] { return !jobs.records().empty(); });
  EXPECT_EQ(jobs.records().at(0).end, JobRecord::End::failed);
  EXPECT_EQ(jobs.records().at(0).message, "a.jpg: is no photo");
}

TEST(Jobs, TheNewestInteractiveJobOfAKeyReplacesTheOthers) {
  Jobs jobs;
  std::vector<int> installed;
  jobs.start(
      "live", endless, [&](int) { installed.push_back(-1); }, Lane::interactive, "matte");
  for (int i = 0; i < 20; ++i) {
    jobs.start(
        "live",
        [i](Progress& progress) {
          for (int k = 0; k < 5; ++k) {
            progress.check();
            std::this_thread::sleep_for(1ms);
          }
          return i;
        },
        [&](int value) { installed.push_back(value); }, Lane::interactive, "matte");
  }
  collect_until(jobs, [&] { return !jobs.busy(Lane::interactive); });
  jobs.collect();
  ASSERT_FALSE(installed.empty());
  EXPECT_EQ(installed.back(), 19);
  EXPECT_EQ(std::count(installed.begin(), installed.end(), -1), 0);
  EXPECT_TRUE(jobs.records().empty()) << "what follows the hand is no news";
}

TEST(Jobs, InteractiveWorkDoesNotWaitForTheBackground) {
  Jobs jobs;
  const int stage = jobs.start("stage", endless, [](int) {});
  bool answered = false;
  jobs.start(
      "live", [](Progress&) { return 1; }, [&](int) { answered = true; }, Lane::interactive,
      "live");
  collect_until(jobs, [&] { return answered; });
  EXPECT_TRUE(answered);
  EXPECT_TRUE(jobs.is_open(stage));
}

TEST(Jobs, ShowHowFarTheyAre) {
  Jobs jobs;
  std::atomic<bool> seen{false};
  jobs.start(
      "half",
      [&](Progress& progress) {
        progress.begin("halving", 2);
        progress.advance(1);
        progress.begin("waiting", 1, 0.5, 1.0);
        while (!seen) progress.check();
        return 0;
      },
      [](int) {});
  JobView view;
  collect_until(jobs, [&] {
    const auto views = jobs.now();
    if (!views.empty()) view = views[0];
    return view.phrase == "waiting";
  });
  EXPECT_DOUBLE_EQ(view.fraction, 0.5);
  EXPECT_TRUE(view.running);
  seen = true;
}

TEST(Jobs, EndingThemStopsEverything) {
  const auto start = std::chrono::steady_clock::now();
  {
    Jobs jobs;
    for (int i = 0; i < 3; ++i) jobs.start("endless", endless, [](int) {});
    jobs.start(
        "endless", endless, [](int) {}, Lane::interactive, "a");
    std::this_thread::sleep_for(5ms);
  }
  // A hang would be cut by the test's own time limit; this only says that it was no timeout
  EXPECT_LT(std::chrono::steady_clock::now() - start, 60s);
}

}  // namespace
}  // namespace bosk
