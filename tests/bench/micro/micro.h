#pragma once
// The kernels that are timed, a file for each. Items are what a kernel is asked for: lines, rays, rows.

namespace halftone::micro {

void add_lines();          ///< a line against each kind of solid
void add_refracted_rays(); ///< batches of them, in scenes of 8 to 1,000 solids
void add_rows();           ///< whole pictures, by area
void add_shadows();        ///< where they may fall: all faces of a scene, all lights
void add_stream();         ///< decoding the protocol
void add_pictures();       ///< writing PNG

} // namespace halftone::micro
