using System;

namespace Rabit.Vision;

/// <summary>The codes of one family in all four rotations. Immutable; any thread.</summary>
internal sealed class MarkerDictionary
{
    private readonly ulong[] _codes;   // four for each id: turned by 0, 1, 2, 3 quarter turns clockwise

    private MarkerDictionary(MarkerFamily family, int side, ulong[] codes, MarkerLimits limits)
    {
        (Family, PayloadSide, Count, Limits) = (family, side, codes.Length, limits);
        _codes = new ulong[4 * codes.Length];
        for (int id = 0; id < codes.Length; id++)
        {
            ulong code = codes[id];
            for (int turn = 0; turn < 4; turn++, code = Turned(code, side))
                _codes[(4 * id) + turn] = code;
        }
    }

    public static MarkerDictionary ArUco4x4 { get; } =
        new(MarkerFamily.ArUco4x4, 4, MarkerCodes.ArUco4x4, MarkerLimits.ArUco4x4);

    public static MarkerDictionary AprilTag36h11 { get; } =
        new(MarkerFamily.AprilTag36h11, 6, MarkerCodes.AprilTag36h11, MarkerLimits.AprilTag36h11);

    public MarkerFamily Family { get; }

    /// <summary>Cells of the payload side by side.</summary>
    public int PayloadSide { get; }

    /// <summary>Cells of the black square side by side.</summary>
    public int Cells => PayloadSide + 2;

    public int Count { get; }

    public MarkerLimits Limits { get; }

    public static MarkerDictionary Of(MarkerFamily family)
        => family == MarkerFamily.ArUco4x4 ? ArUco4x4 : AprilTag36h11;

    /// <summary>The payload of a marker, turned clockwise by quarter turns.</summary>
    public ulong CodeOf(int id, int turn = 0) => _codes[(4 * id) + turn];

    /// <summary>The code that was read, or one that differs from it in few cells; false if there is none.</summary>
    /// <param name="code">As read.</param>
    /// <param name="id">Of which marker.</param>
    /// <param name="turn">How many quarter turns clockwise the marker is turned in what was read.</param>
    /// <param name="distance">How many cells differ.</param>
    public bool TryFind(ulong code, out int id, out int turn, out int distance)
    {
        ulong[] codes = _codes;
        for (int i = 0; i < codes.Length; i++)
        {
            distance = BitsOf(codes[i] ^ code);
            if (distance > Limits.MaxCorrected)
                continue;
            (id, turn) = (i / 4, i % 4);
            return true;
        }

        (id, turn, distance) = (-1, 0, 0);
        return false;
    }

    internal static int BitsOf(ulong value)
    {
        value -= (value >> 1) & 0x5555555555555555;
        value = (value & 0x3333333333333333) + ((value >> 2) & 0x3333333333333333);
        return (int)((((value + (value >> 4)) & 0x0F0F0F0F0F0F0F0F) * 0x0101010101010101) >> 56);
    }

    // A quarter turn clockwise: what was the left column, from the bottom, is the top row.
    private static ulong Turned(ulong code, int side)
    {
        ulong turned = 0;
        for (int row = 0; row < side; row++)
        {
            for (int column = 0; column < side; column++)
            {
                int from = ((side - 1 - column) * side) + row;
                turned = (turned << 1) | ((code >> ((side * side) - 1 - from)) & 1);
            }
        }

        return turned;
    }
}
