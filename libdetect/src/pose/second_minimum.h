#pragma once

#include <optional>

#include "pose/pose_problem.h"

namespace tagmint::detect {

/// The rotation near which the other local minimum of the object-space error lies. Seen along the
/// line of sight to the tag's middle, a flat tag that leans to one side looks much like one that
/// leans to the other; the error along that family of rotations is a quotient of polynomials in the
/// tangent of half the leaning angle, so all its minima are roots of a polynomial of degree four.
///   first    a local minimum
///   returns  the other minimum of least error that shows the tag's front; nothing when there is
///            none. Orthogonal iteration from there may still slide back to `first`.
///   source   [Schweighofer2006, sections 4.1 and 4.2]
std::optional<Eigen::Matrix3d> second_minimum(const PoseProblem& problem, const RigidPose& first);

}  // namespace tagmint::detect
