#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family.h"
#include "tagmint/detect/detector.h"
#include "tagmint/tagmint.h"

// What the opaque types of tagmint.h are.

struct tagmint_family {
  tagmint::codec::SharedFamily family;
};

struct tagmint_decoder {
  std::shared_ptr<const tagmint::codec::Decoder> decoder;
};

struct tagmint_detector {
  tagmint::detect::Detector detector;
  std::atomic_flag busy = {};
};

struct tagmint_detections {
  std::vector<tagmint_detection> tags;
  std::vector<tagmint::codec::SharedFamily> families;  ///< whose names the tags point to
};
