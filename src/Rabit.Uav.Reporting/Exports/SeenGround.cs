using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>
/// The union of the ground that the pictures show: thousands of pictures that overlap become a few outlines, on a grid
/// whose cell is a 400th of the whole, at least half a metre. A cell is seen where its middle is.
/// </summary>
internal static class SeenGround
{
    private const int MaxCells = 400;
    private const double MinCellMetres = 0.5;
    private const double MaxDistanceMetres = 50_000;

    public static IReadOnlyList<SeenPatch> Trace(IReadOnlyList<CameraObservation> observations)
    {
        CameraObservation[] valid = [.. observations.Where(o => Corners(o).All(c => c.IsValid))];
        if (valid.Length == 0)
            return [];
        var frame = LocalNedFrame.IgnoringGeoid(valid[0].TopLeft);
        NedPosition[][] pictures =
        [
            .. valid.Select(o => Corners(o).Select(frame.ToNed).ToArray())
                .Where(p => p.All(c => Math.Abs(c.North) < MaxDistanceMetres && Math.Abs(c.East) < MaxDistanceMetres)),
        ];
        if (pictures.Length == 0)
            return [];
        double south = pictures.Min(p => p.Min(c => c.North));
        double west = pictures.Min(p => p.Min(c => c.East));
        double height = pictures.Max(p => p.Max(c => c.North)) - south;
        double width = pictures.Max(p => p.Max(c => c.East)) - west;
        double cell = Math.Max(MinCellMetres, Math.Max(width, height) / MaxCells);
        var grid = new CellGrid((int)Math.Ceiling(width / cell) + 1, (int)Math.Ceiling(height / cell) + 1);
        foreach (NedPosition[] picture in pictures)
            grid.Fill([.. picture.Select(c => ((c.East - west) / cell, (c.North - south) / cell))]);

        // On the ground, whatever its altitude is.
        GeodeticPosition Place((int X, int Y) corner)
            => frame.ToGeodetic(new NedPosition(south + (corner.Y * cell), west + (corner.X * cell), 0));
        return
        [
            .. grid.Patches().Select(patch => new SeenPatch(
                [.. patch.Outline.Select(Place)], [.. patch.Holes.Select(h => h.Select(Place).ToArray())])),
        ];
    }

    private static GeodeticPosition[] Corners(in CameraObservation o)
        => [o.TopLeft, o.TopRight, o.BottomRight, o.BottomLeft];
}
