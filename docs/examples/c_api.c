/* docs/examples/c_api.c: draws a tag, finds it and says where it is, in C. */
#include <stdio.h>
#include <stdlib.h>

#include "tagmint/tagmint.h"

enum { kCell = 8, kSide = 160 };

/* The tag's cells as squares of kCell pixels in the middle of a white picture. */
static int draw(const tagmint_family* family, uint32_t id, uint8_t* pixels) {
  tagmint_family_info info;
  char cells[64 * 64];
  int x, y;
  if (tagmint_family_get_info(family, &info) != TAGMINT_OK ||
      tagmint_family_cells(family, id, sizeof cells, cells) != TAGMINT_OK) {
    return 0;
  }
  for (y = 0; y < kSide; ++y) {
    for (x = 0; x < kSide; ++x) {
      const int column = (x - (kSide - info.width * kCell) / 2) / kCell;
      const int row = (y - (kSide - info.width * kCell) / 2) / kCell;
      const int inside = column >= 0 && row >= 0 && column < info.width && row < info.width;
      pixels[y * kSide + x] = inside && cells[row * info.width + column] == 'b' ? 30 : 220;
    }
  }
  return 1;
}

static void print(const tagmint_detection* tag) {
  const tagmint_camera camera = {.fx = 600, .fy = 600, .cx = kSide / 2.0, .cy = kSide / 2.0};
  tagmint_pose_estimate pose;
  printf("%s id %u, %d errors\n", tag->family, (unsigned)tag->id, (int)tag->hamming);
  if (tagmint_estimate_pose(tag->corners, &camera, 0.04, &pose) == TAGMINT_OK) {
    printf("%.3f m away\n", pose.best.t[2]);
  }
}

int main(void) {
  static uint8_t pixels[kSide * kSide];
  const tagmint_image image = {pixels, kSide, kSide, kSide};
  const tagmint_decoder* decoders[1];
  tagmint_family* family = NULL;
  tagmint_decoder* decoder = NULL;
  tagmint_detector* detector = NULL;
  tagmint_detections* found = NULL;
  size_t i;
  int done = 0;

  if (tagmint_family_load("tag36h11", &family) == TAGMINT_OK && draw(family, 42, pixels) &&
      tagmint_decoder_create(family, TAGMINT_DEFAULT_ERRORS, NULL, 0, &decoder) == TAGMINT_OK) {
    decoders[0] = decoder;
    if (tagmint_detector_create(decoders, 1, NULL, &detector) == TAGMINT_OK &&
        tagmint_detector_detect(detector, &image, &found) == TAGMINT_OK) {
      for (i = 0; i < tagmint_detections_count(found); ++i)
        print(&tagmint_detections_data(found)[i]);
      done = tagmint_detections_count(found) == 1;
    }
  }
  if (!done) fprintf(stderr, "%s\n", tagmint_last_error());
  tagmint_detections_free(found);
  tagmint_detector_free(detector);
  tagmint_decoder_free(decoder);
  tagmint_family_free(family);
  return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
