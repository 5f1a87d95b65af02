namespace Rabit.Geodesy;

/// <summary>A part of a terrain grid between two parallels and two meridians, and the altitudes in it.</summary>
/// <param name="South">Its southern border.</param>
/// <param name="North">Its northern border.</param>
/// <param name="West">Its western border; of the same turn as the place that was asked for.</param>
/// <param name="East">Its eastern border, too.</param>
/// <param name="MinAltitude">
/// Of a cell between four posts, the lowest of them; of a larger block minus infinity. Not a number where a post has
/// no altitude.
/// </param>
/// <param name="MaxAltitude">
/// Nothing in it, and within a post's distance around it, is higher. Where a post has no altitude, the highest of the
/// whole grid; of a cell the highest of its posts alone, and not a number where one has no altitude.
/// </param>
/// <param name="IsCell">Whether it is one cell, between four posts.</param>
public readonly record struct TerrainBlock(
    Angle South, Angle North, Angle West, Angle East, AmslAltitude MinAltitude, AmslAltitude MaxAltitude, bool IsCell);
