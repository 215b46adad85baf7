#pragma once
// A scene as a scene description of POV-Ray 3.7, in world coordinates.
//
// What POV-Ray has another model for, so that its picture is another one:
// - Shadows of glass: light through glass loses what the surface's finish and the interior's fade say; what
//   reflects totally on the straight segment is not dark.
// - Nested and overlapping glass: a boundary is seen wherever a surface is, whichever solid stands last in
// the
//   file; the medium behind is the one that was entered last.
// - Contact: surfaces nearer than POV-Ray's tolerance (1e-4 to 1e-3 units) are met in any order.
// - A highlight has the light's colour and one strength: that of `specular`, as the mean of its channels.
// - The sides of a faceted stand-in have normals interpolated between their corners.
// - A face in a plane of its own pattern takes the cell that rounding gives it.
// - `cutoff` bounds a weight of POV-Ray's own (adc_bailout).

#include <halftone/scene/scene.h>

#include <string>

namespace halftone::convert {

/// Linear radiance times the scene's exposure. Rendered at the scene's width and height, with
/// `File_Gamma=srgb` or `File_Gamma=1.0` for its transfer; the text begins with the command.
std::string povray(const scene::Scene& scene);

} // namespace halftone::convert
