using System;
using System.Buffers.Binary;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// The datagrams of the exchange, each the payload of one TUNNEL: version and kind in the first byte, little-endian,
/// layout in docs/managers/communications.md. Reading is strict: what cannot be is refused as a whole.
/// </summary>
internal static class ExchangeWire
{
    /// <summary>The payload type of TUNNEL: the family of the exchange.</summary>
    public const int PayloadType = 42002;

    /// <summary>The payload of TUNNEL (common.xml, 385).</summary>
    public const int MaxLength = 128;

    public const int HeaderLength = 28;
    public const int FragmentLength = MaxLength - HeaderLength;
    public const int MaxFragments = 32;
    public const int MaxContent = FragmentLength * MaxFragments;
    public const int AcknowledgementLength = 14;
    public const int AnnouncementLength = 12;

    private const byte Version = 1;
    private const int MaxLifetimeMs = 600_000;
    private const int LifetimeOffset = 16;
    private const int AgeOffset = 19;
    private const int TimeOffset = 22;

    // Of the time of sending, so that it has room in 48 bits; it is known to a millisecond at best.
    private const int MicrosecondsPerUnit = 100;
    private const byte AcknowledgedFlag = 8;
    private const byte ClassMask = 7;

    public static ExchangeKind KindOf(ReadOnlySpan<byte> datagram)
        => datagram.IsEmpty || datagram[0] >> 4 != Version ? ExchangeKind.None
            : (datagram[0] & 15) switch
            {
                (int)ExchangeKind.Fragment => ExchangeKind.Fragment,
                (int)ExchangeKind.Acknowledgement => ExchangeKind.Acknowledgement,
                (int)ExchangeKind.Announcement => ExchangeKind.Announcement,
                _ => ExchangeKind.None,
            };

    /// <summary>The class of a datagram by its first byte and its twelfth; what cannot be is coordination.</summary>
    public static VehicleMessageClass ClassOf(byte kind, byte flags) => (kind & 15) switch
    {
        (int)ExchangeKind.Fragment => (VehicleMessageClass)(flags & ClassMask),
        (int)ExchangeKind.Acknowledgement => VehicleMessageClass.Command,
        _ => VehicleMessageClass.Coordination,
    };

    /// <summary>Where the hops are: limit in the upper, what is left in the lower half.</summary>
    public static int HopsOffset(ExchangeKind kind) => kind switch
    {
        ExchangeKind.Fragment => 12,
        _ => 9,
    };

    public static byte Hops(int limit, int left) => (byte)((limit << 4) | left);

    public static int HopsLeft(byte hops) => hops & 15;

    public static bool IsRelayed(byte hops) => hops >> 4 != (hops & 15);

    /// <summary>1 to 254 ms; 255 is worse than that, 0 no common time.</summary>
    public static byte AccuracyByte(TimeSpan? accuracy)
        => accuracy is { } time ? (byte)Math.Min(255, Math.Max(1, Math.Ceiling(time.ExactMilliseconds))) : (byte)0;

    public static TimeSpan? AccuracyOf(byte accuracy)
        => accuracy == 0 ? null : TimeSpan.FromTicks(accuracy * TimeSpan.TicksPerMillisecond);

    public static int Write(Span<byte> to, in ExchangeFragment fragment, ReadOnlySpan<byte> content)
    {
        to[0] = (Version << 4) | (byte)ExchangeKind.Fragment;
        to[1] = fragment.Source;
        to[2] = (byte)fragment.Destination.To;
        to[3] = fragment.Destination.Number;
        BinaryPrimitives.WriteUInt32LittleEndian(to.Slice(4), fragment.Id);
        BinaryPrimitives.WriteUInt16LittleEndian(to.Slice(8), fragment.Type);
        to[10] = fragment.TypeVersion;
        to[11] = (byte)((int)fragment.Class | (fragment.IsAcknowledged ? AcknowledgedFlag : 0));
        to[12] = fragment.Hops;
        to[13] = fragment.Index;
        to[14] = fragment.Count;
        to[15] = fragment.Accuracy;
        Write24(to.Slice(LifetimeOffset), fragment.LifetimeMs);
        Write24(to.Slice(AgeOffset), fragment.AgeMs);
        long time = fragment.SentUtcMicroseconds / MicrosecondsPerUnit;
        Write24(to.Slice(TimeOffset), (int)(time & 0xFF_FFFF));
        Write24(to.Slice(TimeOffset + 3), (int)(time >> 24));
        content.CopyTo(to.Slice(HeaderLength));
        return HeaderLength + content.Length;
    }

