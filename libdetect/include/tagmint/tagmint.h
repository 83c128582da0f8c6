#ifndef TAGMINT_TAGMINT_H
#define TAGMINT_TAGMINT_H
/*
 * tagmint for C (C11) and for every language that calls C: families, decoding, detection, poses.
 *
 * Results.  Functions that can fail return a tagmint_status and write their result through the last
 *   argument, only where they return TAGMINT_OK. tagmint_last_error() then says what went wrong.
 *   No C++ exception leaves a function. A null pointer where one is not allowed is
 *   TAGMINT_ERROR_ARGUMENT. Any function may also return TAGMINT_ERROR_MEMORY and
 *   TAGMINT_ERROR_INTERNAL; what else it may return stands with it.
 * Ownership.  What tagmint_..._create, _find, _load, _parse and _detect hand out belongs to the
 *   caller, who gives it back once with the matching tagmint_..._free; NULL may be given back.
 *   Objects keep what they were made of alive, so a family may be freed before its decoder. Texts
 * and arrays inside of objects live as long as these. Threads.  Families, decoders and detections
 * are constant: any number of threads may use one at the same time. A detector serves one caller at
 * a time; another one gets TAGMINT_ERROR_BUSY. Freeing an object while somebody uses it is the
 * caller's mistake. Versions.  TAGMINT_C_VERSION counts up when something is added; nothing that is
 * here changes.
 *
 * Conventions (docs/conventions.md): image x right, y down, pixel (0, 0) covers [0,1) x [0,1);
 * corners 0 bottom left, 1 bottom right, 2 top right, 3 top left of the upright tag's border
 * square; metres; camera x right, y down, z forward.
 */
#include <stddef.h>
#include <stdint.h>

#ifndef TAGMINT_API /* tagmint/codec/export.h says the same to C++ */
#define TAGMINT_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define TAGMINT_C_VERSION 1

typedef enum tagmint_status {
  TAGMINT_OK = 0,
  TAGMINT_NOTHING = 1,        /* no error: there is nothing, no tag near the word, no pose */
  TAGMINT_ERROR_ARGUMENT = 2, /* an argument is null or outside its range */
  TAGMINT_ERROR_INPUT = 3,    /* a family is not known, a file cannot be read or is malformed */
  TAGMINT_ERROR_BUSY = 4,     /* another thread is using the detector */
  TAGMINT_ERROR_MEMORY = 5,   /* out of memory */
  TAGMINT_ERROR_INTERNAL = 6  /* a fault of the library or of the system */
} tagmint_status;

/* TAGMINT_C_VERSION and version ("0.1.0") of the library that is linked. Cannot fail. */
TAGMINT_API int tagmint_c_version(void);
TAGMINT_API const char* tagmint_version(void);

/* What went wrong in the last call of this thread that returned an error: one line, what, where and
 * how to mend it; "" before the first one. Valid until the next call of this thread that fails.
 * Cannot fail. */
TAGMINT_API const char* tagmint_last_error(void);

/* ---- Families ------------------------------------------------------------------------------- */

/* A set of tags: their layout and codewords. */
typedef struct tagmint_family tagmint_family;

typedef struct tagmint_family_info {
  const char* name;        /* lives as long as the family */
  uint32_t codes;          /* tags; ids are 0 .. codes - 1 */
  int32_t bits;            /* data cells of a tag, at most 64 */
  int32_t min_hamming;     /* least distance of two tags in any rotation, bits */
  int32_t safe_errors;     /* bit errors that are always corrected, (min_hamming - 1) / 2 */
  int32_t width;           /* side of the whole tag, cells */
  int32_t width_at_border; /* side of the border square, cells */
  int32_t reversed_border; /* 0: black inside white; 1: white inside black */
} tagmint_family_info;

/* How many families are bundled, and the name of each, by index from 0; NULL for another index.
 * Cannot fail. */
TAGMINT_API size_t tagmint_bundled_count(void);
TAGMINT_API const char* tagmint_bundled_name(size_t index);

