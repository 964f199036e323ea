#pragma once

#include <string>
#include <vector>

#include "core/base/options.h"
#include "core/billboard/billboard.h"
#include "core/calibrate/calibrate_options.h"
#include "core/compress/compress.h"
#include "core/matte/matte.h"
#include "core/opacity/opacity.h"
#include "core/photo/import.h"
#include "core/project/pack_options.h"
#include "core/radiance/radiance.h"

namespace bosk {

// Every knob of every stage.
struct Recipe {
  CalibrateOptions calibrate;
  PhotoOptions photo;
  MatteOptions matte;
  OpacityOptions opacity;
  RadianceOptions radiance;
  BillboardOptions texture;
  CompressOptions compress;
  PackOptions pack;
};

// The options of one stage, or of calibration, which comes before the first; on the command line
// each is --STAGE.NAME=VALUE.
struct OptionGroup {
  std::string stage;
  Options options;
};
// Calibration, then the stages in order; stages without options are left out. The groups point into
// `recipe`.
std::vector<OptionGroup> option_groups(Recipe& recipe);

// `name` is "stage.option". Throw Error when there is no such option or the value doesn't fit it.
void set_option(Recipe& recipe, const std::string& name, const std::string& value);
std::string option_text(const Recipe& recipe, const std::string& name);

}  // namespace bosk
