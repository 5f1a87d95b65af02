using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>The vehicles that were received lately, and their groups. One thread.</summary>
internal sealed class ExchangePeers
{
    // As many as there are system ids.
    private readonly Peer?[] _peers = new Peer?[256];

    /// <summary>Those of a destination that were received since.</summary>
    public IEnumerable<byte> Of(VehicleDestination destination, TimeSpan since)
    {
        for (int system = 1; system < _peers.Length; system++)
        {
            bool isMeant = _peers[system] is { } peer && peer.ReceivedAt >= since
                && (destination.To == VehicleDestination.Kind.All
                    || (destination.To == VehicleDestination.Kind.Group
                        && (peer.Groups & (1u << destination.Number)) != 0));
            if (isMeant)
                yield return (byte)system;
        }
    }

    /// <summary>How many were received since.</summary>
    public int Count(TimeSpan since)
    {
        int count = 0;
        foreach (Peer? peer in _peers)
        {
            if (peer is not null && peer.ReceivedAt >= since)
                count++;
        }

        return count;
    }

    /// <summary>How good the GPS time of a vehicle is; null where it has none, or is not known.</summary>
    public TimeSpan? AccuracyOf(byte system) => _peers[system]?.Accuracy;

    /// <returns>Whether it was not received before, or has started again.</returns>
    public bool Take(in ExchangeAnnouncement announcement, TimeSpan now)
    {
        Peer? before = _peers[announcement.Source];
        bool isNew = before is null || before.Session != announcement.Session;
        if (!isNew && unchecked((short)(announcement.Number - before!.Number)) <= 0)
            return false;
        _peers[announcement.Source] = new Peer
        {
            Session = announcement.Session,
            Number = announcement.Number,
            Groups = announcement.Groups,
            Accuracy = ExchangeWire.AccuracyOf(announcement.Accuracy),
            ReceivedAt = now,
        };
        return isNew;
    }

    private sealed class Peer
    {
        public ushort Session { get; init; }

        public ushort Number { get; init; }

        public uint Groups { get; init; }

        public TimeSpan? Accuracy { get; init; }

        public TimeSpan ReceivedAt { get; init; }
    }
}
