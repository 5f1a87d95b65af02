using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>How Autopilot Interface works. Read once, when the manager is made.</summary>
public sealed class AutopilotOptions
{
    // An autopilot's loop runs at a few hundred hertz at most; more than this is a mistake.
    private const double MaxRate = 1000;

    /// <summary>
    /// The system id of our vehicle. Where it is set, autopilots of other systems are never taken for ours; where it is
    /// null, the first autopilot that is received is ours, and we take its system id.
    /// </summary>
    /// <value>The default is null.</value>
    public byte? SystemId { get; set; }

    /// <summary>Our own component id.</summary>
    /// <value>The default is 191, MAV_COMP_ID_ONBOARD_COMPUTER (MAVLink guide, "MAVLink identifiers").</value>
    public byte ComponentId
    {
        get => SetComponentId ?? (byte)MavComponent.OnboardComputer;
        set => SetComponentId = value;
    }

    /// <summary>Null where it is the default: another place may say otherwise then.</summary>
    internal byte? SetComponentId { get; private set; }

    /// <summary>After what time without a heartbeat the autopilot is lost.</summary>
    /// <value>The default is 5 s: four to five missed at 1 Hz (MAVLink guide, "Heartbeat/Connection Protocol").</value>
    public TimeSpan HeartbeatTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Whether the autopilot is asked for <see cref="RequestedRates"/>, for its time and for the version of its
    /// firmware: not in a replay, which answers nothing.
    /// </summary>
    /// <value>The default is true.</value>
    public bool RequestsRates { get; set; } = true;

    /// <summary>
    /// Whether vehicle commands are carried out. Where it is false, every one is answered
    /// <see cref="VehicleCommandOutcome.NotInCommand"/>.
    /// </summary>
    /// <value>The default is false: we observe.</value>
    public bool MayCommand { get; set; }

    /// <summary>
    /// Whether a fixed wing is commanded, too, within limits (docs/managers/autopilot-interface.md, "Fixed wings"): the
    /// pilot takes off, gives it over in GUIDED (ArduPilot) or AUTO.LOITER (PX4), and lands. Each place is one
    /// DO_REPOSITION, holding is a circle, and on PX4 a pilot's Hold cannot be seen: only another mode takes over.
    /// </summary>
    /// <value>The default is false: every command to a fixed wing is refused.</value>
    public bool MayCommandFixedWing { get; set; }

    /// <summary>The messages that may be asked for by <see cref="RequestedRates"/>.</summary>
    /// <value>The default is <see cref="MavlinkDialect.All"/>.</value>
    public MavlinkDialect Dialect { get; set; } = MavlinkDialect.All;

    /// <summary>
    /// What the autopilot is asked to send, and how often, when it is found, found again or has rebooted. ArduPilot is
    /// not asked for WIND_COV and ESTIMATOR_STATUS, nor PX4 for WIND and EKF_STATUS_REPORT: each has the others only.
    /// </summary>
    /// <value>
    /// The default is what <see cref="Messages.VehicleState"/> and <see cref="Messages.NavigationStatus"/> are made of,
    /// but for home; attitude at 25 Hz, since what a camera sees is located by it, position at 10 Hz, the target at
    /// 13 Hz, the rest slower. What ArduPilot or PX4 alone knows is not asked of the other.
    /// </value>
    public IReadOnlyList<RequestedRate> RequestedRates { get; set; } =
    [
        new(Attitude.MavlinkId, 25),
        new(GlobalPositionInt.MavlinkId, 10),
        new(SysStatus.MavlinkId, 1),
        new(BatteryStatus.MavlinkId, 1),
        new(GpsRawInt.MavlinkId, 2),
        new(SystemTime.MavlinkId, 1),
        new(ExtendedSysState.MavlinkId, 2),
        new(Wind.MavlinkId, 1),
        new(WindCov.MavlinkId, 1),
        new(EkfStatusReport.MavlinkId, 1),
        new(EstimatorStatus.MavlinkId, 1),
        new(ScaledPressure.MavlinkId, 1),

        // No usual rate of set-points is a multiple of it, so that of two streams not always the same one is reported.
        new(PositionTargetLocalNed.MavlinkId, 13),
        new(PositionTargetGlobalInt.MavlinkId, 4),
        new(GpsGlobalOrigin.MavlinkId, 0.2),
    ];

