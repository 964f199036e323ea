#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/binary.h"
#include "core/base/content_hash.h"
#include "core/project/capture.h"
#include "core/project/stored_images.h"

namespace bosk {

// What the stages of a run have made and is held in memory; null: not made, not loaded or let go.
struct Results {
  std::shared_ptr<const ImportedPhotos> imported;  // every photo, with pixels
  std::shared_ptr<const Photos> views;   // the photos that are not left out, without pixels
  std::shared_ptr<const Mattes> mattes;  // in the order of `views`
  std::shared_ptr<const OpacityTree> opacity;
  std::shared_ptr<const RadianceVolume> radiance;
  std::shared_ptr<const Billboards> billboards;
  std::shared_ptr<const CodedTextures> textures;
  std::shared_ptr<const std::vector<std::byte>> package;
};

// Who is told of a stage's state while it is computed, in the thread that runs it; none of them is
// called where the result comes from the cache. The first two may end their stage early, after the
// iteration they were told of.
struct RunWatchers {
  OpacityWatcher opacity;
  RadianceWatcher radiance;
  CompressWatcher compress;
};

// One step from photos to package. To add one: its result above, its options in Recipe, a row in
// stages.cpp.
struct Stage {
  std::string name;   // of its options and cache entries
  std::string title;  // for people
  int version = 1;    // raised whenever the same inputs and options give another result
  double share = 1;   // of a run's time, roughly: for the remaining time
  std::vector<std::string> inputs;  // stages whose results `compute` reads
  std::function<Options(Recipe&)> options;
  // What else the result depends on: files, names.
  std::function<void(ContentHasher&, const Capture&)> hash_sources;
  std::function<void(const Capture&, const Recipe&, Results&, Progress&, const RunWatchers&)>
      compute;
  std::function<bool(const Results&)> is_held;
  std::function<void(Results&)> let_go;
  std::function<void(BinaryWriter&, const Results&)> write;
  std::function<void(BinaryReader&, Results&)> read;
};

// Every stage, each after its inputs.
const std::vector<Stage>& stages();
const Stage& stage_named(const std::string& name);
// The stage and all that it needs, in order.
std::vector<std::string> stages_up_to(const std::string& name);

}  // namespace bosk