    public static bool TryRead(ReadOnlySpan<byte> from, out ExchangeFragment fragment)
    {
        fragment = default;
        if (from.Length < HeaderLength || from.Length > HeaderLength + FragmentLength)
            return false;
        var to = (VehicleDestination.Kind)from[2];
        bool isDestination = (to == VehicleDestination.Kind.All && from[3] == 0)
            || (to == VehicleDestination.Kind.Vehicle && from[3] != 0)
            || (to == VehicleDestination.Kind.Group && from[3] <= VehicleDestination.MaxGroup);
        fragment = new ExchangeFragment
        {
            Source = from[1],
            Destination = new VehicleDestination(to, from[3]),
            Id = BinaryPrimitives.ReadUInt32LittleEndian(from.Slice(4)),
            Type = BinaryPrimitives.ReadUInt16LittleEndian(from.Slice(8)),
            TypeVersion = from[10],
            Class = (VehicleMessageClass)(from[11] & ClassMask),
            IsAcknowledged = (from[11] & AcknowledgedFlag) != 0,
            Hops = from[12],
            Index = from[13],
            Count = from[14],
            Accuracy = from[15],
            LifetimeMs = Read24(from.Slice(LifetimeOffset)),
            AgeMs = Read24(from.Slice(AgeOffset)),
            SentUtcMicroseconds = MicrosecondsPerUnit
                * (Read24(from.Slice(TimeOffset)) + ((long)Read24(from.Slice(TimeOffset + 3)) << 24)),
        };

        // All but the last are full, so that each has its place.
        int length = from.Length - HeaderLength;
        return isDestination && fragment.Source != 0 && fragment.Class <= VehicleMessageClass.Bulk
            && (from[11] & ~(ClassMask | AcknowledgedFlag)) == 0 && AreHops(fragment.Hops)
            && fragment.Count is > 0 and <= MaxFragments && fragment.Index < fragment.Count
            && (fragment.Index == fragment.Count - 1
                ? length > 0 || fragment.Count == 1
                : length == FragmentLength)
            && fragment.LifetimeMs <= MaxLifetimeMs && fragment.AgeMs <= MaxLifetimeMs
            && (fragment.SentUtcMicroseconds == 0) == (fragment.Accuracy == 0);
    }

    public static int Write(Span<byte> to, in ExchangeAcknowledgement acknowledgement)
    {
        to[0] = (Version << 4) | (byte)ExchangeKind.Acknowledgement;
        to[1] = acknowledgement.Source;
        to[2] = (byte)VehicleDestination.Kind.Vehicle;
        to[3] = acknowledgement.Destination;
        BinaryPrimitives.WriteUInt32LittleEndian(to.Slice(4), acknowledgement.Id);
        to[8] = (byte)(acknowledgement.IsUnderstood ? 0 : 1);
        to[9] = acknowledgement.Hops;
        BinaryPrimitives.WriteUInt32LittleEndian(to.Slice(10), acknowledgement.Fragments);
        return AcknowledgementLength;
    }

    public static bool TryRead(ReadOnlySpan<byte> from, out ExchangeAcknowledgement acknowledgement)
    {
        acknowledgement = default;
        if (from.Length != AcknowledgementLength || from[2] != (byte)VehicleDestination.Kind.Vehicle || from[8] > 1)
            return false;
        acknowledgement = new ExchangeAcknowledgement
        {
            Source = from[1],
            Destination = from[3],
            Id = BinaryPrimitives.ReadUInt32LittleEndian(from.Slice(4)),
            IsUnderstood = from[8] == 0,
            Hops = from[9],
            Fragments = BinaryPrimitives.ReadUInt32LittleEndian(from.Slice(10)),
        };
        return acknowledgement.Source != 0 && acknowledgement.Destination != 0 && AreHops(acknowledgement.Hops);
    }

    public static int Write(Span<byte> to, in ExchangeAnnouncement announcement)
    {
        to[0] = (Version << 4) | (byte)ExchangeKind.Announcement;
        to[1] = announcement.Source;
        BinaryPrimitives.WriteUInt32LittleEndian(to.Slice(2), announcement.Groups);
        to[6] = announcement.Accuracy;
        BinaryPrimitives.WriteUInt16LittleEndian(to.Slice(7), announcement.Number);
        to[9] = announcement.Hops;
        BinaryPrimitives.WriteUInt16LittleEndian(to.Slice(10), announcement.Session);
        return AnnouncementLength;
    }

    public static bool TryRead(ReadOnlySpan<byte> from, out ExchangeAnnouncement announcement)
    {
        announcement = default;
        if (from.Length != AnnouncementLength)
            return false;
        announcement = new ExchangeAnnouncement
        {
            Source = from[1],
            Groups = BinaryPrimitives.ReadUInt32LittleEndian(from.Slice(2)),
            Accuracy = from[6],
            Number = BinaryPrimitives.ReadUInt16LittleEndian(from.Slice(7)),
            Hops = from[9],
            Session = BinaryPrimitives.ReadUInt16LittleEndian(from.Slice(10)),
        };
        return announcement.Source != 0 && AreHops(announcement.Hops);
    }

    /// <summary>Makes a fragment older, and takes as much off its life.</summary>
    /// <returns>False where that has ended.</returns>
    public static bool TryAge(Span<byte> fragment, TimeSpan age)
    {
        int ms = (int)Math.Ceiling(age.ExactMilliseconds);
        int left = Read24(fragment.Slice(LifetimeOffset)) - ms;
        if (left <= 0)
            return false;
        Write24(fragment.Slice(LifetimeOffset), left);
        Write24(fragment.Slice(AgeOffset), Math.Min(MaxLifetimeMs, Read24(fragment.Slice(AgeOffset)) + ms));
        return true;
    }

    private static void Write24(Span<byte> to, int value)
        => (to[0], to[1], to[2]) = ((byte)value, (byte)(value >> 8), (byte)(value >> 16));

    private static int Read24(ReadOnlySpan<byte> from) => from[0] | (from[1] << 8) | (from[2] << 16);

    private static bool AreHops(byte hops)
        => hops >> 4 <= VehicleExchangeOptions.MaxHops && (hops & 15) <= hops >> 4;
}
