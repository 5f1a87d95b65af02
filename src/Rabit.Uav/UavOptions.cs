using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Mavlink;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.GroundControl;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Links;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Preflight;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav;

/// <summary>
/// What a UAV companion computer is made of. Read once, when it is opened. What concerns the whole is set here, the
/// rest in the options of each manager. Where both say something of the same thing (<see cref="SystemId"/>,
/// <see cref="Signing"/>, <see cref="Dialect"/>, <see cref="Mission"/> and the like) it is set in one place or equal in
/// both; two values that differ are refused by name.
/// </summary>
/// <example>
/// An aircraft with an autopilot on a serial line and a ground station on UDP, observed only:
/// <code>
/// var options = new UavOptions
/// {
///     Links = [LinkUrl.Parse("serial:/dev/ttyAMA0:921600"), LinkUrl.Parse("udpout:192.168.1.10:14550")],
///     Autopilot = new AutopilotOptions { HeartbeatTimeout = TimeSpan.FromSeconds(3) },
/// };
/// </code>
/// A mission without a camera, with Image Processing of one's own in the place of ours:
/// <code>
/// options.Without = UavManagers.ImageProcessing;
/// options.OtherManagers = [new MyImageProcessing()];
/// options.MissionControl.RequiresCamera = false;
/// </code>
/// </example>
public sealed class UavOptions
{
    /// <summary>
    /// The links, at least one. A recorded log at another speed than 1 goes with recorded logs of the same speed only.
    /// </summary>
    public IReadOnlyList<LinkUrl> Links { get; set; } = Array.Empty<LinkUrl>();

    /// <summary>Our MAVLink system id, 1 to 255; null for that of the vehicle that carries us.</summary>
    /// <value>The default is null.</value>
    public byte? SystemId { get; set; }

    /// <summary>Our MAVLink component id.</summary>
    /// <value>The default is 191, MAV_COMP_ID_ONBOARD_COMPUTER.</value>
    public byte ComponentId
    {
        get => SetComponentId ?? new AutopilotOptions().ComponentId;
        set => SetComponentId = value;
    }

    /// <summary>Null where it is the default: that of <see cref="Autopilot"/> holds then.</summary>
    internal byte? SetComponentId { get; private set; }

    /// <summary>Whether the autopilot is asked for the message rates that we need. In a replay it is not.</summary>
    /// <value>The default is true.</value>
    public bool RequestsMessageRates { get; set; } = true;

    /// <summary>
    /// Links that are open already, for example to a simulated vehicle; they come before <see cref="Links"/>, and are
    /// closed with the rest.
    /// </summary>
    public IReadOnlyList<IByteLink> OpenLinks { get; set; } = Array.Empty<IByteLink>();

    /// <summary>
    /// Which live links are signed, and how; null for none. They are numbered from 0, <see cref="OpenLinks"/> first.
    /// </summary>
    /// <value>The default is null.</value>
    public SigningOptions? Signing { get; set; }

    /// <summary>The mission; null to observe.</summary>
    /// <value>The default is null.</value>
    public MissionPlan? Mission { get; set; }

    /// <summary>
    /// The ground: the mission keeps its heights above it, and pixels are projected on it. Altitudes above mean sea
    /// level; it must cover the fence and home.
    /// </summary>
    /// <value>The default is null: the ground is taken for level.</value>
    public TerrainGrid? Terrain { get; set; }

    /// <summary>Whether the vehicle may be commanded. Without it a mission is refused.</summary>
    /// <value>The default is false: we observe.</value>
    public bool MayCommand { get; set; }

    /// <summary>The camera; null for none.</summary>
    /// <value>The default is null.</value>
    public IReaderSource<CameraFrame>? Camera { get; set; }

    /// <summary>
    /// Figures of the companion computer, about once a second; null for those of the computer that this runs on, by the
    /// files of Linux, in real time where no log is played.
    /// </summary>
    /// <value>The default is null.</value>
    public IReaderSource<ComputerStatus>? Computer { get; set; }

    /// <summary>
    /// How Communications works: queues, vehicle messages, rates. Its links are <see cref="Links"/> and
    /// <see cref="OpenLinks"/>; subscriptions of both places are added up, and vehicle messages to those of target
    /// reports.
    /// </summary>
    public CommunicationsOptions Communications { get; set; } = new();

