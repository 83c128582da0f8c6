#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/decoder_option.h"
#include "draw/overlay.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector_options.h"

namespace tagmint::cli {

/// The options of `tagmint detect` as they were given; empty texts where they were not.
struct DetectArguments {
  std::vector<std::string> families;
  std::string format;
  std::string algorithm = "tracker";  ///< "tracker" or "paper"
  detect::DetectorOptions detector;
  DecoderArguments decoding;
  bool no_refine = false;
  bool no_photometric = false;
  bool fixed_contrast = false;
  bool unusual_prints = false;
  std::string camera;
  std::string distortion;
  std::string edge;
  std::string overlay;
  std::string debug;
  bool require = false;
  bool stats = false;
  std::string output;
  std::vector<std::string> images;
};

/// One image and the files to be written for it; empty paths where none are.
struct ImageTask {
  std::string image;  ///< a path, or "-" for stdin
  std::filesystem::path overlay;
  std::filesystem::path debug_folder;
};

/// What `tagmint detect` does, checked: nothing is read or written before this stands.
struct DetectPlan {
  std::vector<std::shared_ptr<const codec::Decoder>> decoders;
  detect::DetectorOptions detector;        ///< without the number of threads
  std::optional<draw::AxesSetting> poses;  ///< where poses are wanted
  std::string format;                      ///< "text", "jsonl" or "csv"
  std::vector<ImageTask> tasks;            ///< in the order of the arguments
};

/// Throws UsageError for options that do not go together, InputError for a family that cannot be
/// read.
DetectPlan plan_detection(const DetectArguments& arguments);

}  // namespace tagmint::cli
