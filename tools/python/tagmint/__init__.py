"""Make, print and find square fiducial tags (AprilTags).

>>> import tagmint, numpy
>>> family = tagmint.family("tag36h11")
>>> picture = numpy.full((200, 200), 220, numpy.uint8)
>>> cells = numpy.kron(family.cells(7), numpy.ones((10, 10), numpy.uint8))
>>> picture[50:150, 50:150] = cells
>>> [(tag.family, tag.id) for tag in tagmint.Detector([family]).detect(picture)]
[('tag36h11', 7)]
"""
from ._core import (Camera, Decoder, Detection, Detector, DoesNotFit, Family, InputError, Match,
                    OutputError, Pose, PoseEstimate, __version__, estimate_pose, family,
                    family_names, generate, generate_rotation_code, sheet)

__all__ = ["Camera", "Decoder", "Detection", "Detector", "DoesNotFit", "Family", "InputError",
           "Match", "OutputError", "Pose", "PoseEstimate", "__version__", "estimate_pose", "family",
           "family_names", "generate", "generate_rotation_code", "sheet"]
