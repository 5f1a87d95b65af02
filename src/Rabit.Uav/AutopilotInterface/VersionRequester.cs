using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Asks the autopilot for AUTOPILOT_VERSION when it is found and when it has started again: which firmware it has is
/// needed to understand a log. A state machine: time and reports come in, requests go out.
/// </summary>
/// <remarks>
/// REQUEST_AUTOPILOT_CAPABILITIES comes first, since acknowledgements of REQUEST_MESSAGE are those of requests for
/// HEARTBEAT while we command; newer autopilots know the latter only.
/// </remarks>
internal sealed class VersionRequester
{
    private const int MaxRequests = 6;

    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    private int _requests = MaxRequests;
    private TimeSpan _due;
    private uint? _known;

    /// <summary>The autopilot was found, or has started again.</summary>
    public void Start(TimeSpan now) => (_requests, _due) = (0, now);

    /// <summary>Takes its answer, or what others asked it for.</summary>
    /// <returns>The version as text, for people; null where it was known.</returns>
    public string? Take(in AutopilotVersion version)
    {
        _requests = MaxRequests;
        if (_known == version.FlightSwVersion)
            return null;
        _known = version.FlightSwVersion;
        return TextOf(version.FlightSwVersion);
    }

    /// <summary>The request that is due.</summary>
    public bool TryNext(TimeSpan now, MavlinkSender sender, MavlinkAddress target, out MavlinkFrame frame)
    {
        frame = default;
        if (_requests >= MaxRequests || now < _due)
            return false;
        bool asksForCapabilities = _requests++ % 2 == 0;
        _due = now + Interval;
        frame = sender.Create(new CommandLong
        {
            TargetSystem = target.SystemId,
            TargetComponent = target.ComponentId,
            Command = asksForCapabilities ? MavCmd.RequestAutopilotCapabilities : MavCmd.RequestMessage,
            Param1 = asksForCapabilities ? 1 : AutopilotVersion.MavlinkId,
        });
        return true;
    }

    private static string TextOf(uint version)
    {
        string kind = (byte)version switch
        {
            (byte)FirmwareVersionType.Official => string.Empty,
            >= (byte)FirmwareVersionType.Rc => " release candidate",
            >= (byte)FirmwareVersionType.Beta => " beta",
            >= (byte)FirmwareVersionType.Alpha => " alpha",
            _ => " development",
        };
        return FormattableString.Invariant(
            $"{version >> 24}.{(version >> 16) & 0xFF}.{(version >> 8) & 0xFF}{kind}");
    }
}
