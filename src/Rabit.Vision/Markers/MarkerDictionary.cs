using System;

namespace Rabit.Vision;

/// <summary>The codes of one family in all four rotations. Immutable; any thread.</summary>
internal sealed class MarkerDictionary
{
    // Of the outlines of the white areas: one rectangle has four, one that covers a part of another eight.
    private const int MaxSimpleCorners = 8;

    private readonly bool[] _isSimple;
    private readonly ulong[] _codes;   // four for each id: turned by 0, 1, 2, 3 quarter turns clockwise

    private MarkerDictionary(MarkerFamily family, int side, ulong[] codes, MarkerLimits limits)
    {
        (Family, PayloadSide, Count, Limits) = (family, side, codes.Length, limits);
        _isSimple = new bool[codes.Length];
        _codes = new ulong[4 * codes.Length];
        for (int id = 0; id < codes.Length; id++)
        {
            ulong code = codes[id];
            _isSimple[id] = CornersOf(code, side) <= MaxSimpleCorners;
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

    /// <summary>
    /// Whether two rectangles that cover each other look like the marker: the ids 10, 17, 34 and 37 of DICT_4X4_50,
    /// none of 36h11.
    /// </summary>
    public bool IsSimple(int id) => _isSimple[id];

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

    // Where four cells meet: a corner if one or three of them are white, two if those are that only touch there.
    private static int CornersOf(ulong code, int side)
    {
        int corners = 0;
        for (int row = 0; row <= side; row++)
        {
            for (int column = 0; column <= side; column++)
            {
                int first = WhiteAt(code, side, row - 1, column - 1);
                int last = WhiteAt(code, side, row, column);
                int white = first + last + WhiteAt(code, side, row - 1, column) + WhiteAt(code, side, row, column - 1);
                corners += white is 1 or 3 ? 1 : white == 2 && first == last ? 2 : 0;
            }
        }

        return corners;
    }

    private static int WhiteAt(ulong code, int side, int row, int column)
        => row >= 0 && row < side && column >= 0 && column < side
            ? (int)(code >> ((side * side) - 1 - ((row * side) + column))) & 1
            : 0;

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
