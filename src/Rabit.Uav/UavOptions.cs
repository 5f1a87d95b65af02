using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.ImageProcessing;
using Rabit.Links;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.SensorFusion;

namespace Rabit.Uav;

/// <summary>What a UAV companion computer is made of. Read once, when it is opened.</summary>
public sealed class UavOptions
{
    /// <summary>The links, at least one. A recorded log at another speed than 1 goes with recorded logs of the same speed only.</summary>
    public IReadOnlyList<LinkUrl> Links { get; set; } = Array.Empty<LinkUrl>();

    /// <summary>Our MAVLink system id, 1 to 255; null for that of the vehicle that carries us.</summary>
    /// <value>The default is null.</value>
    public byte? SystemId { get; set; }

    /// <summary>Our MAVLink component id.</summary>
    /// <value>The default is 191, MAV_COMP_ID_ONBOARD_COMPUTER.</value>
    public byte ComponentId { get; set; } = 191;

    /// <summary>Whether the autopilot is asked for the message rates that we need. A replay asks nobody.</summary>
    /// <value>The default is true.</value>
    public bool RequestsMessageRates { get; set; } = true;

    /// <summary>Links that are open already, for example to a simulated vehicle; they come before <see cref="Links"/>, and are closed with the rest.</summary>
    public IReadOnlyList<IByteLink> OpenLinks { get; set; } = Array.Empty<IByteLink>();

    /// <summary>Which live links are signed, and how; null for none. They are numbered from 0, <see cref="OpenLinks"/> first.</summary>
    /// <value>The default is null.</value>
    public SigningOptions? Signing { get; set; }

    /// <summary>The mission; null to observe.</summary>
    /// <value>The default is null.</value>
    public MissionPlan? Mission { get; set; }

    /// <summary>Whether the vehicle may be commanded. Without it a mission is refused.</summary>
    /// <value>The default is false: we observe.</value>
    public bool MayCommand { get; set; }

    /// <summary>The camera; null for none.</summary>
    /// <value>The default is null.</value>
    public IReaderSource<CameraFrame>? Camera { get; set; }

    /// <summary>How pictures are searched and located: lens, mount, what a target looks like, how good the sensors are.</summary>
    public ImageProcessingOptions Imaging { get; set; } = new();

    /// <summary>How reports become tracks.</summary>
    public SensorFusionOptions Fusion { get; set; } = new();

    /// <summary>The limits of Health Monitoring.</summary>
    public HealthOptions Health { get; set; } = new();

    /// <summary>Managers of the user that fly along: they are added after ours, and Health Monitoring watches them.</summary>
    public IReadOnlyList<RabitManager> OtherManagers { get; set; } = Array.Empty<RabitManager>();

    /// <summary>
    /// The messages that are checked and named on all links. Messages of your own are put together with ours:
    /// <c>MavlinkDialect.Combine("mine", MavlinkDialect.All, MineDialect.Instance)</c>.
    /// </summary>
    /// <value>The default is <see cref="MavlinkDialect.All"/>. It must have all of <see cref="MavlinkDialect.Common"/>, which the managers use.</value>
    public MavlinkDialect Dialect { get; set; } = MavlinkDialect.All;

    /// <summary>Which MAVLink frames go to queues of <see cref="OtherManagers"/>.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<MavlinkSubscription> Subscriptions { get; set; } = Array.Empty<MavlinkSubscription>();

    /// <summary>The time to run in; null for the one that goes with the links.</summary>
    /// <value>The default is null.</value>
    public RabitTime? Time { get; set; }

    /// <summary>Fixes the order among managers in virtual time, where a log is played at another pace than its own.</summary>
    /// <value>The default is 0.</value>
    public long Seed { get; set; }

    internal bool IsReplay => OpenLinks.Count == 0 && Links.All(l => l.Kind == LinkKind.RecordedFile);

    /// <summary>How many times faster than real time; 1 for real time itself.</summary>
    internal double Speed => Links.Count == 0 ? 1 : Links.Max(l => l.Speed);

    /// <exception cref="ArgumentException">Options are out of their range or do not go together; the text names all of them.</exception>
    internal void Validate(string parameter)
    {
        var faults = new List<string>();
        if (Links is null || OpenLinks is null || Links.Count + OpenLinks.Count == 0)
            throw new ArgumentException("A UAV needs at least one link.", parameter);
        if (Links.Contains(null!))
            throw new ArgumentException("A link is null.", parameter);
        int links = Links.Count + OpenLinks.Count;
        if (links > MavlinkRouter.MaximumLinks)
            faults.Add($"there are {links} links; at most {MavlinkRouter.MaximumLinks} are possible");
        faults.AddRange(SubscriptionCheck.FindFaults(Dialect, Subscriptions));
        if (SystemId == 0)
            faults.Add($"{nameof(SystemId)} is 0; it must be 1 to 255");
        if (ComponentId == 0)
            faults.Add($"{nameof(ComponentId)} is 0; it must be 1 to 255");
        faults.AddRange(Links
            .GroupBy(l => l.ToString(), StringComparer.Ordinal)
            .Where(g => g.Count() > 1)
            .Select(g => $"link {g.Key} is given {g.Count()} times"));

        if (Signing is not null && IsReplay)
            faults.Add("there is nothing to sign in a replay");
        faults.AddRange(IsReplay ? [] : Signing?.FindFaults(OpenLinks.Count + Links.Count(l => l.Kind != LinkKind.RecordedFile)) ?? []);

        LinkUrl? fast = Links.FirstOrDefault(l => !l.Speed.Equals(1));
        LinkUrl? other = fast is null ? null : Links.FirstOrDefault(l => l.Kind != LinkKind.RecordedFile || !l.Speed.Equals(fast.Speed));
        if (other is not null)
            faults.Add($"{fast} plays at another pace than {other}; a log at another speed than 1 goes with logs of the same speed only");
        if (fast is not null && (OpenLinks.Count > 0 || Time is not null))
            faults.Add($"{fast} plays at a pace of its own, which does not go with other links or another time");
        if (Mission is not null && !MayCommand)
            faults.Add($"there is a mission, but {nameof(MayCommand)} is false");
        if (MayCommand && IsReplay)
            faults.Add("nobody can be commanded in a replay");
        if (faults.Count > 0)
            throw new ArgumentException(string.Join("; ", faults) + ".", parameter);
    }
}
