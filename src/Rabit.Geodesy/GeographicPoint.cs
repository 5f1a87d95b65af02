namespace Rabit.Geodesy;

/// <summary>A place on the WGS-84 ellipsoid without a height. A plain value.</summary>
/// <param name="latitude">-90 to 90 degrees, north positive.</param>
/// <param name="longitude">East positive.</param>
public readonly struct GeographicPoint(Angle latitude, Angle longitude)
{
    /// <summary>-90 to 90 degrees, north positive.</summary>
    public Angle Latitude { get; } = latitude;

    /// <summary>East positive.</summary>
    public Angle Longitude { get; } = longitude;

    /// <summary>In decimal degrees, seven places: a centimetre.</summary>
    public override string ToString() => PositionText.Format(this, PositionStyle.DecimalDegrees);
}
