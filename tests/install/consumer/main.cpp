// Finds the tags of a picture that is already in memory.
#include <iostream>
#include <memory>

#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/detect/detector.h"
#include "tagmint/detect/image.h"
#include "tagmint/detect/pose.h"

int main() {
  namespace codec = tagmint::codec;
  namespace detect = tagmint::detect;

  // What to look for; corrects up to two bit errors unless told otherwise.
  auto decoder = std::make_shared<const codec::Decoder>(codec::find_family("tag36h11"));
  detect::Detector detector({decoder});

  const detect::Image picture(640, 480, 128);  // any pixels: ImageView{data, width, height, stride}
  const detect::Camera camera{.fx = 600, .fy = 600, .cx = 320, .cy = 240};
  for (const detect::Detection& tag : detector.detect(picture)) {
    std::cout << tag.family->name() << ' ' << tag.id << '\n';
    if (const auto pose = detect::estimate_pose(tag.corners, camera, 0.1)) {
      std::cout << "  " << pose->best.t[2] << " m away\n";
    }
  }
}
