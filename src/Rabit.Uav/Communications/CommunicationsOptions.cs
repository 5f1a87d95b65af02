using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;
using Rabit.Links;

namespace Rabit.Uav.Communications;

/// <summary>What Communications is made of. Read once, when the manager is made.</summary>
public sealed class CommunicationsOptions
{
    // More than an autopilot itself measures it.
    private const double MaxPositionRate = 50;

    /// <summary>Live links, open. They stay the caller's to dispose, after the run.</summary>
    public IReadOnlyList<IByteLink> Links { get; set; } = Array.Empty<IByteLink>();

    /// <summary>
    /// What is set for single links, by their numbers; a link without an entry is as
    /// <see cref="Rabit.Links.LinkSettings.None"/>.
    /// </summary>
    /// <value>The default is none. <see cref="UavSystem"/> adds what the URLs of its links say.</value>
    public IReadOnlyDictionary<int, LinkSettings> LinkSettings { get; set; } = new Dictionary<int, LinkSettings>();

    /// <summary>
    /// Recorded logs that are played, open. They are numbered after the live links, and stay the caller's to dispose.
    /// </summary>
    public IReadOnlyList<RecordedFile> RecordedFiles { get; set; } = Array.Empty<RecordedFile>();

    /// <summary>How many frames of one link may wait to be handled.</summary>
    /// <value>The default is 256: a second of the busiest autopilot stream fits twice over.</value>
    public int FramesWaitingIn { get; set; } = 256;

    /// <summary>How many frames may wait to be written to one link; the oldest makes room.</summary>
    /// <value>The default is 256.</value>
    public int FramesWaitingOut { get; set; } = 256;

    /// <summary>After what time without a frame a link is called silent.</summary>
    /// <value>The default is 5 s: four to five heartbeats (MAVLink guide, "Heartbeat/Connection Protocol").</value>
    public TimeSpan SilentAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Whether the end of all links stops the run: for a replay, which then is over.</summary>
    /// <value>The default is false.</value>
    public bool StopsWhenAllLinksEnd { get; set; }

    /// <summary>
    /// How often our own position goes out to all live links, from our own address, while it is known; 0 for never.
    /// </summary>
    /// <value>
    /// The default is 1 Hz: what others keep clear by (ArduPilot forgets a vehicle after 3 s, AP_Follow).
    /// </value>
    public double PositionRateHz { get; set; } = 1;

    /// <summary>
    /// Whether the confirmed targets are sent to all live links: each in its turn as CAMERA_TRACKING_GEO_STATUS, one a
    /// second, and each once as STATUSTEXT with its coordinates.
    /// </summary>
    /// <value>
    /// The default is null: where Sensor Fusion is part of a <see cref="UavSystem"/>. With true some manager must
    /// publish <see cref="Messages.MessageNames.Tracks"/>.
    /// </value>
    public bool? SendsTargets { get; set; }

    /// <summary>
    /// Whether the targets are also sent as ADSB_VEHICLE, which ground stations draw on their map, to links with a
    /// ground station and no autopilot: an autopilot would evade them. They are no traffic: only where
    /// all who see that map know it.
    /// </summary>
    /// <value>The default is false. True sends nothing where the targets are not sent.</value>
    public bool SendsTargetsAsTraffic { get; set; }

    /// <summary>What types of messages are exchanged with other vehicles, each by a codec of its own.</summary>
    /// <value>The default is none: then nothing of it is sent, relayed or read.</value>
    public IReadOnlyList<VehicleMessageRoute> VehicleMessageRoutes { get; set; } = Array.Empty<VehicleMessageRoute>();

    /// <summary>
    /// In which groups this vehicle is, and whether it relays: docs/managers/communications.md, "Vehicle messages".
    /// </summary>
    public VehicleExchangeOptions VehicleExchange { get; set; } = new();

