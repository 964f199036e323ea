#include "ui/workstation/jobs.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <new>

#include "core/base/error.h"
#include "core/base/remaining_time.h"
#include "ui/workstation/worker_priority.h"

namespace bosk {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

struct Jobs::Job {
  int id = 0;
  std::string title, key;
  Lane lane = Lane::background;
  Work work;
  std::unique_ptr<Progress> progress;
  // Below: of the lane's thread until the job has ended, but for what `report_mutex` guards
  std::function<void()> install;
  JobRecord record;
  Clock::time_point start;
  mutable std::mutex report_mutex;
  ProgressReport report;
  bool started = false;
  RemainingTime remaining;
  std::optional<double> left_s;
};

Jobs::Jobs(std::function<void()> wake) : wake_(std::move(wake)) {
  for (const Lane lane : {Lane::background, Lane::interactive}) {
    Queue& queue = queue_of(lane);
    queue.thread = std::jthread(
        [this, &queue, lane](const std::stop_token& stop) { serve(queue, lane, stop); });
  }
}

Jobs::~Jobs() {
  cancel_all();
  for (Queue& queue : queues_) queue.thread.request_stop();
  for (Queue& queue : queues_) queue.thread.join();
}

int Jobs::enqueue(const std::string& title, Lane lane, const std::string& key, Work work) {
  auto job = std::make_shared<Job>();
  job->title = job->record.title = title;
  job->key = key;
  job->lane = lane;
  job->work = std::move(work);
  Job* raw = job.get();
  job->progress = std::make_unique<Progress>(
      [this, raw](const ProgressReport& report) {
        {
          const std::lock_guard lock(raw->report_mutex);
          const double furthest = std::max(raw->report.fraction, report.fraction);
          raw->report = report;
          raw->report.fraction = furthest;
          raw->left_s = raw->remaining.update(furthest, seconds_since(raw->start));
        }
        wake();
      },
      [raw](const std::string& sentence) { raw->record.warnings.push_back(sentence); });
  const std::lock_guard lock(mutex_);
  job->id = ++last_id_;
  Queue& queue = queue_of(lane);
  if (lane == Lane::interactive) {
    std::erase_if(queue.waiting, [&](const auto& other) { return other->key == key; });
    if (queue.running && queue.running->key == key) queue.running->progress->cancel();
  }
  queue.waiting.push_back(job);
  changed_.notify_all();
  return job->id;
}

void Jobs::serve(Queue& queue, Lane lane, const std::stop_token& stop) {
  if (lane == Lane::background) yield_to_interface();
  tbb::task_arena arena(
      tbb::task_arena::automatic, 1,
      lane == Lane::interactive ? tbb::task_arena::priority::high : tbb::task_arena::priority::low);
  const WorkersYield workers_yield(arena);
  while (true) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait(lock, stop, [&] { return !queue.waiting.empty(); })) return;
    queue.running = queue.waiting.front();
    queue.waiting.pop_front();
    const std::shared_ptr<Job> job = queue.running;
    lock.unlock();
    arena.execute([&] { run(*job); });
    lock.lock();
    queue.running.reset();
    ended_.push_back(job);
    lock.unlock();
    wake();
  }
}

void Jobs::run(Job& job) const {
  {
    const std::lock_guard lock(job.report_mutex);
    job.start = Clock::now();
    job.started = true;
  }
  job.record.end = JobRecord::End::failed;
  try {
    job.progress->check();
    job.install = job.work(*job.progress);
    job.progress->check();
    job.record.end = JobRecord::End::done;
  } catch (const Cancelled&) {
    job.install = nullptr;
    job.record.end = JobRecord::End::cancelled;
  } catch (const Error& error) {
    job.record.message = error.what();
  } catch (const std::bad_alloc&) {
    job.record.message = "out of memory; lower photo.working_megapixels or close other programs";
  } catch (const std::exception& error) {
    job.record.message = std::string("a fault of Bosk's own, please report it: ") + error.what();
  }
  job.work = nullptr;  // what it captured may be large
  job.record.spent_s = seconds_since(job.start);
}

void Jobs::cancel(int id) {
  const std::lock_guard lock(mutex_);
  for (Queue& queue : queues_) {
    if (queue.running && queue.running->id == id) queue.running->progress->cancel();
    const auto place = std::find_if(queue.waiting.begin(), queue.waiting.end(),
                                    [&](const auto& job) { return job->id == id; });
    if (place == queue.waiting.end()) continue;
    (*place)->record.end = JobRecord::End::cancelled;
    ended_.push_back(*place);
    queue.waiting.erase(place);
  }
}

void Jobs::cancel_all() {
  std::vector<int> ids;
  for (const JobView& job : now()) ids.push_back(job.id);
  for (const int id : ids) cancel(id);
}

void Jobs::collect() {
  std::vector<std::shared_ptr<Job>> ended;
  {
    const std::lock_guard lock(mutex_);
    ended.swap(ended_);
  }
  for (const auto& job : ended) {
    const bool asked_to_stop = job->progress->cancelled();
    if (job->install && !asked_to_stop) job->install();
    if (asked_to_stop) job->record.end = JobRecord::End::cancelled;
    const bool worth_telling =
        job->lane == Lane::background || job->record.end == JobRecord::End::failed;
    if (worth_telling) records_.push_back(std::move(job->record));
  }
}

std::vector<JobView> Jobs::now() const {
  std::vector<JobView> views;
  const auto add = [&](const Job& job, bool running) {
    JobView view;
    view.id = job.id;
    view.title = job.title;
    view.lane = job.lane;
    view.running = running;
    view.stopping = job.progress->cancelled();
    const std::lock_guard lock(job.report_mutex);
    view.phrase =
        job.report.part.empty() ? job.report.phrase : job.report.part + ": " + job.report.phrase;
    view.fraction = job.report.fraction;
    if (job.started) view.spent_s = seconds_since(job.start);
    view.left_s = job.left_s;
    views.push_back(std::move(view));
  };
  const std::lock_guard lock(mutex_);
  for (const Queue& queue : queues_) {
    if (queue.running) add(*queue.running, true);
  }
  for (const Queue& queue : queues_) {
    for (const auto& job : queue.waiting) add(*job, false);
  }
  return views;
}

bool Jobs::busy(Lane lane) const {
  const std::lock_guard lock(mutex_);
  const Queue& queue = queues_[lane == Lane::interactive ? 1 : 0];
  return queue.running != nullptr || !queue.waiting.empty();
}

bool Jobs::at_rest() const {
  const std::lock_guard lock(mutex_);
  const bool quiet = std::all_of(std::begin(queues_), std::end(queues_), [](const Queue& queue) {
    return queue.running == nullptr && queue.waiting.empty();
  });
  return quiet && ended_.empty();
}

bool Jobs::is_open(int id) const {
  const auto is_it = [id](const auto& job) { return job && job->id == id; };
  const std::lock_guard lock(mutex_);
  return std::any_of(ended_.begin(), ended_.end(), is_it) ||
         std::any_of(std::begin(queues_), std::end(queues_), [&](const Queue& queue) {
           return is_it(queue.running) ||
                  std::any_of(queue.waiting.begin(), queue.waiting.end(), is_it);
         });
}

}  // namespace bosk
