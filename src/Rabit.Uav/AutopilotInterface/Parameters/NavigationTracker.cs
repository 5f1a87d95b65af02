using System;
using System.Collections.Generic;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Keeps what the autopilot reports of its satellites, estimator and home. One thread.</summary>
internal sealed class NavigationTracker
{
    // The bits of EKF_STATUS_FLAGS and ESTIMATOR_STATUS_FLAGS that must be set to fly by position; the same in both.
    private static readonly (int Bit, string Name)[] Needed =
    [
        (1, "attitude"), (2, "horizontal velocity"), (4, "vertical velocity"), (16, "horizontal position"),
        (32, "height"),
    ];

    // Those that must not be: constant position mode, and satellites that jump or contradict the rest.
    private const int ConstantPosition = 128;
    private const int ArdupilotGlitch = 32768;
    private const int ArdupilotUninitialized = 1024;
    private const int Px4Glitch = 1024;
    private const int Px4AccelerationError = 2048;

    // ISO 2533: pressure at the level 0, and the exponent and height of the formula below 11 km.
    private const double StandardHectopascals = 1013.25;
    private const double PressureExponent = 0.190263;
    private const double PressureScaleMetres = 44330.77;

    // The highest and the lowest that were ever measured outdoors, with a margin to flying 5 km above the sea.
    private const double MinHectopascals = 400;
    private const double MaxHectopascals = 1100;

    private NavigationStatus _status = new()
    {
        HorizontalDilution = double.NaN,
        EstimatorRatio = double.NaN,
        PressureHeightMetres = double.NaN,
    };

    // What flags mean is made into a text once, not with each report.
    private int _flags = -1;

    public NavigationStatus Status => _status;

    /// <returns>Whether the frame was about it.</returns>
    public bool Update(in LinkFrame frame)
    {
        MavlinkFrame mavlink = frame.Frame;
        switch (mavlink.MessageId)
        {
            case GpsRawInt.MavlinkId when mavlink.TryDecode(out GpsRawInt gps):
                _status.DilutionTime = frame.Time;
                _status.HorizontalDilution = gps.Eph == ushort.MaxValue ? double.NaN : gps.Eph / 100.0;
                return true;
            case EkfStatusReport.MavlinkId when mavlink.TryDecode(out EkfStatusReport report):
                TakeEstimator(frame.Time, (int)report.Flags, ArdupilotGlitch, ArdupilotUninitialized);
                _status.EstimatorRatio = Greatest(
                    report.VelocityVariance, report.PosHorizVariance, report.PosVertVariance);
                return true;
            case EstimatorStatus.MavlinkId when mavlink.TryDecode(out EstimatorStatus status):
                TakeEstimator(frame.Time, (int)status.Flags, Px4Glitch, Px4AccelerationError);
                _status.EstimatorRatio = Greatest(status.VelRatio, status.PosHorizRatio, status.PosVertRatio);
                return true;
            case ScaledPressure.MavlinkId when mavlink.TryDecode(out ScaledPressure pressure):
                return TakePressure(pressure.PressAbs, frame.Time);
            case HomePosition.MavlinkId when mavlink.TryDecode(out HomePosition home):
                return TakeHome(home, frame.Time);
            default:
                return false;
        }
    }

    private void TakeEstimator(TimeSpan time, int flags, int glitch, int error)
    {
        _status.EstimatorTime = time;
        if (flags != _flags)
            _status.EstimatorFault = FindFault(flags, glitch, error);
        _flags = flags;
    }

    // NaN is what an estimator reports of what it does not use.
    private static double Greatest(float velocity, float position, float height)
    {
        double greatest = double.NaN;
        greatest = velocity >= 0 ? velocity : greatest;
        greatest = position >= 0 && !(greatest >= position) ? position : greatest;
        return height >= 0 && !(greatest >= height) ? height : greatest;
    }

    private bool TakePressure(double hectopascals, TimeSpan time)
    {
        if (!(hectopascals >= MinHectopascals && hectopascals <= MaxHectopascals))
            return false;
        _status.PressureTime = time;
        _status.PressureHeightMetres = PressureScaleMetres
            * (1 - Math.Pow(hectopascals / StandardHectopascals, PressureExponent));
        return true;
    }

    private static string? FindFault(int flags, int glitch, int error)
    {
        if ((flags & (ConstantPosition | glitch | error)) == 0 && Array.TrueForAll(Needed, n => (flags & n.Bit) != 0))
            return null;
        var faults = new List<string>();
        foreach ((int bit, string name) in Needed)
        {
            if ((flags & bit) == 0)
                faults.Add("no " + name);
        }

        if ((flags & ConstantPosition) != 0)
            faults.Add("it assumes that the vehicle does not move");
        if ((flags & glitch) != 0)
            faults.Add("satellites contradict it");
        if ((flags & error) != 0)
            faults.Add("it has not started, or accelerometers contradict it");
        return string.Join(", ", faults);
    }

    private bool TakeHome(in HomePosition home, TimeSpan time)
    {
        GeodeticPosition position = GeodeticPosition.FromDegrees(
            home.Latitude / 1e7, home.Longitude / 1e7, home.Altitude / 1000.0);
        if (!position.IsValid || (home.Latitude == 0 && home.Longitude == 0))
            return false;
        _status.HomeTime = time;
        _status.Home = position;
        return true;
    }
}