/* The bundled family of that name. TAGMINT_ERROR_INPUT where there is none. */
TAGMINT_API tagmint_status tagmint_family_find(const char* name, tagmint_family** family);

/* A bundled name or the path of a family file (docs/family-format.md). TAGMINT_ERROR_INPUT with
 * file and line. */
TAGMINT_API tagmint_status tagmint_family_load(const char* name_or_path, tagmint_family** family);

/* A family from the text of a family file.
 *   text, size   size bytes, no zero needed at the end
 *   source       how messages call the text, for example its path
 * TAGMINT_ERROR_INPUT with source and line. */
TAGMINT_API tagmint_status tagmint_family_parse(const char* text, size_t size, const char* source,
                                                tagmint_family** family);

TAGMINT_API void tagmint_family_free(tagmint_family* family);

TAGMINT_API tagmint_status tagmint_family_get_info(const tagmint_family* family,
                                                   tagmint_family_info* info);

/* The codeword of a tag: bit 1 = white, first data cell in the highest of the `bits` low bits
 * (docs/layouts.md). TAGMINT_ERROR_ARGUMENT for an id that the family lacks. */
TAGMINT_API tagmint_status tagmint_family_codeword(const tagmint_family* family, uint32_t id,
                                                   uint64_t* codeword);

/* The cells of a tag, row by row from the top left: 'b' black, 'w' white, 'x' no cell.
 *   cells      room for `capacity` characters; width * width are written, and no zero after them
 * TAGMINT_ERROR_ARGUMENT for an id that the family lacks, or too little room. */
TAGMINT_API tagmint_status tagmint_family_cells(const tagmint_family* family, uint32_t id,
                                                size_t capacity, char* cells);

/* ---- Decoding ------------------------------------------------------------------------------- */

/* Finds the tag nearest to a word, in all four rotations. */
typedef struct tagmint_decoder tagmint_decoder;

typedef struct tagmint_match {
  uint32_t id;
  int32_t hamming;  /* bit errors */
  int32_t rotation; /* quarter turns counter-clockwise that take the word to the codeword, 0..3 */
} tagmint_match;

/* Corrects as many errors as the ids in use allow, two at most. */
#define TAGMINT_DEFAULT_ERRORS (-1)

/* A decoder for all ids of a family, or for some.
 *   max_errors      bit errors to correct, 0 .. what is safe for the ids, or TAGMINT_DEFAULT_ERRORS
 *   ids, id_count   those to recognise; NULL and 0 = all
 * TAGMINT_ERROR_ARGUMENT for more errors than are safe and for an id that the family lacks. */
TAGMINT_API tagmint_status tagmint_decoder_create(const tagmint_family* family, int32_t max_errors,
                                                  const uint32_t* ids, size_t id_count,
                                                  tagmint_decoder** decoder);

TAGMINT_API void tagmint_decoder_free(tagmint_decoder* decoder);

/* TAGMINT_NOTHING where no tag is within the errors that are corrected; TAGMINT_ERROR_ARGUMENT for
 * a word of more bits than the family has. */
TAGMINT_API tagmint_status tagmint_decoder_decode(const tagmint_decoder* decoder, uint64_t word,
                                                  tagmint_match* match);

/* ---- Detection ------------------------------------------------------------------------------ */

/* Finds tags in pictures; keeps its memory from one to the next. */
typedef struct tagmint_detector tagmint_detector;

typedef struct tagmint_detector_options {
  size_t struct_size;         /* set by tagmint_detector_options_init() */
  double decimate;            /* >= 1: look in a picture so many times smaller; 1 */
  double blur_sigma_px;       /* blur before, below 0: sharpen; 0 */
  double min_decision_margin; /* gray levels; drop tags that are less clear; 0 */
  int32_t refine_edges;       /* 0 or 1: fit the edges again in the full picture; 1 */
  int32_t threads;            /* that share one picture; 0 = all cores; 1. Results stay the same */
} tagmint_detector_options;

