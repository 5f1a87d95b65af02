using System;
using Rabit.Geodesy;

namespace Rabit.Uav.CameraGeometry;

/// <summary>Focal lengths in pixels from what data sheets and photos say. Pinholes with square pixels.</summary>
/// <example>
/// <code>
/// double pixels = FocalLength.FromSensor(4000, focalLengthMillimetres: 4.5, sensorWidthMillimetres: 6.17);
/// </code>
/// </example>
public static class FocalLength
{
    private const double FilmWidthMillimetres = 36;

    // Which part of the film is meant, its width or its diagonal, and how much of the sensor is used, no one says: two
    // drones are off by 5 and 6 %.
    private const double ErrorOf35Millimetres = 0.04;

    // Rounded to whole millimetres: evenly spread over one.
    private static readonly double RoundingMillimetres = Math.Sqrt(1.0 / 12);

    /// <summary>From the size of the sensor.</summary>
    /// <param name="widthPixels">Columns of the picture that the whole width of the sensor gives.</param>
    /// <param name="focalLengthMillimetres">The true focal length.</param>
    /// <param name="sensorWidthMillimetres">The width of the part of the sensor that the picture is of.</param>
    public static double FromSensor(int widthPixels, double focalLengthMillimetres, double sensorWidthMillimetres)
        => focalLengthMillimetres / sensorWidthMillimetres * widthPixels;

    /// <summary>From the angle between the left and the right border.</summary>
    /// <param name="widthPixels">Columns of the picture.</param>
    /// <param name="horizontal">The horizontal field of view, below 180 degrees.</param>
    public static double FromFieldOfView(int widthPixels, Angle horizontal)
        => widthPixels / 2.0 / Math.Tan(horizontal.Radians / 2);

    /// <summary>From the equivalent for 35 mm film, taken as that of its width of 36 mm.</summary>
    /// <param name="longSidePixels">Pixels of the longer side of the picture.</param>
    /// <param name="equivalentMillimetres">As photos and data sheets say, rounded to whole millimetres.</param>
    public static double From35MillimetreEquivalent(int longSidePixels, double equivalentMillimetres)
        => equivalentMillimetres / FilmWidthMillimetres * longSidePixels;

    /// <summary>
    /// How wrong <see cref="From35MillimetreEquivalent"/> may be, as a part of the focal length (one standard
    /// deviation): rounding, and 4 % since it is not said what is equivalent.
    /// </summary>
    /// <param name="equivalentMillimetres">As for the other.</param>
    public static double ErrorOf35MillimetreEquivalent(double equivalentMillimetres)
    {
        double rounding = RoundingMillimetres / equivalentMillimetres;
        return Math.Sqrt((ErrorOf35Millimetres * ErrorOf35Millimetres) + (rounding * rounding));
    }
}