    /// <summary>
    /// Whether the autopilot's fence is read, in flight too, and posted when others have changed it
    /// (<see cref="AutopilotFence"/>).
    /// </summary>
    /// <value>The default is false.</value>
    public bool WatchesFence { get; set; }

    /// <summary>
    /// Whether <see cref="LandingTargetObservation"/> is sent on as LANDING_TARGET, also where we may not command: the
    /// autopilot uses it only where its own precision landing is on. ArduPilot is sent the direction and distance in
    /// the frame of the body; PX4 the place in its local frame, which needs LOCAL_POSITION_NED.
    /// </summary>
    /// <value>
    /// The default is false; <see cref="UavSystem"/> sets it where
    /// <see cref="ImageProcessing.ImageProcessingOptions.LandingMarker"/> is declared, but not in a replay.
    /// </value>
    public bool SendsLandingTarget { get; set; }

    /// <summary>
    /// The texts of the autopilot's events (PX4): with them events are status texts, and reasons of refusals. Without,
    /// each is a line of the log with its number, level and arguments.
    /// </summary>
    /// <value>The default is null.</value>
    public MavlinkEventCatalog? EventCatalog { get; set; }

    /// <summary>
    /// Whether the texts are fetched from the autopilot by MAVLink FTP where <see cref="EventCatalog"/> is null. Files
    /// that are compressed, as those of PX4's own builds are, cannot be used.
    /// </summary>
    /// <value>The default is false.</value>
    public bool FetchesEventCatalog { get; set; }

    /// <summary>Which of the autopilot's parameters are read and written before a flight.</summary>
    public AutopilotSetupOptions Setup { get; set; } = new();

    /// <summary>Checks, and takes a copy that later changes do not reach.</summary>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal AutopilotOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Autopilot Interface: " + string.Join("; ", faults) + ".", parameter);
        var copy = (AutopilotOptions)MemberwiseClone();
        copy.RequestedRates = RequestedRates.ToArray();
        copy.Setup = Setup.Copy();
        return copy;
    }

    internal AutopilotOptions Copy() => (AutopilotOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (SystemId == 0)
            yield return $"{nameof(SystemId)} is 0, which means every system; it must be 1 to 255, or null for that of "
                + "the autopilot";
        if (ComponentId == 0)
            yield return $"{nameof(ComponentId)} is 0, which means every component; it must be 1 to 255";
        if (HeartbeatTimeout < TimeSpan.FromSeconds(1))
            yield return $"{nameof(HeartbeatTimeout)} is {HeartbeatTimeout}; heartbeats come once a second, so it must "
                + "be at least that";
        foreach (string fault in Setup?.FindFaults() ?? [$"{nameof(Setup)} is null"])
            yield return fault;
        if (Dialect is null)
            yield return $"{nameof(Dialect)} is null";
        if (RequestedRates is null)
            yield return $"{nameof(RequestedRates)} is null; it may be empty";
        foreach (RequestedRate rate in RequestedRates ?? [])
        {
            if (Dialect?.TryGetMessage(rate.MessageId, out _) == false)
                yield return $"{nameof(RequestedRates)} has message {rate.MessageId}, which dialect '{Dialect.Name}' "
                    + "does not have";
            if (!(rate.Hertz > 0 && rate.Hertz <= MaxRate))
            {
                yield return FormattableString.Invariant(
                    $"{nameof(RequestedRates)} has message {rate.MessageId} at {rate.Hertz} Hz; it must be above 0 and at most {MaxRate}");
            }
        }

        foreach (int twice
            in (RequestedRates ?? []).GroupBy(r => r.MessageId).Where(g => g.Count() > 1).Select(g => g.Key))
            yield return $"{nameof(RequestedRates)} has message {twice} more than once";
    }
}
