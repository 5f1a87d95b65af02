using System;

namespace Rabit.Uav.Messages;

/// <summary>Who a message between vehicles is for: one vehicle, a group, or all. A plain value.</summary>
public readonly struct VehicleDestination : IEquatable<VehicleDestination>
{
    /// <summary>The highest number of a group.</summary>
    public const int MaxGroup = 31;

    internal enum Kind : byte
    {
        All,
        Vehicle,
        Group,
    }

    internal VehicleDestination(Kind to, byte number) => (To, Number) = (to, number);

    internal Kind To { get; }

    internal byte Number { get; }

    /// <summary>All vehicles; <c>default</c> is the same.</summary>
    public static VehicleDestination All => default;

    /// <summary>One vehicle.</summary>
    /// <param name="systemId">Its MAVLink system id, 1 to 255.</param>
    /// <exception cref="ArgumentOutOfRangeException">0 is no vehicle.</exception>
    public static VehicleDestination Vehicle(byte systemId) => systemId == 0
        ? throw new ArgumentOutOfRangeException(nameof(systemId), systemId, "System id 0 is no vehicle.")
        : new VehicleDestination(Kind.Vehicle, systemId);

    /// <summary>All vehicles that are in a group.</summary>
    /// <param name="group">Its number, 0 to <see cref="MaxGroup"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such group.</exception>
    public static VehicleDestination Group(int group) => group is < 0 or > MaxGroup
        ? throw new ArgumentOutOfRangeException(nameof(group), group, $"A group is 0 to {MaxGroup}.")
        : new VehicleDestination(Kind.Group, (byte)group);

    /// <summary>Whether both are for the same.</summary>
    public static bool operator ==(VehicleDestination left, VehicleDestination right) => left.Equals(right);

    /// <summary>Whether they are for others.</summary>
    public static bool operator !=(VehicleDestination left, VehicleDestination right) => !left.Equals(right);

    /// <inheritdoc/>
    public bool Equals(VehicleDestination other) => To == other.To && Number == other.Number;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is VehicleDestination other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => ((int)To << 8) | Number;

    /// <inheritdoc/>
    public override string ToString() => To switch
    {
        Kind.Vehicle => FormattableString.Invariant($"vehicle {Number}"),
        Kind.Group => FormattableString.Invariant($"group {Number}"),
        _ => "all",
    };
}
