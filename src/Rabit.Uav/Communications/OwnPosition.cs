using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>When our position is sent to ground and others, and in what form. Time comes in, messages go out.</summary>
internal sealed class OwnPosition(double hertz)
{
    private static readonly TimeSpan FreshFor = TimeSpan.FromSeconds(3);
    private const double DegE7PerDegree = 1e7;
    private const double CentidegreesPerDegree = 100;
    private const ushort UnknownHeading = ushort.MaxValue;
    private const double FullTurn = 36_000;

    private readonly TimeSpan _period = hertz > 0 ? TimeSpan.OfSeconds(1 / hertz) : TimeSpan.MaxValue;
    private TimeSpan _due;

    /// <summary>How often it is sent; the longest time where it is not.</summary>
    public TimeSpan Period => _period;

    /// <summary>Gives what to send now, if anything: never a position that is old.</summary>
    public bool TryNext(in VehicleState vehicle, TimeSpan now, out GlobalPositionInt message)
    {
        message = default;
        if (_period == TimeSpan.MaxValue || now < _due)
            return false;
        if (vehicle.PositionTime is not { } time || now - time >= FreshFor)
            return false;

        // On a grid, so that late wake-ups do not slow it down.
        _due += _period;
        if (_due <= now)
            _due = now + _period;
        message = ToMessage(vehicle, time);
        return true;
    }

    // Time since boot is ours, and that of the position: the sender is we.
    private static GlobalPositionInt ToMessage(in VehicleState vehicle, TimeSpan time) => new()
    {
        TimeBootMs = unchecked((uint)(time.Ticks / TimeSpan.TicksPerMillisecond)),
        Lat = (int)Math.Round(vehicle.Position.Latitude.Degrees * DegE7PerDegree),
        Lon = (int)Math.Round(vehicle.Position.Longitude.Degrees * DegE7PerDegree),
        Alt = Millimetres(vehicle.Position.AltitudeAmslMetres),
        RelativeAlt = Millimetres(vehicle.HeightAboveHomeMetres),
        Vx = CentimetresPerSecond(vehicle.VelocityNed.North),
        Vy = CentimetresPerSecond(vehicle.VelocityNed.East),
        Vz = CentimetresPerSecond(vehicle.VelocityNed.Down),
        Hdg = vehicle.AttitudeTime is null ? UnknownHeading : Heading(vehicle.Attitude.Yaw),
    };

    private static int Millimetres(double metres)
        => (int)Math.Round(Math.Max(int.MinValue, Math.Min(int.MaxValue, metres * 1000)));

    private static short CentimetresPerSecond(double metresPerSecond)
        => (short)Math.Round(Math.Max(short.MinValue, Math.Min(short.MaxValue, metresPerSecond * 100)));

    // 0 to 35999 centidegrees.
    private static ushort Heading(Angle yaw)
    {
        double heading = Math.Round(yaw.Degrees * CentidegreesPerDegree) % FullTurn;
        return (ushort)(heading < 0 ? heading + FullTurn : heading);
    }
}
