using System;
using System.Buffers.Binary;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Targets that are followed: 32 bytes and the name of the class (1 to 16 bytes), little-endian, no padding. Stateless;
/// any thread.
/// </summary>
/// <remarks>
/// Finder (1 byte), session (2), number (2), decision (2), decider (1), follower (1), state (2 bits), progress (2
/// bits) and result (4 bits) in one byte from the lowest bit on, length of the class name (1), latitude and longitude
/// (4 + 4, 1e-7 degrees), velocity north and east (2 + 2, cm/s), radius (2, cm), age of the position (3, ms), time in
/// view (2, s), id of the marker (2, 65535 for none), class name. The age is that at the moment of sending.
/// </remarks>
public sealed class FollowTaskCodec : IVehicleMessageCodec<FollowTask>
{
    private const int NameOffset = 32;
    private const ushort NoMarker = ushort.MaxValue;
    private const double MaxRadiusMetres = 650;
    private const double MaxSpeed = 300;
    private const double MaxAgeMs = (1 << 24) - 1;

    /// <summary>10.</summary>
    public int MessageType => 10;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in FollowTask content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        int needed = NameOffset + content.Class.Length;
        double ageMs = Math.Max(0, Math.Round((now - content.Time).ExactMilliseconds));
        if (destination.Length < needed || !IsValid(content) || !(ageMs <= MaxAgeMs))
            return false;
        destination[0] = content.Finder;
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(1), content.Session);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(3), content.Number);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(5), content.Decision);
        destination[7] = content.Decider;
        destination[8] = content.Follower;
        destination[9] = (byte)((int)content.State | ((int)content.Progress << 2) | ((int)content.Result << 4));
        destination[10] = (byte)content.Class.Length;
        WritePlace(destination.Slice(11), content);
        WriteAge(destination.Slice(25), (int)ageMs);
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(28), (ushort)Math.Min(ushort.MaxValue, Math.Round(content.InView.ExactSeconds)));
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(30), (ushort)(content.MarkerId ?? NoMarker));
        content.Class.CopyTo(destination.Slice(NameOffset));
        length = needed;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out FollowTask content)
    {
        content = default;
        if (version != Version || bytes.Length <= NameOffset || bytes.Length != NameOffset + bytes[10]
            || !TargetClassName.TryRead(bytes.Slice(NameOffset), out TargetClassName name))
            return false;
        ushort marker = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(30));
        var task = new FollowTask
        {
            Finder = bytes[0],
            Session = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(1)),
            Number = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(3)),
            Decision = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(5)),
            Decider = bytes[7],
            Follower = bytes[8],
            State = (FollowState)(bytes[9] & 3),
            Progress = (FollowProgress)((bytes[9] >> 2) & 3),
            Result = (FollowResult)(bytes[9] >> 4),
            Time = sentTime - TimeSpan.FromTicks(ReadAge(bytes.Slice(25)) * TimeSpan.TicksPerMillisecond),
            InView = TimeSpan.OfSeconds(BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(28))),
            MarkerId = marker == NoMarker ? null : marker,
            Class = name,
        };
        ReadPlace(bytes.Slice(11), ref task);
        if (!IsValid(task))
            return false;
        content = task;
        return true;
    }

    private static void WritePlace(Span<byte> destination, in FollowTask task)
    {
        PlaceBytes.Write(destination, task.Position);
        BinaryPrimitives.WriteInt16LittleEndian(
            destination.Slice(8), (short)Math.Round(task.VelocityNed.North * 100));
        BinaryPrimitives.WriteInt16LittleEndian(
            destination.Slice(10), (short)Math.Round(task.VelocityNed.East * 100));
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(12), (ushort)Math.Round(task.RadiusMetres * 100));
    }

    private static void ReadPlace(ReadOnlySpan<byte> source, ref FollowTask task)
    {
        task.Position = PlaceBytes.Read(source);
        task.VelocityNed = new NedVector(
            BinaryPrimitives.ReadInt16LittleEndian(source.Slice(8)) / 100.0,
            BinaryPrimitives.ReadInt16LittleEndian(source.Slice(10)) / 100.0, 0);
        task.RadiusMetres = BinaryPrimitives.ReadUInt16LittleEndian(source.Slice(12)) / 100.0;
    }

    private static void WriteAge(Span<byte> destination, int ageMs)
    {
        BinaryPrimitives.WriteUInt16LittleEndian(destination, (ushort)(ageMs & 0xFFFF));
        destination[2] = (byte)(ageMs >> 16);
    }

    private static long ReadAge(ReadOnlySpan<byte> source)
        => BinaryPrimitives.ReadUInt16LittleEndian(source) | (source[2] << 16);

    // Comparisons with NaN are false. An award has a follower, and what is closed a result.
    private static bool IsValid(in FollowTask task)
        => task.State is >= FollowState.Open and <= FollowState.Closed
            && task.Progress is >= FollowProgress.OnTheWay and <= FollowProgress.Searching
            && task.Result is >= FollowResult.None and <= FollowResult.Rejected
            && (task.State != FollowState.Awarded || task.Follower != 0)
            && task.State == FollowState.Closed == (task.Result != FollowResult.None)
            && task.Finder != 0 && task.Decider != 0 && task.Decision != 0
            && PlaceBytes.IsInRange(task.Position)
            && Math.Abs(task.VelocityNed.North) <= MaxSpeed
            && Math.Abs(task.VelocityNed.East) <= MaxSpeed
            && task.RadiusMetres is >= 0 and <= MaxRadiusMetres
            && task.InView >= TimeSpan.Zero
            && task.MarkerId is null or (>= 0 and < NoMarker)
            && !task.Class.IsNone;
}
