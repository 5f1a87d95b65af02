using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>How a vehicle takes part in the exchange of messages between vehicles.</summary>
public sealed class VehicleExchangeOptions
{
    /// <summary>The most hops that a message may be relayed.</summary>
    public const int MaxHops = 7;

    /// <summary>The groups that this vehicle is in, 0 to <see cref="VehicleDestination.MaxGroup"/>.</summary>
    /// <value>The default is none.</value>
    public IReadOnlyList<int> Groups { get; set; } = Array.Empty<int>();

    /// <summary>Whether messages of others that may be relayed are sent on.</summary>
    /// <value>The default is true.</value>
    public bool Relays { get; set; } = true;

    /// <summary>
    /// Whether the vehicle says that it is there, and in which groups: for messages to all and to groups that are
    /// acknowledged.
    /// </summary>
    /// <value>The default is null: where a route is acknowledged, or the vehicle is in a group.</value>
    public bool? Announces { get; set; }

    /// <summary>How often it says so.</summary>
    /// <value>The default is 2 s; who was not received for five of them is gone.</value>
    public TimeSpan AnnouncementPeriod { get; set; } = TimeSpan.FromSeconds(2);

    /// <summary>
    /// How far announcements are relayed, hops: whom a message to a group or to all is for where it goes over others.
    /// </summary>
    /// <value>The default is 0: each relayed announcement is sent by every vehicle that receives it.</value>
    public int AnnouncementHops { get; set; }

    internal uint GroupBits => Groups.Aggregate(0u, (bits, group) => bits | (1u << group));

    internal VehicleExchangeOptions Copy() => (VehicleExchangeOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        foreach (int group in (Groups ?? []).Where(g => g is < 0 or > VehicleDestination.MaxGroup))
            yield return $"{nameof(Groups)} has {group}; a group is 0 to {VehicleDestination.MaxGroup}";
        if (Groups is null)
            yield return $"{nameof(Groups)} is null; it may be empty";
        if (AnnouncementPeriod < TimeSpan.FromMilliseconds(100))
            yield return $"{nameof(AnnouncementPeriod)} is {AnnouncementPeriod}; it must be at least 0.1 s";
        if (AnnouncementHops is < 0 or > MaxHops)
            yield return $"{nameof(AnnouncementHops)} is {AnnouncementHops}; it must be 0 to {MaxHops}";
    }
}