    /// <summary>
    /// How Autopilot Interface works: rates, time-outs. Rates are requested where both
    /// <see cref="RequestsMessageRates"/> and this say so; whether it commands is <see cref="MayCommand"/>.
    /// </summary>
    public AutopilotOptions Autopilot { get; set; } = new();

    /// <summary>How Mission Control works: goals, time-outs, whether a mission needs a camera.</summary>
    public MissionControlOptions MissionControl { get; set; } = new();

    /// <summary>
    /// Who may command the mission by MAVLink commands that are addressed to our component, as a ground station sends
    /// them. Not without Communications and Mission Control.
    /// </summary>
    /// <value>The default is null: such commands are not received.</value>
    public GroundCommandOptions? GroundCommands { get; set; }

    /// <summary>How long links that are opened may wait.</summary>
    public LinkOptions LinkOptions { get; set; } = LinkOptions.Default;

    /// <summary>
    /// Which of our managers are left out. Their part is then yours: the check of the wiring names each message without
    /// a publisher and each queue without a receiver or a sender, with those who need it and the manager that was left
    /// out, until managers in <see cref="OtherManagers"/> take that part. Without Communications there are no links,
    /// nor what goes with them.
    /// </summary>
    /// <value>The default is <see cref="UavManagers.None"/>.</value>
    public UavManagers Without { get; set; }

    /// <summary>
    /// How pictures are searched and located: lens, mount, what a target looks like, how good the sensors are.
    /// </summary>
    public ImageProcessingOptions Imaging { get; set; } = new();

    /// <summary>How reports become tracks.</summary>
    public SensorFusionOptions Fusion { get; set; } = new();

    /// <summary>The limits of Health Monitoring.</summary>
    public HealthOptions Health { get; set; } = new();

    /// <summary>What is checked before a mission is flown; a line that fails refuses it (docs/preflight.md).</summary>
    public PreflightOptions Preflight { get; set; } = new();

    /// <summary>
    /// Managers of the user that fly along: they are added after ours, and Health Monitoring watches them.
    /// </summary>
    public IReadOnlyList<RabitManager> OtherManagers { get; set; } = Array.Empty<RabitManager>();

    /// <summary>
    /// The messages that are checked and named on all links. Messages of your own are put together with ours:
    /// <c>MavlinkDialect.Combine("mine", MavlinkDialect.All, MineDialect.Instance)</c>.
    /// </summary>
    /// <value>
    /// The default is <see cref="MavlinkDialect.All"/>. It must have all of <see cref="MavlinkDialect.Common"/>, which
    /// the managers use.
    /// </value>
    public MavlinkDialect Dialect { get; set; } = MavlinkDialect.All;

    /// <summary>Which MAVLink frames go to queues of <see cref="OtherManagers"/>.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<MavlinkSubscription> Subscriptions { get; set; } = Array.Empty<MavlinkSubscription>();

    /// <summary>The time to run in; null for the one that goes with the links.</summary>
    /// <value>The default is null.</value>
    public RabitTime? Time { get; set; }

    /// <summary>
    /// Fixes the order among managers in virtual time, where a log is played at another pace than its own.
    /// </summary>
    /// <value>The default is 0.</value>
    public long Seed { get; set; }

    /// <summary>Everything that <see cref="UavSystem.Open"/> would refuse, without opening anything.</summary>
    /// <returns>A line for each fault; empty where there is none.</returns>
    public IReadOnlyList<string> FindFaults() => UavOptionsCheck.FindFaults(this);

    internal bool IsReplay
        => OpenLinks.Count == 0 && Links.Count > 0 && Links.All(l => l.Kind == LinkKind.RecordedFile);

    /// <summary>How many times faster than real time; 1 for real time itself.</summary>
    internal double Speed => Links.Count == 0 ? 1 : Links.Max(l => l.Speed);

    internal bool Has(UavManagers manager) => (Without & manager) == 0;

    /// <exception cref="ArgumentException">
    /// Options are out of their range or do not go together; the text names all of them.
    /// </exception>
    internal void Validate(string parameter)
    {
        IReadOnlyList<string> faults = FindFaults();
        if (faults.Count > 0)
            throw new ArgumentException(string.Join("; ", faults) + ".", parameter);
    }

    internal UavOptions Copy() => (UavOptions)MemberwiseClone();
}
