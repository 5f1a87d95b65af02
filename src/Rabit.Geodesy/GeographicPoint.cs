namespace Rabit.Geodesy;

/// <summary>
/// A place on the WGS-84 ellipsoid without a height. A plain value; it takes any angles, and says whether they are a
/// place: <see cref="IsValid"/>. What computes with it or writes it refuses what is none.
/// </summary>
/// <param name="Latitude">-90 to 90 degrees, north positive.</param>
/// <param name="Longitude">East positive; a full turn more or less is the same place.</param>
/// <example>
/// <code>
/// var zurich = new GeographicPoint(Angle.FromDegrees(47.3769), Angle.FromDegrees(8.5417));
/// Console.WriteLine(PositionText.Format(zurich, PositionStyle.Mgrs));
/// </code>
/// </example>
public readonly record struct GeographicPoint(Angle Latitude, Angle Longitude)
{
    // A pole is still one, whatever rounding says.
    private const double MaxLatitudeDegrees = 90 + 1e-9;

    /// <summary>Whether it is on the earth: the latitude from pole to pole, the longitude a number.</summary>
    public bool IsValid
        => Latitude.Degrees >= -MaxLatitudeDegrees && Latitude.Degrees <= MaxLatitudeDegrees && Longitude.IsFinite;

    /// <summary>
    /// In decimal degrees, seven places: a centimetre; what is no place on the earth is written as that, with its
    /// angles.
    /// </summary>
    public override string ToString()
        => IsValid ? PositionText.Format(this, PositionStyle.DecimalDegrees) : $"no place ({Latitude}, {Longitude})";
}
