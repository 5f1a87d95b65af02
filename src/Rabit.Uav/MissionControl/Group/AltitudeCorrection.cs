using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How much higher a vehicle is by its satellite receiver than by its autopilot. The altitude of the autopilot goes by a
/// barometer that drifts by metres during a flight, that of each vehicle in its own way; the receivers of vehicles near
/// each other err alike. So what vehicles compare is their autopilots' altitude, corrected by the mean of this. One thread.
/// </summary>
internal sealed class AltitudeCorrection
{
    private const double MeanSeconds = 30;

    // The receiver's altitude is late by some tenths of a second.
    private const double MaxClimbMetresPerSecond = 0.5;

    private const double MaxSigmaMetres = 5;

    // No barometer drifts so far in a flight: one of the two is broken, and which one is not known.
    private const double MaxMetres = 50;

    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(2);

    private TimeSpan? _first;
    private TimeSpan? _last;

    /// <summary>Added to the autopilot's altitude; 0 while nothing is known.</summary>
    public double Metres { get; private set; }

    /// <summary>Takes what the receiver reported, where that is new and can be used.</summary>
    /// <param name="vehicle">Of the vehicle itself.</param>
    /// <param name="now">The time.</param>
    public void Update(in VehicleState vehicle, TimeSpan now)
    {
        if (vehicle.GnssAltitudeAmslMetres is not { } altitude || vehicle.GpsTime is not { } time || time == _last)
            return;
        double metres = altitude - vehicle.Position.AltitudeAmslMetres;
        bool isUsable = now - time <= MaxAge && now - vehicle.PositionTime <= MaxAge && Math.Abs(metres) <= MaxMetres
            && !(vehicle.GnssAltitudeSigmaMetres > MaxSigmaMetres)
            && Math.Abs(vehicle.VelocityNed.Down) <= MaxClimbMetresPerSecond;
        if (!isUsable)
            return;
        _first ??= time;
        double seconds = Math.Max(0, (time - (_last ?? time)).TotalSeconds);

        // The mean of all at first, then of the last half minute.
        double over = Math.Min(MeanSeconds, (time - _first.Value).TotalSeconds);
        double weight = _last is null ? 1 : Math.Min(1, seconds / over);
        Metres += weight * (metres - Metres);
        _last = time;
    }
}
