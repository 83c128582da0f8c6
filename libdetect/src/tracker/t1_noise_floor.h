#pragma once

#include "tagmint/detect/image_view.h"

namespace tagmint::detect {

/// Stage T1: how noisy the picture is, and from that the least contrast that is worth a look.
///
/// Noise decides what detection costs: with a fixed floor of a few gray levels, noise alone passes
/// it everywhere and every stage after works on nothing. So the floor follows the noise.

/// Standard deviation of the noise, gray levels. Along some rows the second difference
/// a - 2 b + c of neighbouring pixels is zero for any slope of the light and has the deviation
/// sqrt(6) sigma for noise alone. Stretches of 32 of them give mean magnitudes; edges and texture
/// raise some, so the lower quartile of the stretches counts. Stretches with a pixel at 0 or 255
/// are left out, where the sensor's limit hides the noise.
///   returns  0 where no stretch can be judged (pictures narrower than 34 px)
///   cost     half the pixels of at most 24 rows
double estimate_noise(ImageView image);

/// The same from the calmest twentieth of the stretches: what texture covers does not count as
/// noise as long as a twentieth of the picture is smooth.
double estimate_calm_noise(ImageView image);

/// The contrast that 3 x 3 tiles (144 pixels) need to be looked at: noise alone spreads over less
/// than 7 sigma nearly everywhere.
///   least, most   bounds, gray levels
int contrast_floor(double noise_sigma, int least, int most);

}  // namespace tagmint::detect
