using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>A box of pixels, its last row and column included. A plain value.</summary>
internal readonly struct PixelBox(int left, int top, int right, int bottom)
{
    // Corners of a bent lens bulge between the points that are looked at.
    private const double Bulge = 0.03;
    private const double MarginPixels = 3;

    public int Left { get; } = left;

    public int Top { get; } = top;

    public int Right { get; } = right;

    public int Bottom { get; } = bottom;

    /// <summary>The box around both.</summary>
    public PixelBox With(PixelBox other) => new(
        Math.Min(Left, other.Left), Math.Min(Top, other.Top), Math.Max(Right, other.Right),
        Math.Max(Bottom, other.Bottom));

    /// <summary>The pixels in which a rectangle on the ground may be seen; false if there are none.</summary>
    public static bool TryFind(SimulatedTarget sheet, in CameraPose pose, LensRays lens, out PixelBox box)
    {
        box = default;
        NedPosition centre = sheet.PositionAt(pose.Time);
        (double sin, double cos) = (Trig.Sin(sheet.Heading.Radians), Trig.Cos(sheet.Heading.Radians));
        (double leastX, double mostX, double leastY, double mostY) =
            (double.MaxValue, double.MinValue, double.MaxValue, double.MinValue);
        int behind = 0;
        for (int corner = 0; corner < 4; corner++)
        {
            double along = (corner & 1) == 0 ? sheet.SideMetres / 2 : -sheet.SideMetres / 2;
            double across = (corner & 2) == 0 ? sheet.WidthMetres / 2 : -sheet.WidthMetres / 2;
            var way = new Vector3(
                centre.North + (along * cos) - (across * sin) - pose.North,
                centre.East + (along * sin) + (across * cos) - pose.East,
                pose.Height);
            double depth = Along(way, pose.Axes.Forward);
            if (depth < 0.05 * pose.Height)
            {
                behind++;
                continue;
            }

            (double x, double y) = (Along(way, pose.Axes.Right) / depth, Along(way, pose.Axes.Down) / depth);
            (leastX, mostX) = (Math.Min(leastX, x), Math.Max(mostX, x));
            (leastY, mostY) = (Math.Min(leastY, y), Math.Max(mostY, y));
        }

        if (behind == 4)
            return false;
        if (behind > 0)
        {
            // Partly behind the camera: it may reach across any part of the picture.
            box = new PixelBox(0, 0, lens.Width - 1, lens.Height - 1);
            return true;
        }

        double margin = MarginPixels / lens.Focal;
        if (leastX > lens.MaxX + margin || mostX < lens.MinX - margin || leastY > lens.MaxY + margin
            || mostY < lens.MinY - margin)
            return false;
        box = Around(
            Math.Max(leastX, lens.MinX), Math.Min(mostX, lens.MaxX), Math.Max(leastY, lens.MinY),
            Math.Min(mostY, lens.MaxY), lens);
        return box.Left <= box.Right && box.Top <= box.Bottom;
    }

    private static PixelBox Around(double leastX, double mostX, double leastY, double mostY, LensRays lens)
    {
        (double left, double right, double top, double bottom) =
            (double.MaxValue, double.MinValue, double.MaxValue, double.MinValue);
        for (int point = 0; point < 9; point++)
        {
            double x = leastX + ((mostX - leastX) * (point % 3) / 2);
            double y = leastY + ((mostY - leastY) * (point / 3) / 2);
            (double u, double v) = lens.Project(x, y);
            (left, right) = (Math.Min(left, u), Math.Max(right, u));
            (top, bottom) = (Math.Min(top, v), Math.Max(bottom, v));
        }

        double marginX = MarginPixels + (Bulge * (right - left));
        double marginY = MarginPixels + (Bulge * (bottom - top));
        return new PixelBox(
            Math.Max(0, (int)Math.Floor(left - marginX)),
            Math.Max(0, (int)Math.Floor(top - marginY)),
            Math.Min(lens.Width - 1, (int)Math.Ceiling(right + marginX)),
            Math.Min(lens.Height - 1, (int)Math.Ceiling(bottom + marginY)));
    }

    private static double Along(Vector3 way, Vector3 axis)
        => (way.First * axis.First) + (way.Second * axis.Second) + (way.Third * axis.Third);
}
