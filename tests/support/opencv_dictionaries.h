#pragma once

#include <string>
#include <vector>

#include "tagmint/codec/family.h"

namespace tagmint::test {

/// One of the dictionaries that the installed OpenCV has built in, cell by cell as it is.
struct OpenCvDictionary {
  std::string name;      ///< "DICT_4X4_50"
  codec::Family family;  ///< declares distance 1, whatever is true
  int declared = 0;      ///< distance that the documentation in OpenCV's header gives
  int corrects = 0;      ///< its maxCorrectionBits
};

/// All of them, in the order of OpenCV's enumeration.
std::vector<OpenCvDictionary> opencv_dictionaries();

}  // namespace tagmint::test
