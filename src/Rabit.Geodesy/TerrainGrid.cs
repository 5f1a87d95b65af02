using System;

namespace Rabit.Geodesy;

/// <summary>
/// Heights of the ground at posts on a grid of latitude and longitude, bilinear in between. They are above whatever the altitudes are above
/// that it is used with: mean sea level, unless one knows better. Immutable; any thread.
/// </summary>
public sealed class TerrainGrid
{
    // On the outermost posts one is still inside, whatever rounding says.
    private const double Edge = 1e-9;

    private readonly float[] _heights;
    private readonly GeographicPoint _southWest;
    private readonly Angle _latitudeStep;
    private readonly Angle _longitudeStep;

    /// <summary>Makes the grid.</summary>
    /// <param name="southWest">The first post.</param>
    /// <param name="latitudeStep">From one row to the next one north of it.</param>
    /// <param name="longitudeStep">From one column to the next one east of it; the grid may cross the date line.</param>
    /// <param name="rows">Posts from south to north, at least 2.</param>
    /// <param name="columns">Posts from west to east, at least 2.</param>
    /// <param name="heightsMetres">Row by row from the south, in each from the west; not a number where there is none. Copied.</param>
    /// <exception cref="ArgumentException">The numbers do not make a grid.</exception>
    public TerrainGrid(GeographicPoint southWest, Angle latitudeStep, Angle longitudeStep, int rows, int columns, ReadOnlySpan<float> heightsMetres)
    {
        if (rows < 2 || columns < 2 || (long)rows * columns != heightsMetres.Length)
            throw new ArgumentException($"A grid of {rows} x {columns} posts does not have {heightsMetres.Length} heights.", nameof(heightsMetres));
        double north = southWest.Latitude.Radians + ((rows - 1) * latitudeStep.Radians);
        if (!(latitudeStep.Radians > 0 && longitudeStep.Radians > 0 && columns * longitudeStep.Radians <= 2.001 * Math.PI)
            || !(southWest.Latitude.Degrees >= -90 - Edge && north <= (Math.PI / 2) + Edge) || !southWest.Longitude.IsFinite)
            throw new ArgumentException($"A grid from {southWest.Latitude}, {southWest.Longitude} in steps of {latitudeStep} and {longitudeStep} is not on the earth.", nameof(southWest));
        _southWest = southWest;
        _latitudeStep = latitudeStep;
        _longitudeStep = longitudeStep;
        (Rows, Columns) = (rows, columns);
        _heights = heightsMetres.ToArray();
        HighestMetres = double.NegativeInfinity;
        foreach (float height in _heights)
            HighestMetres = height > HighestMetres ? height : HighestMetres;
    }

    /// <summary>Posts from south to north.</summary>
    public int Rows { get; }

    /// <summary>Posts from west to east.</summary>
    public int Columns { get; }

    /// <summary>The highest post, metres; minus infinity where no post has a height.</summary>
    public double HighestMetres { get; }

    /// <summary>The height of the ground at a place.</summary>
    /// <param name="point">The place.</param>
    /// <param name="metres">Its height; not a number unless the answer is that it is known.</param>
    public TerrainLookup TryHeight(GeographicPoint point, out double metres)
    {
        metres = double.NaN;
        double row = (point.Latitude - _southWest.Latitude).Radians / _latitudeStep.Radians;
        double east = (point.Longitude - _southWest.Longitude).Wrapped().Radians;
        double column = (east < -Edge ? east + (2 * Math.PI) : east) / _longitudeStep.Radians;
        if (!(row >= -Edge && row <= Rows - 1 + Edge && column >= -Edge && column <= Columns - 1 + Edge))
            return TerrainLookup.Outside;
        int south = Math.Max(0, Math.Min(Rows - 2, (int)row));
        int west = Math.Max(0, Math.Min(Columns - 2, (int)column));
        (double v, double u) = (row - south, column - west);
        int at = (south * Columns) + west;
        double southern = ((1 - u) * _heights[at]) + (u * _heights[at + 1]);
        double northern = ((1 - u) * _heights[at + Columns]) + (u * _heights[at + Columns + 1]);
        metres = ((1 - v) * southern) + (v * northern);
        return double.IsNaN(metres) ? TerrainLookup.NoData : TerrainLookup.Known;
    }
}
