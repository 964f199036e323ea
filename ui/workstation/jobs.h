#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace bosk {

// Where a job waits for its turn.
enum class Lane {
  background,   // stages: one after the other, on all cores, behind whatever a person waits for
  interactive,  // what follows the hand: a new job replaces the waiting or running one of its key
};

// A job that waits or runs, as it stands now.
struct JobView {
  int id = 0;
  std::string title, phrase;
  Lane lane = Lane::background;
  bool running = false, stopping = false;  // else waiting; asked to stop
  double fraction = 0.0, spent_s = 0.0;
  std::optional<double> left_s;  // none while it isn't known
};

// What became of a job.
struct JobRecord {
  enum class End { done, cancelled, failed } end = End::done;
  std::string title;
  std::string message;  // of a failure: what failed, on what, and the remedy
  std::vector<std::string> warnings;
  double spent_s = 0.0;
};

// Work that runs beside the window. Work gets values, gives back a value and never touches what the
// window owns; its result is installed by `collect`, on the interface thread. The destructor asks
// all jobs to stop and waits for them.
class Jobs {
 public:
  // `wake` is called from any thread when the window should look at the jobs again.
  explicit Jobs(std::function<void()> wake = {});
  ~Jobs();
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  // Runs `work(Progress&) -> T` on the lane's thread and hands its result to `install(T)` in
  // `collect`. `key` is for the interactive lane. Returns the job's id.
  template <class Work, class Install>
  int start(const std::string& title, Work work, Install install, Lane lane = Lane::background,
            const std::string& key = {}) {
    using T = std::invoke_result_t<Work, Progress&>;
    return enqueue(title, lane, key, [work = std::move(work), install](Progress& progress) {
      auto result = std::make_shared<T>(work(progress));
      return std::function<void()>([result, install]() { install(std::move(*result)); });
    });
  }

  // Asks a job to stop; its result is dropped. Returns at once.
  void cancel(int id);
  void cancel_all();
  // Installs the results that came since the last call and records what became of the jobs. Once a
  // frame, on the interface thread.
  void collect();

  std::vector<JobView> now() const;  // the running ones first
  bool busy(Lane lane) const;        // whether any job of the lane waits or runs
  bool is_open(int id) const;        // whether the job waits, runs or is yet to be collected
  bool at_rest() const;              // nothing waits, runs or is yet to be collected
  // Background jobs that ended, newest last; interactive ones only when they failed.
  const std::vector<JobRecord>& records() const { return records_; }

  // Lets a worker thread say that there is something new to see.
  void wake() const {
    if (wake_) wake_();
  }

 private:
  using Work = std::function<std::function<void()>(Progress&)>;
  struct Job;
  struct Queue {
    std::deque<std::shared_ptr<Job>> waiting;
    std::shared_ptr<Job> running;
    std::jthread thread;
  };

  int enqueue(const std::string& title, Lane lane, const std::string& key, Work work);
  void serve(Queue& queue, Lane lane, const std::stop_token& stop);
  void run(Job& job) const;
  Queue& queue_of(Lane lane) { return queues_[lane == Lane::interactive ? 1 : 0]; }

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<std::shared_ptr<Job>> ended_;  // to be collected
  std::vector<JobRecord> records_;
  int last_id_ = 0;
  Queue queues_[2];
};

}  // namespace bosk
