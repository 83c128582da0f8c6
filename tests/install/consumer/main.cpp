// A program that uses the installed package: looks for tags in an empty picture.
#include <iostream>
#include <memory>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/version.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/image.h"

int main() {
  const tagmint::codec::SharedFamily family = tagmint::codec::find_family("tag36h11");
  if (!family || family->size() != 587) return 1;
  auto decoder = std::make_shared<const tagmint::codec::Decoder>(family);
  if (decoder->decode(family->codeword(42))->id != 42) return 1;
  tagmint::detect::Detector detector({decoder});
  const tagmint::detect::Image empty(64, 48, 128);
  if (!detector.detect(empty).empty()) return 1;
  std::cout << "tagmint " << tagmint::codec::kVersion << " works\n";
}
