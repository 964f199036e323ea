#include "core/project/run.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/project/cache.h"

namespace bosk {
namespace {

using Keys = std::map<std::string, ContentHash>;

constexpr int kEntriesKept = 4;  // of each stage: the latest, and those of a few settings before

// The watchers, and where they stop a stage before its end: the iteration, into the recipe that the
// run goes on with. The recipe must outlive them.
RunWatchers noting_stops(const RunWatchers& watchers, Recipe& recipe) {
  RunWatchers noting;
  noting.compress = watchers.compress;
  if (watchers.opacity) {
    noting.opacity = [&recipe, watcher = watchers.opacity](const OpacityPreview& preview) {
      if (watcher(preview)) return true;
      if (preview.iteration < preview.planned) recipe.opacity.stop_after = preview.iteration;
      return false;
    };
  }
  if (watchers.radiance) {
    noting.radiance = [&recipe, watcher = watchers.radiance](const RadiancePreview& preview) {
      if (watcher(preview)) return true;
      if (preview.epoch < preview.planned) recipe.radiance.stop_after = preview.epoch;
      return false;
    };
  }
  return noting;
}

// One run: obtains results recursively, keeping in memory only what is still needed.
class Runner {
 public:
  Runner(const Project& project, const Capture& capture, const std::vector<std::string>& wanted,
         Progress& progress, Share share, const RunWatchers& watchers, const Results& known)
      : capture_(capture),
        keys_(stage_keys(capture, project.recipe)),
        cache_(project.cache_folder()),
        wanted_(wanted.begin(), wanted.end()),
        progress_(progress),
        share_(share),
        watchers_(noting_stops(watchers, run_.recipe)) {
    run_.recipe = project.recipe;
    run_.results = known;
    for (const std::string& stage : wanted) plan(stage_named(stage));
  }

  // In the order of the stages: one that is stopped early changes the keys of all behind it.
  Run run() {
    for (const Stage& stage : stages()) {
      if (wanted_.count(stage.name) > 0) obtain(stage);
    }
    progress_.scope(share_.to, share_.to);
    return std::move(run_);
  }

 private:
  // Finds what will have to be computed, as far as the cache's file names tell.
  void plan(const Stage& stage) {
    if (stage.is_held(run_.results)) return;
    if (cache_.contains(stage.name, keys_.at(stage.name))) return;
    if (!to_compute_.insert(stage.name).second) return;
    total_share_ += stage.share;
    for (const std::string& input : stage.inputs) plan(stage_named(input));
  }

  void obtain(const Stage& stage) {
    if (stage.is_held(run_.results)) return;
    progress_.check();
    if (load(stage)) return;
    const ContentHash planned = keys_.at(stage.name);
    for (const std::string& input : stage.inputs) obtain(stage_named(input));
    const bool input_was_stopped = keys_.at(stage.name) != planned;
    if (input_was_stopped && load(stage)) return;
    compute(stage);
  }

  bool load(const Stage& stage) {
    const auto entry = cache_.load(stage.name, keys_.at(stage.name));
    if (!entry) return false;
    try {
      read(stage, entry->result);
    } catch (const Error&) {
      return false;  // an entry that checks out but doesn't read is a miss too
    }
    run_.times.push_back({stage.name, entry->seconds, true});
    return true;
  }

  void read(const Stage& stage, const std::vector<std::byte>& bytes) {
    BinaryReader reader(bytes);
    stage.read(reader, run_.results);
    if (!reader.at_end()) throw Error("stored result of " + stage.name + " is too long");
  }

  void compute(const Stage& stage) {
    const auto start = std::chrono::steady_clock::now();
    begin_share(stage);
    stage.compute(capture_, run_.recipe, run_.results, progress_, watchers_);
    progress_.check();
    keys_ = stage_keys(capture_, run_.recipe);  // others where a watcher stopped the stage
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    store(stage, spent.count());
    to_compute_.erase(stage.name);
    let_go_of_inputs(stage);
    run_.times.push_back({stage.name, spent.count(), false});
  }

  void begin_share(const Stage& stage) {
    const double total = std::max(total_share_, done_share_ + stage.share);
    const double width = (share_.to - share_.from) / total;
    progress_.scope(share_.from + width * done_share_,
                    share_.from + width * (done_share_ + stage.share), stage.title);
    progress_.begin("starting", 1);
    done_share_ += stage.share;
  }

  // The result goes on as it was stored, so that a resumed run and an uninterrupted one agree even
  // where storing rounds.
  void store(const Stage& stage, double seconds) {
    BinaryWriter writer;
    stage.write(writer, run_.results);
    const ContentHash& key = keys_.at(stage.name);
    cache_.store(stage.name, key, writer.bytes(), seconds);
    cache_.forget_old(stage.name, key, kEntriesKept);
    progress_.check();  // what was made is kept; nobody waits for it to be read
    stage.let_go(run_.results);
    read(stage, writer.bytes());
  }

  void let_go_of_inputs(const Stage& stage) {
    for (const std::string& input : stage.inputs) {
      const bool needed =
          wanted_.count(input) > 0 ||
          std::any_of(to_compute_.begin(), to_compute_.end(), [&](const auto& name) {
            const auto& inputs = stage_named(name).inputs;
            return std::count(inputs.begin(), inputs.end(), input) > 0;
          });
      if (!needed) stage_named(input).let_go(run_.results);
    }
  }

  const Capture& capture_;
  Keys keys_;
  Cache cache_;
  std::set<std::string> wanted_;
  Progress& progress_;
  Share share_;
  Run run_;
  RunWatchers watchers_;
  std::set<std::string> to_compute_;
  double total_share_ = 0.0, done_share_ = 0.0;
};

}  // namespace

std::map<std::string, ContentHash> stage_keys(const Capture& capture, const Recipe& recipe) {
  Keys keys;
  Recipe copy = recipe;
  for (const Stage& stage : stages()) {
    ContentHasher hasher;
    hasher.text(stage.name).value(stage.version);
    if (stage.options) {
      for (const Option& option : stage.options(copy)) {
        hasher.text(option.name).text(value_text(option));
      }
    }
    for (const std::string& input : stage.inputs) {
      hasher.value(keys.at(input).high).value(keys.at(input).low);
    }
    if (stage.hash_sources) stage.hash_sources(hasher, capture);
    keys[stage.name] = hasher.finish();
  }
  return keys;
}

ContentHash stage_key(const Capture& capture, const Recipe& recipe, const std::string& stage) {
  return stage_keys(capture, recipe).at(stage);
}

bool is_finished(const Project& project, const Capture& capture, const std::string& stage) {
  const Cache cache(project.cache_folder());
  return cache.contains(stage, stage_key(capture, project.recipe, stage));
}

std::vector<StageTime> times_spent(const Project& project, const Capture& capture) {
  const Cache cache(project.cache_folder());
  std::vector<StageTime> times;
  const Keys keys = stage_keys(capture, project.recipe);
  for (const Stage& stage : stages()) {
    const auto seconds = cache.seconds_spent(stage.name, keys.at(stage.name));
    if (seconds) times.push_back({stage.name, *seconds, true});
  }
  return times;
}

Run run_stages(const Project& project, const Capture& capture,
               const std::vector<std::string>& wanted, Progress& progress, Share share,
               const RunWatchers& watchers, const Results& known) {
  return Runner(project, capture, wanted, progress, share, watchers, known).run();
}

}  // namespace bosk