    /// <summary>
    /// How many bytes of vehicle messages one link carries per second, frames and all; what is above waits, until its
    /// lifetime ends.
    /// </summary>
    /// <value>
    /// The default is 1000: eight target reports; a radio with error correction carries 3600 (SiK at 57600 baud).
    /// </value>
    public int VehicleMessageBytesPerSecond { get; set; } = 1000;

    /// <summary>
    /// Whether frames whose message is in no dialect of ours, so that their address cannot be read, are forwarded to
    /// all links.
    /// </summary>
    /// <value>The default is true: the others may know them (MAVLink guide, "Routing").</value>
    public bool ForwardsUnknownMessages { get; set; } = true;

    /// <summary>
    /// Whether RADIO_STATUS of a radio is forwarded to links with a ground station and no vehicle, which shows it. An
    /// autopilot would take it for the state of its own radio.
    /// </summary>
    /// <value>The default is false.</value>
    public bool ForwardsRadioStatus { get; set; }

    /// <summary>How much may be sent over live links, by their number; the others have no budget.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyDictionary<int, SendBudget> SendBudgets { get; set; } = new Dictionary<int, SendBudget>();

    /// <summary>
    /// Where all that comes in and goes out over the live links is recorded; null for nowhere. See
    /// docs/managers/communications.md, "Recording".
    /// </summary>
    /// <value>The default is null.</value>
    public RecordingOptions? Recording { get; set; }

    /// <summary>Which live links are signed, and how; null for none.</summary>
    /// <value>The default is null.</value>
    public SigningOptions? Signing { get; set; }

    /// <summary>
    /// The messages that are checked and named on all links. Messages of your own are put together with ours:
    /// <c>MavlinkDialect.Combine("mine", MavlinkDialect.All, MineDialect.Instance)</c>.
    /// </summary>
    /// <value>
    /// The default is <see cref="MavlinkDialect.All"/>. It must have all of <see cref="MavlinkDialect.Common"/>, which
    /// the managers use.
    /// </value>
    public MavlinkDialect Dialect { get; set; } = MavlinkDialect.All;

    /// <summary>Which frames go to queues of other managers, beside those that Autopilot Interface receives.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<MavlinkSubscription> Subscriptions { get; set; } = Array.Empty<MavlinkSubscription>();

    internal CommunicationsOptions Copy() => (CommunicationsOptions)MemberwiseClone();

    internal LinkSettings SettingsOf(int link)
        => LinkSettings.TryGetValue(link, out LinkSettings? settings) ? settings : Rabit.Links.LinkSettings.None;

    internal int Count => Links.Count + RecordedFiles.Count;

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal CommunicationsOptions Validate(string parameter)
    {
        List<string> faults = FindFaultsOfLinks().Concat(FindFaultsOfValues()).ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Communications: " + string.Join("; ", faults) + ".", parameter);
        CommunicationsOptions copy = Copy();
        copy.Subscriptions = Subscriptions.ToArray();
        return copy;
    }

    /// <summary>What is wrong with that which needs neither links nor a dialect.</summary>
    internal IEnumerable<string> FindFaultsOfValues()
    {
        if (FramesWaitingIn < 1)
            yield return $"{nameof(FramesWaitingIn)} is {FramesWaitingIn}; it must be at least 1";
        if (FramesWaitingOut < 1)
            yield return $"{nameof(FramesWaitingOut)} is {FramesWaitingOut}; it must be at least 1";
        if (SilentAfter <= TimeSpan.Zero)
            yield return $"{nameof(SilentAfter)} is {SilentAfter}; it must be above zero";
        if (!(PositionRateHz >= 0 && PositionRateHz <= MaxPositionRate))
            yield return FormattableString.Invariant(
                $"{nameof(PositionRateHz)} is {PositionRateHz}; it must be 0 to {MaxPositionRate}");
        if (VehicleMessageBytesPerSecond < MavlinkFrame.MaxWireLength)
            yield return $"{nameof(VehicleMessageBytesPerSecond)} is {VehicleMessageBytesPerSecond}; "
                + $"it must be at least one frame, {MavlinkFrame.MaxWireLength}";
        if (VehicleMessageRoutes is null || VehicleMessageRoutes.Contains(null!))
            yield return $"{nameof(VehicleMessageRoutes)}, or one of them, is null; it may be empty, but not null";
        foreach (string fault in FindFaultsOfVehicleMessages())
            yield return fault;
        foreach (string fault in Recording?.FindFaults() ?? [])
            yield return $"{nameof(Recording)}.{fault}";
    }

