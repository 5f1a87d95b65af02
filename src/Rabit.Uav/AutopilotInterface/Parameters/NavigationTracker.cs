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

    private NavigationStatus _status = new() { HorizontalDilution = double.NaN };

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
                _status.EstimatorTime = frame.Time;
                _status.EstimatorFault = FindFault((int)report.Flags, ArdupilotGlitch, ArdupilotUninitialized);
                return true;
            case EstimatorStatus.MavlinkId when mavlink.TryDecode(out EstimatorStatus status):
                _status.EstimatorTime = frame.Time;
                _status.EstimatorFault = FindFault((int)status.Flags, Px4Glitch, Px4AccelerationError);
                return true;
            case HomePosition.MavlinkId when mavlink.TryDecode(out HomePosition home):
                return TakeHome(home, frame.Time);
            default:
                return false;
        }
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
