using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting.Exports;

namespace Rabit.Uav.Reporting;

/// <summary>
/// How much of the area the recorded pictures of several vehicles show together. As Mission Control counts it: in cells
/// of a metre, of a large area in larger ones, each by its centre.
/// </summary>
internal static class GroupCoverage
{
    private const double MinCellMetres = 1;
    private const double MaxCells = 250_000;
    private const double MaxPictureMetres = 2_000;

    /// <returns>0 to 1; 0 where there is no plan.</returns>
    public static double Of(IReadOnlyList<FlightRecord> records)
    {
        SearchPlan? plan = records.Select(r => r.Mission.Plan).FirstOrDefault(p => p?.Area.Length > 2);
        if (plan is null)
            return 0;
        var frame = LocalNedFrame.IgnoringGeoid(plan.Home);
        NedPosition[] area = plan.Area.Select(frame.ToNed).ToArray();
        NedPosition[][] keepOuts = plan.KeepOuts.IsDefault
            ? []
            : plan.KeepOuts.Select(k => k.Select(frame.ToNed).ToArray()).ToArray();
        (double south, double west) = (area.Min(c => c.North), area.Min(c => c.East));
        (double height, double width) = (area.Max(c => c.North) - south, area.Max(c => c.East) - west);
        double cell = Math.Max(MinCellMetres, Math.Sqrt(height * width / MaxCells));
        (int columns, int rows) = ((int)Math.Ceiling(width / cell), (int)Math.Ceiling(height / cell));
        var grid = new CellGrid(columns, rows);
        foreach (NedPosition[] picture in records.SelectMany(r => r.Observations).Select(o => Corners(o, frame)))
        {
            if (IsPicture(picture))
                grid.Fill([.. picture.Select(c => ((c.East - west) / cell, (c.North - south) / cell))]);
        }

        (int cells, int seen) = (0, 0);
        for (int row = 0; row < rows; row++)
        {
            for (int column = 0; column < columns; column++)
            {
                var centre = new NedPosition(south + ((row + 0.5) * cell), west + ((column + 0.5) * cell), 0);
                if (!Contains(area, centre) || Array.Exists(keepOuts, k => Contains(k, centre)))
                    continue;
                cells++;
                seen += grid.IsFilled(column, row) ? 1 : 0;
            }
        }

        return cells == 0 ? 0 : (double)seen / cells;
    }

    private static NedPosition[] Corners(in CameraObservation o, LocalNedFrame frame)
    {
        GeodeticPosition[] corners = [o.TopLeft, o.TopRight, o.BottomRight, o.BottomLeft];
        return Array.TrueForAll(corners, c => c.IsValid) ? Array.ConvertAll(corners, frame.ToNed) : [];
    }

    private static bool IsPicture(NedPosition[] corners)
        => corners.Length > 0 && corners.All(c => c.HorizontalDistanceTo(corners[0]) < MaxPictureMetres);

    // Whether a ray from it leaves the polygon one time more than it enters it.
    private static bool Contains(NedPosition[] polygon, NedPosition place)
    {
        bool isInside = false;
        for (int i = 0, before = polygon.Length - 1; i < polygon.Length; before = i++)
        {
            NedPosition a = polygon[i];
            NedPosition b = polygon[before];
            if ((a.North > place.North) != (b.North > place.North)
                && place.East < a.East + ((b.East - a.East) * (place.North - a.North) / (b.North - a.North)))
                isInside = !isInside;
        }

        return isInside;
    }
}
