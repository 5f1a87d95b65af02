using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// The origin of ArduPilot's local frame. ArduPilot takes a degree of latitude for 111 318.8 m and one of longitude for
/// that times the cosine of the mean latitude (Location::get_distance_NE), which is up to 0.7 % more than WGS84 has:
/// 7 m at a kilometre. A plain value.
/// </summary>
internal readonly struct ArdupilotOrigin(double latitudeDegE7, double longitudeDegE7, double altitudeAmslMetres)
{
    // LOCATION_SCALING_FACTOR: metres to 1e-7 degrees.
    private const double MetresPerDegE7 = 0.011131884502145034;
    private const double RadiansPerDegE7 = Angle.RadiansPerDegree * 1e-7;
    private const double TurnDegE7 = 3.6e9;

    private readonly double _latitude = latitudeDegE7;
    private readonly double _longitude = longitudeDegE7;
    private readonly double _altitude = altitudeAmslMetres;

    /// <summary>As the autopilot reports it.</summary>
    public static ArdupilotOrigin Of(in GpsGlobalOrigin message)
        => new(message.Latitude, message.Longitude, message.Altitude / 1000.0);

    /// <summary>As a target of ours shows it that the autopilot reports.</summary>
    public static ArdupilotOrigin Of(in ReportedTarget ours, in PositionTargetLocalNed report)
    {
        double latitude = ours.LatitudeDegE7 - (report.X / MetresPerDegE7);
        double scale = MetresPerDegE7 * Trig.Cos((latitude + ours.LatitudeDegE7) / 2 * RadiansPerDegE7);
        return new ArdupilotOrigin(
            latitude, ours.LongitudeDegE7 - (report.Y / scale), ours.AltitudeAmslMetres + report.Z);
    }

    /// <summary>How far a target of ours is from a reported one, metres.</summary>
    public double DistanceOf(in ReportedTarget ours, in PositionTargetLocalNed report)
    {
        double north = (ours.LatitudeDegE7 - _latitude) * MetresPerDegE7;
        double scale = MetresPerDegE7 * Trig.Cos((ours.LatitudeDegE7 + _latitude) / 2 * RadiansPerDegE7);
        double east = Math.IEEERemainder(ours.LongitudeDegE7 - _longitude, TurnDegE7) * scale;
        double down = _altitude - ours.AltitudeAmslMetres;
        (double n, double e, double d) = (north - report.X, east - report.Y, down - report.Z);
        return Math.Sqrt((n * n) + (e * e) + (d * d));
    }
}
