using System;

namespace Rabit.Geodesy;

/// <summary>
/// The terrain: altitudes of the ground above mean sea level at posts on a grid of latitude and longitude (a digital
/// elevation model), bilinear in between. Heights above the ellipsoid come in by <see cref="FromEllipsoidHeights"/>.
/// Immutable; any thread.
/// </summary>
/// <example>
/// <code>
/// using StreamReader file = File.OpenText("terrain.asc");
/// TerrainGrid terrain = AsciiGrid.Read(file);
/// var place = new GeographicPoint(Angle.FromDegrees(47.01), Angle.FromDegrees(8.02));
/// if (terrain.TryAltitude(place, out AmslAltitude ground) == TerrainLookup.Known)
///     Console.WriteLine(ground);
/// </code>
/// </example>
public sealed class TerrainGrid
{
    // On the outermost posts one is still inside, whatever rounding says.
    private const double Edge = 1e-9;

    private readonly float[] _altitudes;
    private readonly GeographicPoint _southWest;
    private readonly Angle _latitudeStep;
    private readonly Angle _longitudeStep;
    private readonly TerrainPyramid _pyramid;

    /// <summary>Makes the grid.</summary>
    /// <param name="southWest">The first post.</param>
    /// <param name="latitudeStep">From one row to the next one north of it.</param>
    /// <param name="longitudeStep">
    /// From one column to the next one east of it; the grid may cross the date line.
    /// </param>
    /// <param name="rows">Posts from south to north, at least 2.</param>
    /// <param name="columns">Posts from west to east, at least 2.</param>
    /// <param name="altitudesAmslMetres">
    /// Above mean sea level, row by row from the south, in each from the west; not a number where there is none.
    /// Copied.
    /// </param>
    /// <exception cref="ArgumentException">The numbers do not make a grid.</exception>
    public TerrainGrid(
        GeographicPoint southWest, Angle latitudeStep, Angle longitudeStep, int rows, int columns,
        ReadOnlySpan<float> altitudesAmslMetres)
    {
        if (rows < 2 || columns < 2 || (long)rows * columns != altitudesAmslMetres.Length)
        {
            throw new ArgumentException(
                $"A grid of {rows} x {columns} posts does not have {altitudesAmslMetres.Length} altitudes.",
                nameof(altitudesAmslMetres));
        }

        double north = southWest.Latitude.Radians + ((rows - 1) * latitudeStep.Radians);
        if (!(latitudeStep.Radians > 0 && longitudeStep.Radians > 0
            && columns * longitudeStep.Radians <= 2.001 * Math.PI)
            || !(southWest.Latitude.Degrees >= -90 - Edge && north <= (Math.PI / 2) + Edge)
            || !southWest.Longitude.IsFinite)
        {
            throw new ArgumentException(
                $"A grid from {southWest.Latitude}, {southWest.Longitude} in steps of {latitudeStep} and "
                    + $"{longitudeStep} is not on the earth.",
                nameof(southWest));
        }

        _southWest = southWest;
        _latitudeStep = latitudeStep;
        _longitudeStep = longitudeStep;
        (Rows, Columns) = (rows, columns);
        _altitudes = altitudesAmslMetres.ToArray();
        double highest = double.NegativeInfinity;
        foreach (float altitude in _altitudes)
            highest = altitude > highest ? altitude : highest;
        MaxAltitude = new AmslAltitude(highest);
        _pyramid = new TerrainPyramid(_altitudes, rows, columns, (float)highest);
    }

    /// <summary>Posts from south to north.</summary>
    public int Rows { get; }

    /// <summary>Posts from west to east.</summary>
    public int Columns { get; }

    /// <summary>The first post.</summary>
    public GeographicPoint SouthWest => _southWest;

    /// <summary>From one row of posts to the next.</summary>
    public Angle LatitudeStep => _latitudeStep;

    /// <summary>From one column of posts to the next.</summary>
    public Angle LongitudeStep => _longitudeStep;

    /// <summary>The highest post; minus infinity where no post has an altitude.</summary>
    public AmslAltitude MaxAltitude { get; }

    /// <summary>Makes the grid from heights above the ellipsoid, which it brings above mean sea level.</summary>
    /// <param name="southWest">The first post.</param>
    /// <param name="latitudeStep">From one row to the next one north of it.</param>
    /// <param name="longitudeStep">
    /// From one column to the next one east of it; the grid may cross the date line.
    /// </param>
    /// <param name="rows">Posts from south to north, at least 2.</param>
    /// <param name="columns">Posts from west to east, at least 2.</param>
    /// <param name="heightsMetres">
    /// Above the ellipsoid, row by row from the south, in each from the west; not a number where there is none. Copied.
    /// </param>
    /// <param name="geoid">How far the geoid is above the ellipsoid.</param>
    /// <exception cref="ArgumentException">The numbers do not make a grid.</exception>
    public static TerrainGrid FromEllipsoidHeights(
        GeographicPoint southWest,
        Angle latitudeStep,
        Angle longitudeStep,
        int rows,
        int columns,
        ReadOnlySpan<float> heightsMetres,
        GeoidGrid geoid)
    {
        if (geoid is null)
            throw new ArgumentNullException(nameof(geoid));

        // The posts are on the earth where this one can be made.
        _ = new TerrainGrid(southWest, latitudeStep, longitudeStep, rows, columns, heightsMetres);
        float[] altitudes = heightsMetres.ToArray();
        for (int i = 0; i < altitudes.Length; i++)
        {
            var post = new GeographicPoint(
                southWest.Latitude + (i / columns * latitudeStep), southWest.Longitude + (i % columns * longitudeStep));
            altitudes[i] -= (float)geoid.UndulationMetres(post);
        }

        return new TerrainGrid(southWest, latitudeStep, longitudeStep, rows, columns, altitudes);
    }

