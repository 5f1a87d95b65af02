using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.Reporting.Html;

/// <summary>How often each cell of the ground was observed, as a mask: lighter for more observations.</summary>
internal static class CoverageRaster
{
    private const int Columns = 400;
    private const double MaxDistanceMetres = 5_000;

    // How light, by how often: never, once, 2 to 3, 4 to 7, 8 to 15, more.
    private static readonly byte[] Light = [0, 34, 56, 78, 100, 122];

    /// <returns>The picture as a data address; null where nothing was observed.</returns>
    public static string? Draw(MapFrame frame, IReadOnlyList<CameraObservation> observations)
    {
        if (observations.Count == 0)
            return null;
        double cell = MapFrame.Width / Columns;
        int rows = Math.Max(1, (int)Math.Ceiling(frame.Height / cell));
        var counts = new int[Columns * rows];
        foreach (CameraObservation observation in observations)
            Count(frame, observation, cell, rows, counts);

        var pixels = new byte[counts.Length * 3];
        for (int index = 0; index < pixels.Length; index++)
            pixels[index] = Light[Level(counts[index / 3])];
        return DataUri.Of(new RgbPicture(Columns, rows, pixels));
    }

    private static int Level(int count)
    {
        int level = 0;
        for (; count > 0 && level < Light.Length - 1; count >>= 1)
            level++;
        return level;
    }

    // The four corners are a convex figure: in each row of cells all between its left and right edge.
    private static void Count(MapFrame frame, in CameraObservation observation, double cell, int rows, int[] counts)
    {
        (double X, double Y)[] corners =
        [
            .. new[] { observation.TopLeft, observation.TopRight, observation.BottomRight, observation.BottomLeft }
                .Select(frame.ToMap)
        ];
        if (Array.Exists(corners, c => !(Math.Abs(c.X) + Math.Abs(c.Y) < MaxDistanceMetres * frame.UnitsPerMetre)))
            return;
        int first = Math.Max(0, (int)Math.Floor(corners.Min(c => c.Y) / cell));
        int last = Math.Min(rows - 1, (int)Math.Floor(corners.Max(c => c.Y) / cell));
        for (int row = first; row <= last; row++)
        {
            (double left, double right) = Span(corners, (row + 0.5) * cell);
            int end = Math.Min(Columns - 1, (int)Math.Floor((right / cell) - 0.5));
            for (int column = Math.Max(0, (int)Math.Ceiling((left / cell) - 0.5)); column <= end; column++)
                counts[(row * Columns) + column]++;
        }
    }

    private static (double Left, double Right) Span((double X, double Y)[] corners, double y)
    {
        double left = double.PositiveInfinity;
        double right = double.NegativeInfinity;
        for (int index = 0; index < corners.Length; index++)
        {
            (double X, double Y) a = corners[index];
            (double X, double Y) b = corners[(index + 1) % corners.Length];
            if ((a.Y > y) == (b.Y > y))
                continue;
            double x = a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y));
            left = Math.Min(left, x);
            right = Math.Max(right, x);
        }

        return (left, right);
    }
}