    private IEnumerable<string> FindFaultsOfVehicleMessages()
    {
        VehicleMessageRoute[] routes = (VehicleMessageRoutes ?? []).Where(r => r is not null).ToArray();
        foreach (IGrouping<int, VehicleMessageRoute> twice in routes
            .GroupBy(r => r.MessageType).Where(g => g.Count() > 1))
            yield return $"{nameof(VehicleMessageRoutes)} has type {twice.Key} more than once";
        foreach (VehicleMessageRoute route in routes)
        {
            foreach (string fault in route.FindFaults())
                yield return $"{nameof(VehicleMessageRoutes)}, type {route.MessageType}: {fault}";
        }

        if (VehicleExchange is null)
            yield return $"{nameof(VehicleExchange)} is null";
        foreach (string fault in VehicleExchange?.FindFaults() ?? [])
            yield return $"{nameof(VehicleExchange)}.{fault}";
    }

    private IEnumerable<string> FindFaultsOfLinks()
    {
        foreach (string fault in SubscriptionCheck.FindFaults(Dialect, Subscriptions))
            yield return fault;
        if (Links is null || RecordedFiles is null || Links.Contains(null!) || RecordedFiles.Contains(null!))
        {
            yield return $"{nameof(Links)} or {nameof(RecordedFiles)}, or one of them, is null; they may be empty, but not null";
            yield break;
        }

        if (LinkSettings is null || LinkSettings.Values.Contains(null!))
            yield return $"{nameof(LinkSettings)}, or one of them, is null; it may be empty, but not null";
        foreach (int link in (LinkSettings?.Keys ?? []).Where(l => l < 0 || l >= Count))
            yield return $"{nameof(LinkSettings)} has link {link}, but there are {Count} links, numbered from 0";
        foreach (string fault in FindFaultsOfRates())
            yield return fault;
        if (Count == 0)
            yield return "there is no link";
        if (Count > MavlinkRouter.MaxLinks)
            yield return $"there are {Count} links; at most {MavlinkRouter.MaxLinks} are possible";
        foreach (string fault in Signing?.FindFaults(Links.Count) ?? [])
            yield return fault;
        foreach (string fault in FindFaultsOfBudgets())
            yield return fault;
    }

    private IEnumerable<string> FindFaultsOfRates()
    {
        foreach (KeyValuePair<int, LinkSettings> settings in LinkSettings ?? new Dictionary<int, LinkSettings>())
        {
            if (settings.Value?.BytesPerSecond < SendBudget.MinBytesPerSecond)
                yield return $"{nameof(LinkSettings)} of link {settings.Key}: "
                    + $"{nameof(settings.Value.BytesPerSecond)} is {settings.Value.BytesPerSecond}; "
                    + $"it must be at least {SendBudget.MinBytesPerSecond}";
        }
    }

    private IEnumerable<string> FindFaultsOfBudgets()
    {
        if (SendBudgets is null || SendBudgets.Values.Contains(null!))
        {
            yield return $"{nameof(SendBudgets)}, or one of them, is null; it may be empty, but not null";
            yield break;
        }

        foreach (KeyValuePair<int, SendBudget> budget in SendBudgets)
        {
            if (budget.Key < 0 || budget.Key >= Links.Count)
                yield return $"{nameof(SendBudgets)} names link {budget.Key}; there are {Links.Count} live links";
            foreach (string fault in budget.Value.FindFaults())
                yield return $"{nameof(SendBudgets)} of link {budget.Key}: {fault}";
        }
    }
}
