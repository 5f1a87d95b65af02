using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// How much higher a vehicle is by its satellite receiver than by its autopilot. The altitude of the autopilot goes by
/// a barometer that drifts by metres during a flight, that of each vehicle in its own way; the receivers of vehicles
/// near each other err alike. So what vehicles compare is their autopilots' altitude, corrected by the mean of this.
/// One thread.
/// </summary>
internal sealed class AltitudeCorrection
{
    private const double MeanSeconds = 15;

    // One report stands for no more: after a gap the mean is not replaced by it.
    private const double MaxStepSeconds = 1;

    // The mean of fewer is not settled.
    private const double MinSeconds = 10;

    // The receiver's altitude is late by some tenths of a second.
    private const double MaxClimbMetresPerSecond = 0.3;

    private const double MaxSigmaMetres = 5;

    // No barometer drifts so far in a flight: one of the two is broken, and which one is not known.
    private const double MaxMetres = 50;

    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(2);

    private TimeSpan? _last;
    private double _seconds;   // of the reports that count
    private double _mean;

    /// <summary>Added to the autopilot's altitude; null until ten seconds of reports are known.</summary>
    public double? Metres => _seconds >= MinSeconds ? _mean : null;

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
        double step = _last is { } last ? Math.Min(MaxStepSeconds, (time - last).ExactSeconds) : MaxStepSeconds;
        _last = time;
        if (!(step > 0))
            return;
        _seconds += step;

        // The mean of all at first, then of the last quarter of a minute.
        _mean += step / Math.Min(MeanSeconds, _seconds) * (metres - _mean);
    }
}
