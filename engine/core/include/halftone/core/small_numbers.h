#pragma once
// Every small number in the engine but digits of constants (tests/stability finds others). None of them is a
// tolerance of geometry: there, margins are rounding bounds (rounding.h).

namespace halftone::core {

/// Half the distance from 1 to the next double: the largest relative error of one rounding.
inline constexpr double unit_roundoff = 0x1p-53;

// Rules of the scene format.

/// Positive numbers are at least this.
inline constexpr double smallest_number = 1e-60;
/// How far from its place a vertex may be, in longest edges (section 1): files have rounded decimals.
inline constexpr double planar_slack = 1e-6;
/// Faces of different objects coincide within this share of the extent (section 3).
inline constexpr double touching = 0x1p-36;
/// Sine of the angle up to which planes are parallel, as are cones. A face narrower than the touching
/// distance lies near planes that it crosses; only the angle tells them apart. The normal of a face of that
/// width is known to 2^-17 (coordinates round at 2^-53 of the extent), so an angle of 2^-10 is one.
inline constexpr double parallel = 0x1p-10;
/// Cells in which planes are looked up, as a share of what can occur: several times the margins.
inline constexpr double plane_cell = 0x1p-8;
/// Cells in which centers and axes are looked up, as a share of their distance from the origin.
inline constexpr double point_cell = 0x1p-20;

// Lengths of the picture, in pixels.

/// Between a circle on the screen and its chords, for the paper's method.
inline constexpr double sagitta = 0x1p-10;
/// The same as a share of the quality, in 8-bit levels: on an edge between black and white the chords take
/// two thirds of it, of 255 levels, which is two thirds of the quality.
inline constexpr double sagitta_of_quality = 0x1p-8;
/// Width within which a line of the paper's method finds a boundary. Half of it is the error: an edge between
/// black and white is off by 1/256 of linear light at most.
inline constexpr double line_resolution = 0x1p-7;
/// Of a pixel's area. Pieces up to that are not cut where light varies in them: a pixel has few more parts
/// than twice its inverse, however many pieces its faces, shadows and patterns make of it.
inline constexpr double least_cut = 0x1p-13;
/// Corners of a piece are sampled this share of the way towards its middle, off the edge that they lie on.
inline constexpr double corner_inset = 0x1p-8;

} // namespace halftone::core
