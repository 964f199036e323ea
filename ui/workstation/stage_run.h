#pragma once

#include <string>

#include "core/project/run.h"

namespace bosk {

struct Workspace;

std::string title_of_stage(const std::string& stage);

// Watchers that put what they are told into the steps' mailboxes.
RunWatchers watchers_of(Workspace& workspace);

// Where a stage was stopped early to keep what it had, the project takes over the options that give
// just that: those in which what a run used differs from what it was asked for.
void apply_what_was_used(Workspace& workspace, const Recipe& asked, const Recipe& used);

}  // namespace bosk
