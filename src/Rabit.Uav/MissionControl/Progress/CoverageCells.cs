namespace Rabit.Uav.MissionControl;

/// <summary>The cells of a coverage grid as they are stored: one bit for each that was seen.</summary>
internal sealed class CoverageCells(PlanePoint southWest, double cellMetres, int rows, int columns, byte[] seen)
{
    public static CoverageCells None { get; } = new(default, 1, 0, 0, []);

    public PlanePoint SouthWest { get; } = southWest;

    public double CellMetres { get; } = cellMetres;

    public int Rows { get; } = rows;

    public int Columns { get; } = columns;

    public byte[] Seen { get; } = seen;

    /// <summary>How many bytes so many cells take.</summary>
    public static int BytesFor(int rows, int columns) => ((rows * columns) + 7) / 8;

    /// <summary>Whether the cell at a point was seen; outside none was.</summary>
    public bool IsSeen(PlanePoint at)
    {
        double row = (at.North - SouthWest.North) / CellMetres;
        double column = (at.East - SouthWest.East) / CellMetres;
        if (!(row >= 0 && row < Rows && column >= 0 && column < Columns))
            return false;
        int cell = ((int)row * Columns) + (int)column;
        return (Seen[cell >> 3] & (1 << (cell & 7))) != 0;
    }
}
