using System;
using System.Buffers.Binary;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Targets to be validated: 22 bytes and the name of the class (1 to 16 bytes), little-endian, no padding. Stateless;
/// any thread.
/// </summary>
/// <remarks>
/// Session (2 bytes), number (2), state (1), result (1), award (2), validator (1), length of the class name (1),
/// latitude and longitude (4 + 4, 1e-7 degrees), radius (2, cm), id of the marker (2, 65535 for none), class name.
/// </remarks>
public sealed class ValidationTaskCodec : IVehicleMessageCodec<ValidationTask>
{
    private const int NameOffset = 22;
    private const ushort NoMarker = ushort.MaxValue;
    private const double MaxRadiusMetres = 650;

    /// <summary>3.</summary>
    public int MessageType => 3;

    /// <inheritdoc/>
    public int Version => 1;

    /// <inheritdoc/>
    public bool TryEncode(in ValidationTask content, TimeSpan now, Span<byte> destination, out int length)
    {
        length = 0;
        int needed = NameOffset + content.Class.Length;
        if (destination.Length < needed || !IsValid(content))
            return false;
        BinaryPrimitives.WriteUInt16LittleEndian(destination, content.Session);
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(2), content.Number);
        destination[4] = (byte)content.State;
        destination[5] = (byte)content.Result;
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(6), content.Award);
        destination[8] = content.Validator;
        destination[9] = (byte)content.Class.Length;
        PlaceBytes.Write(destination.Slice(10), content.Position);
        BinaryPrimitives.WriteUInt16LittleEndian(
            destination.Slice(18), (ushort)Math.Round(content.RadiusMetres * 100));
        BinaryPrimitives.WriteUInt16LittleEndian(destination.Slice(20), (ushort)(content.MarkerId ?? NoMarker));
        content.Class.CopyTo(destination.Slice(NameOffset));
        length = needed;
        return true;
    }

    /// <inheritdoc/>
    public bool TryDecode(
        ReadOnlySpan<byte> bytes, int version, TimeSpan sentTime, byte sourceSystemId, out ValidationTask content)
    {
        content = default;
        if (version != Version || bytes.Length <= NameOffset || bytes.Length != NameOffset + bytes[9]
            || !TargetClassName.TryRead(bytes.Slice(NameOffset), out TargetClassName name))
            return false;
        ushort marker = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(20));
        var task = new ValidationTask
        {
            Finder = sourceSystemId,
            Session = BinaryPrimitives.ReadUInt16LittleEndian(bytes),
            Number = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(2)),
            State = (ValidationState)bytes[4],
            Result = (ValidationResult)bytes[5],
            Award = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(6)),
            Validator = bytes[8],
            Position = PlaceBytes.Read(bytes.Slice(10)),
            RadiusMetres = BinaryPrimitives.ReadUInt16LittleEndian(bytes.Slice(18)) / 100.0,
            MarkerId = marker == NoMarker ? null : marker,
            Class = name,
        };
        if (!IsValid(task))
            return false;
        content = task;
        return true;
    }

    // Comparisons with NaN are false. An award has a validator.
    private static bool IsValid(in ValidationTask task)
        => task.State is >= ValidationState.Open and <= ValidationState.Closed
            && task.Result is >= ValidationResult.Unknown and <= ValidationResult.Rejected
            && (task.State != ValidationState.Awarded || (task.Validator != 0 && task.Award != 0))
            && PlaceBytes.IsInRange(task.Position)
            && task.RadiusMetres is >= 0 and <= MaxRadiusMetres
            && task.MarkerId is null or (>= 0 and < NoMarker)
            && !task.Class.IsNone;
}
