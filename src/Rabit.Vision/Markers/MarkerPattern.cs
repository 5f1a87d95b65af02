using System;

namespace Rabit.Vision;

/// <summary>
/// What a marker looks like, cell by cell, to print or draw it: a black ring around its code, upright as OpenCV draws
/// it. It is only found with a white border around the ring, one cell wide or wider. Any thread.
/// </summary>
/// <example>
/// <code>
/// int cells = MarkerPattern.CellsPerSide(MarkerFamily.AprilTag36h11);   // 8
/// for (int row = 0; row &lt; cells; row++)
/// {
///     for (int column = 0; column &lt; cells; column++)
///         Console.Write(MarkerPattern.IsWhite(MarkerFamily.AprilTag36h11, 7, row, column) ? "  " : "##");
///     Console.WriteLine();
/// }
/// </code>
/// </example>
public static class MarkerPattern
{
    /// <summary>How many markers the family has; their ids begin at 0.</summary>
    /// <param name="family">Which family.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such family.</exception>
    public static int Count(MarkerFamily family) => Of(family).Count;

    /// <summary>Cells side by side, the black ring with them and the white border without.</summary>
    /// <param name="family">Which family.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such family.</exception>
    public static int CellsPerSide(MarkerFamily family) => Of(family).Cells;

    /// <summary>Whether a cell is white.</summary>
    /// <param name="family">Which family.</param>
    /// <param name="id">Which of its markers.</param>
    /// <param name="row">From the top, 0 to <see cref="CellsPerSide"/> - 1; rows beyond are the white border.</param>
    /// <param name="column">From the left; columns beyond are the white border.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such family, or it has no such id.</exception>
    public static bool IsWhite(MarkerFamily family, int id, int row, int column)
    {
        MarkerDictionary markers = Of(family);
        if (id < 0 || id >= markers.Count)
        {
            throw new ArgumentOutOfRangeException(
                nameof(id), id, $"The family {family} has the ids 0 to {markers.Count - 1}.");
        }

        int last = markers.Cells - 1;
        if (row < 0 || row > last || column < 0 || column > last)
            return true;
        if (row == 0 || row == last || column == 0 || column == last)
            return false;
        int bit = ((row - 1) * markers.PayloadSide) + column - 1;
        return ((markers.CodeOf(id) >> ((markers.PayloadSide * markers.PayloadSide) - 1 - bit)) & 1) != 0;
    }

    private static MarkerDictionary Of(MarkerFamily family)
        => family is MarkerFamily.ArUco4x4 or MarkerFamily.AprilTag36h11
            ? MarkerDictionary.Of(family)
            : throw new ArgumentOutOfRangeException(nameof(family), family, "There is no such family of markers.");
}
