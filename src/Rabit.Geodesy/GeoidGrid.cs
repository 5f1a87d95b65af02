using System;

namespace Rabit.Geodesy;

/// <summary>
/// How far the geoid, which is mean sea level, is above the WGS-84 ellipsoid (its undulation), at posts over the whole
/// earth, bilinear in between. Read from a file by <see cref="GeoidPgm"/> or <see cref="Egm96Dac"/>; none is in the
/// package. Immutable; any thread.
/// </summary>
/// <example>
/// <code>
/// using FileStream file = File.OpenRead("/usr/share/GeographicLib/geoids/egm96-15.pgm");
/// GeoidGrid geoid = GeoidPgm.Read(file);
/// GeodeticPosition home = GeodeticPosition.FromDegrees(47.3977, 8.5456, altitudeAmslMetres: 488);
/// EllipsoidHeight height = home.ToEllipsoid(geoid).Height;      // about 47 m more
/// var frame = new LocalNedFrame(home, geoid);
/// </code>
/// </example>
public sealed class GeoidGrid
{
    // Of each post, row by row from the north pole, in each from Greenwich to the east.
    private readonly ushort[] _posts;
    private readonly int _rows;
    private readonly int _columns;
    private readonly double _offsetMetres;
    private readonly double _scaleMetres;

    internal GeoidGrid(ushort[] posts, int rows, int columns, double offsetMetres, double scaleMetres)
        => (_posts, _rows, _columns, _offsetMetres, _scaleMetres) = (posts, rows, columns, offsetMetres, scaleMetres);

    /// <summary>From one row of posts to the next, and from one column to the next.</summary>
    public Angle Step => Angle.FromDegrees(360.0 / _columns);

    /// <summary>
    /// The undulation at a place: metres of the geoid above the ellipsoid, -107 to 86 on earth. Allocates nothing.
    /// </summary>
    /// <param name="point">The place.</param>
    /// <exception cref="ArgumentException">It is no place on the earth.</exception>
    public double UndulationMetres(GeographicPoint point)
    {
        if (!point.IsValid)
            throw new ArgumentException($"{point} has no undulation.", nameof(point));
        double row = Math.Max(0, (90 - point.Latitude.Degrees) * (_rows - 1) / 180);
        double east = Math.IEEERemainder(point.Longitude.Degrees, 360);
        double column = (east < 0 ? east + 360 : east) * _columns / 360;
        int north = Math.Min(_rows - 2, (int)row);
        int west = (int)column;
        double v = Math.Min(1, row - north);
        double u = column - west;
        double northern = ((1 - u) * Post(north, west)) + (u * Post(north, west + 1));
        double southern = ((1 - u) * Post(north + 1, west)) + (u * Post(north + 1, west + 1));
        return _offsetMetres + (_scaleMetres * (((1 - v) * northern) + (v * southern)));
    }

    // Beyond the last column is the first.
    private double Post(int row, int column) => _posts[(row * _columns) + (column % _columns)];
}