/* Fills in the defaults, which stand last in the comments above. NULL is left alone. Cannot fail.
 */
TAGMINT_API void tagmint_detector_options_init(tagmint_detector_options* options);

/* A gray picture of the caller's, 8 bits a pixel. */
typedef struct tagmint_image {
  const uint8_t* data; /* the first pixel of the top row; not kept after the call */
  int32_t width;       /* pixels, >= 0 */
  int32_t height;      /* rows, >= 0 */
  ptrdiff_t stride;    /* bytes from one row to the next; negative where the bottom row is first in
                        * memory */
} tagmint_image;

typedef struct tagmint_detection {
  const char* family; /* its name */
  uint32_t id;
  int32_t hamming;        /* corrected bit errors */
  double decision_margin; /* how clearly it was read, gray levels */
  double center[2];       /* x, y; pixels */
  double corners[4][2];   /* of the border square, x, y; pixels */
  double homography[9];   /* row-major, border square [-1,1]^2 -> pixels */
} tagmint_detection;

/* The tags of one picture, sorted by family name, id and place. */
typedef struct tagmint_detections tagmint_detections;

/* A detector for the families of some decoders.
 *   decoders, count   at least one; each knows its family, its ids and how many errors to correct
 *   options           NULL = the defaults
 * TAGMINT_ERROR_ARGUMENT for an option out of range, named in the message, and for options that
 * tagmint_detector_options_init() has not seen. */
TAGMINT_API tagmint_status tagmint_detector_create(const tagmint_decoder* const* decoders,
                                                   size_t count,
                                                   const tagmint_detector_options* options,
                                                   tagmint_detector** detector);

TAGMINT_API void tagmint_detector_free(tagmint_detector* detector);

/* Finds all tags. TAGMINT_ERROR_ARGUMENT for a picture without data, with negative sides or with a
 * stride below its width; TAGMINT_ERROR_BUSY. No tag is no error: the count is 0. */
TAGMINT_API tagmint_status tagmint_detector_detect(tagmint_detector* detector,
                                                   const tagmint_image* image,
                                                   tagmint_detections** detections);

TAGMINT_API void tagmint_detections_free(tagmint_detections* detections);

/* How many there are, and the first of them; 0 and NULL of NULL. Cannot fail. */
TAGMINT_API size_t tagmint_detections_count(const tagmint_detections* detections);
TAGMINT_API const tagmint_detection* tagmint_detections_data(const tagmint_detections* detections);

/* ---- Poses ---------------------------------------------------------------------------------- */

typedef struct tagmint_camera {
  double fx, fy;             /* focal lengths, px, > 0 */
  double cx, cy;             /* principal point, px; the first pixel's centre is (0.5, 0.5) */
  double k1, k2, p1, p2, k3; /* Brown-Conrady distortion as OpenCV has it; 0 = none */
} tagmint_camera;

/* point_in_camera = R point_in_tag + t; tag: x right, y down, z away from the viewer. */
typedef struct tagmint_pose {
  double R[9];  /* row-major */
  double t[3];  /* metres */
  double error; /* mean squared distance of the corners from their lines of sight, m^2 */
} tagmint_pose;

typedef struct tagmint_pose_estimate {
  tagmint_pose best;
  int32_t has_alternative; /* 1 where another pose explains the corners about as well */
  tagmint_pose alternative;
} tagmint_pose_estimate;

/* The pose of a tag from its corners.
 *   corners   as tagmint_detection has them
 *   edge_m    side of the border square, metres, > 0
 * TAGMINT_NOTHING where the corners are degenerate or would lie behind the camera;
 * TAGMINT_ERROR_ARGUMENT for an impossible camera or edge. Any number of threads. */
TAGMINT_API tagmint_status tagmint_estimate_pose(const double (*corners)[2],
                                                 const tagmint_camera* camera, double edge_m,
                                                 tagmint_pose_estimate* pose);

#ifdef __cplusplus
}
#endif

#endif /* TAGMINT_TAGMINT_H */
