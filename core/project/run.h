#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/content_hash.h"
#include "core/base/progress.h"
#include "core/project/capture.h"
#include "core/project/stages.h"

namespace bosk {

// What a stage cost: in this run, or in the earlier one whose result was taken from the cache.
struct StageTime {
  std::string stage;
  double seconds = 0.0;
  bool from_cache = false;
};

struct Run {
  Results results;  // those of the wanted stages; others may have been let go
  std::vector<StageTime> times;
  // What the results were made by and are stored under: the project's, but for `stop_after` of a
  // stage that its watcher ended early.
  Recipe recipe;
};

// The key of a stage's result: its inputs' content, its options and its version. Paths and times
// are no part of it.
std::map<std::string, ContentHash> stage_keys(const Capture& capture, const Recipe& recipe);
ContentHash stage_key(const Capture& capture, const Recipe& recipe, const std::string& stage);

// Whether the result lies in the cache (its content is checked only when it is loaded).
bool is_finished(const Project& project, const Capture& capture, const std::string& stage);

// What each finished stage took to make; the others are left out.
std::vector<StageTime> times_spent(const Project& project, const Capture& capture);

// The part of a job that a run is.
struct Share {
  double from = 0.0, to = 1.0;
};

// Makes the results of the wanted stages: from the cache where it holds them, else by computing
// them and what they need, each stored as soon as it is made. Killed and called again, it goes on
// after the last stored result, to the same bits. Only one process may work on a project: see
// lock.h.
//
// A stage that its watcher ends after iteration n goes into the cache as the result of
// `stop_after=n`, which gives the same bytes; the stages behind it go on from there. Ended after
// the last iteration it is simply finished.
//
// `known`: results that are held already, made from just this capture and recipe.
Run run_stages(const Project& project, const Capture& capture,
               const std::vector<std::string>& wanted, Progress& progress, Share share = {},
               const RunWatchers& watchers = {}, const Results& known = {});

}  // namespace bosk
