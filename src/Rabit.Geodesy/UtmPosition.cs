using System;

namespace Rabit.Geodesy;

/// <summary>A place in the Universal Transverse Mercator grid, 80 degrees south to 84 north. A plain value.</summary>
/// <param name="Zone">1 to 60.</param>
/// <param name="IsNorth">
/// Whether northings are from the equator, as in the northern half, and not from 10 000 km south of it.
/// </param>
/// <param name="EastingMetres">500 km on the central meridian.</param>
/// <param name="NorthingMetres">Along the central meridian, from the equator or from 10 000 km south of it.</param>
/// <example>
/// <code>
/// UtmPosition utm = UtmPosition.From(new GeographicPoint(Angle.FromDegrees(47.4), Angle.FromDegrees(8.5)));
/// Console.WriteLine(utm);                              // zone, half, easting, northing
/// GeographicPoint back = utm.ToGeographic();
/// </code>
/// </example>
public readonly record struct UtmPosition(int Zone, bool IsNorth, double EastingMetres, double NorthingMetres)
{
    private const double Scale = 0.9996;
    private const double FalseEasting = 500_000;
    private const double FalseNorthing = 10_000_000;

    /// <summary>In the zone that the place belongs to, those of Norway and Svalbard too.</summary>
    /// <param name="point">80 degrees south to 84 north.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// It is nearer to a pole, where UTM ends, or not a number.
    /// </exception>
    public static UtmPosition From(GeographicPoint point) => From(point, out _, out _);

    /// <summary>In the zone that the place belongs to, with what the grid does there.</summary>
    /// <param name="point">80 degrees south to 84 north.</param>
    /// <param name="convergence">Grid north seen from true north, clockwise.</param>
    /// <param name="scale">How much longer a metre is in the grid.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// It is nearer to a pole, where UTM ends, or not a number.
    /// </exception>
    public static UtmPosition From(GeographicPoint point, out Angle convergence, out double scale)
    {
        double latitude = point.Latitude.Degrees;
        if (!(latitude >= -80 && latitude <= 84) || !point.Longitude.IsFinite)
            throw new ArgumentOutOfRangeException(
                nameof(point), $"UTM reaches from 80 degrees south to 84 north; {point} is outside.");
        int zone = UtmZones.Of(latitude, point.Longitude.Wrapped().Degrees);
        double fromMeridian = (point.Longitude - UtmZones.CentralMeridian(zone)).Wrapped().Radians;
        TransverseMercator.Project(
            point.Latitude.Radians, fromMeridian, out double x, out double y, out double turn, out double unit);
        convergence = Angle.FromRadians(turn);
        scale = unit * Scale;
        bool isNorth = point.Latitude.Radians >= 0;
        return new UtmPosition(zone, isNorth, FalseEasting + (Scale * x), (isNorth ? 0 : FalseNorthing) + (Scale * y));
    }

    /// <summary>The place on the ellipsoid.</summary>
    /// <exception cref="InvalidOperationException">
    /// There is no such zone, or the coordinates are far outside.
    /// </exception>
    public GeographicPoint ToGeographic()
    {
        if (Zone is < 1 or > 60
            || !(EastingMetres > -1e6 && EastingMetres < 2e6 && NorthingMetres > -1e6 && NorthingMetres < 1.1e7))
            throw new InvalidOperationException($"{this} is no place of UTM.");
        TransverseMercator.Unproject(
            (EastingMetres - FalseEasting) / Scale, (NorthingMetres - (IsNorth ? 0 : FalseNorthing)) / Scale,
            out double latitude, out double fromMeridian);
        return new GeographicPoint(
            Angle.FromRadians(latitude), (UtmZones.CentralMeridian(Zone) + Angle.FromRadians(fromMeridian)).Wrapped());
    }

    /// <summary>As 32 N 465000.00 5250000.00: zone, half, easting, northing.</summary>
    public override string ToString()
        => FormattableString.Invariant($"{Zone} {(IsNorth ? 'N' : 'S')} {EastingMetres:0.00} {NorthingMetres:0.00}");
}
