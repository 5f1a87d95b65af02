using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The mean wind in flight, from what the autopilot reports. No I/O; one thread.
/// </summary>
internal sealed class WindEstimate
{
    // Gusts last for seconds; a rise of the wind has to be known before the vehicle is much farther away.
    private const double MeanSeconds = 15;

    // Reported once a second.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private TimeSpan? _time;

    /// <summary>Whether the autopilot has reported it of late.</summary>
    public bool IsMeasured { get; private set; }

    /// <summary>Velocity of the air over ground, m/s; zero while it is not measured.</summary>
    public PlanePoint Velocity { get; private set; }

    /// <summary>As it was reported last, with gusts.</summary>
    public PlanePoint Latest { get; private set; }

    public void Update(in VehicleState vehicle, TimeSpan now, bool isFlying)
    {
        // On the ground autopilots report the wind of the flight before, or none.
        if (!isFlying)
            _time = null;
        bool isRecent = isFlying && vehicle.WindTime is { } reported && now - reported <= MaxAge
            && !double.IsNaN(vehicle.WindMetresPerSecond);
        if (!isRecent)
        {
            (IsMeasured, Velocity, Latest) = (false, default, default);
            return;
        }

        TimeSpan time = vehicle.WindTime!.Value;
        if (IsMeasured && time == _time)
            return;
        var wind = new PlanePoint(vehicle.WindVelocityNed.North, vehicle.WindVelocityNed.East);
        double seconds = IsMeasured && _time is { } last ? (time - last).ExactSeconds : double.PositiveInfinity;
        double part = double.IsInfinity(seconds) ? 1 : seconds / (MeanSeconds + seconds);
        Velocity += part * (wind - Velocity);
        (IsMeasured, _time, Latest) = (true, time, wind);
    }
}