    /// <summary>The altitude of the ground at a place.</summary>
    /// <param name="point">The place.</param>
    /// <param name="altitude">Its altitude; not a number unless the answer is that it is known.</param>
    public TerrainLookup TryAltitude(GeographicPoint point, out AmslAltitude altitude)
    {
        altitude = new AmslAltitude(double.NaN);
        if (!TryFind(point, out double row, out double column))
            return TerrainLookup.Outside;
        int south = CellOf(row, Rows);
        int west = CellOf(column, Columns);
        (double v, double u) = (row - south, column - west);
        int at = (south * Columns) + west;
        double southern = ((1 - u) * _altitudes[at]) + (u * _altitudes[at + 1]);
        double northern = ((1 - u) * _altitudes[at + Columns]) + (u * _altitudes[at + Columns + 1]);
        altitude = new AmslAltitude(((1 - v) * southern) + (v * northern));
        return double.IsNaN(altitude.Metres) ? TerrainLookup.NoData : TerrainLookup.Known;
    }

    /// <summary>The highest ground of a box, and of the cells that reach into it.</summary>
    /// <param name="southWest">Its south-western corner.</param>
    /// <param name="northEast">
    /// Its north-eastern corner; a box that leaves the grid at its east to come in again at its west is outside.
    /// </param>
    /// <param name="altitude">Not below any of its ground; not a number unless the answer is that it is known.</param>
    /// <returns>Outside where any of the box is; no data where any post of its cells has none.</returns>
    public TerrainLookup TryMaxAltitude(
        GeographicPoint southWest, GeographicPoint northEast, out AmslAltitude altitude)
    {
        altitude = new AmslAltitude(double.NaN);
        if (!TryFind(southWest, out double south, out double west)
            || !TryFind(northEast, out double north, out double east) || north < south || east < west)
            return TerrainLookup.Outside;
        float highest = float.NegativeInfinity;
        for (int row = CellOf(south, Rows); row <= CellOf(north, Rows) + 1; row++)
        {
            for (int column = CellOf(west, Columns); column <= CellOf(east, Columns) + 1; column++)
                highest = Math.Max(highest, _altitudes[(row * Columns) + column]);
        }

        altitude = new AmslAltitude(highest);
        return float.IsNaN(highest) ? TerrainLookup.NoData : TerrainLookup.Known;
    }

    /// <summary>
    /// The largest of the grid's blocks around a place that an altitude is above, of 2, 4, 8 and so on times eight
    /// cells along a side; the cell of the place where it is above none. What looks for where a line meets the ground
    /// goes on to the block's border or down to its highest post.
    /// </summary>
    /// <param name="point">The place.</param>
    /// <param name="altitude">The altitude.</param>
    /// <param name="block">The block; nothing if the answer is false.</param>
    /// <returns>False where the place is outside.</returns>
    public bool TryFindBlock(GeographicPoint point, AmslAltitude altitude, out TerrainBlock block)
    {
        block = default;
        if (!TryFind(point, out double row, out double column))
            return false;
        int south = CellOf(row, Rows);
        int west = CellOf(column, Columns);
        int side = _pyramid.FindBlock(south, west, altitude.Metres, out float highest);
        float lowest = float.NegativeInfinity;
        if (side == 1)
            (lowest, highest) = PostsOf(south, west);
        south = south / side * side;
        west = west / side * side;
        int north = Math.Min(south + side, Rows - 1);
        int east = Math.Min(west + side, Columns - 1);
        block = new TerrainBlock(
            point.Latitude + ((south - row) * _latitudeStep), point.Latitude + ((north - row) * _latitudeStep),
            point.Longitude + ((west - column) * _longitudeStep), point.Longitude + ((east - column) * _longitudeStep),
            new AmslAltitude(lowest), new AmslAltitude(highest), side == 1);
        return true;
    }

    private static int CellOf(double position, int posts) => Math.Max(0, Math.Min(posts - 2, (int)position));

    private bool TryFind(GeographicPoint point, out double row, out double column)
    {
        row = (point.Latitude - _southWest.Latitude).Radians / _latitudeStep.Radians;
        double east = (point.Longitude - _southWest.Longitude).Wrapped().Radians;
        column = (east < -Edge ? east + (2 * Math.PI) : east) / _longitudeStep.Radians;
        return row >= -Edge && row <= Rows - 1 + Edge && column >= -Edge && column <= Columns - 1 + Edge;
    }

    // Not a number where one has no altitude: a maximum of numbers keeps that.
    private (float Lowest, float Highest) PostsOf(int south, int west)
    {
        int at = (south * Columns) + west;
        (float a, float b) = (_altitudes[at], _altitudes[at + 1]);
        (float c, float d) = (_altitudes[at + Columns], _altitudes[at + Columns + 1]);
        return (Math.Min(Math.Min(a, b), Math.Min(c, d)), Math.Max(Math.Max(a, b), Math.Max(c, d)));
    }
}
