using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Whether the position is valid: it stays so for 5 s after the GPS is lost, by inertial estimates (recorded: ALTCTL
/// 5 to 6 s after).
/// </summary>
internal sealed class Px4PositionCheck(Px4Events events)
{
    public const int MinSatellites = 4;

    private static readonly TimeSpan DeadReckoning = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan FusionStopped = TimeSpan.FromSeconds(10);

    private TimeSpan? _lastFix;
    private bool _hasReported;

    public bool Step(bool hasGps, TimeSpan time)
    {
        if (hasGps)
        {
            _lastFix = time;
            _hasReported = false;
        }

        if (_lastFix is not { } last)
            return false;
        if (!_hasReported && time - last > FusionStopped)
        {
            _hasReported = true;
            events.Send(Px4Event.GnssStopped, 0x63);
            events.Say(MavSeverity.Error, "GNSS data fusion stopped");
        }

        return time - last <= DeadReckoning;
    }
}
