namespace Rabit.Vision;

/// <summary>Where the pixels of a turned and scaled window lie in a picture, pixels.</summary>
internal struct PlaneWindow
{
    /// <summary>Column in the picture of the first pixel of the window.</summary>
    public double Column;

    /// <summary>Row in the picture of the first pixel of the window.</summary>
    public double Row;

    public double ColumnByColumn;
    public double RowByColumn;
    public double ColumnByRow;
    public double RowByRow;

    /// <summary>Along a heading of the plane, with pixels of a given side.</summary>
    public static PlaneWindow Along(in PlaneScale scale, double heading, double metresPerPixel)
    {
        double cos = System.Trig.Cos(heading) * metresPerPixel;
        double sin = System.Trig.Sin(heading) * metresPerPixel;
        var window = default(PlaneWindow);
        (window.ColumnByColumn, window.RowByColumn) = scale.ToPicture(cos, sin);
        (window.ColumnByRow, window.RowByRow) = scale.ToPicture(-sin, cos);
        return window;
    }

    /// <summary>Moves it so that a place of the window comes to lie on one of the picture.</summary>
    public void Put(double windowColumn, double windowRow, double column, double row)
    {
        Column = column - (ColumnByColumn * windowColumn) - (ColumnByRow * windowRow);
        Row = row - (RowByColumn * windowColumn) - (RowByRow * windowRow);
    }

    public readonly (double Column, double Row) ToPicture(double windowColumn, double windowRow)
        => (Column + (ColumnByColumn * windowColumn) + (ColumnByRow * windowRow),
            Row + (RowByColumn * windowColumn) + (RowByRow * windowRow));

    public readonly (double Column, double Row) FromPicture(double column, double row)
    {
        double determinant = (ColumnByColumn * RowByRow) - (ColumnByRow * RowByColumn);
        (double x, double y) = (column - Column, row - Row);
        return (((RowByRow * x) - (ColumnByRow * y)) / determinant,
            ((ColumnByColumn * y) - (RowByColumn * x)) / determinant);
    }
}
