using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>
/// AprilTag 36h11 number 0, printed on white on the ground, as a camera sees it: 3 x 3 samples a pixel. Its top
/// is north.
/// </summary>
/// <remarks>The code is that of the family's own table (tag36h11.c), read by rows.</remarks>
internal sealed class PrintedTag(double north, double east, double sideMetres)
{
    private const int Cells = 8;
    private const int Samples = 3;
    private const ulong Code = 0x21A146BAB;
    private const byte Black = 30;
    private const byte White = 220;
    private const byte Ground = 120;

    public double North { get; } = north;

    public double East { get; } = east;

    /// <summary>A picture of such prints in RGB.</summary>
    public static byte[] Show(TestView view, params PrintedTag[] tags)
    {
        byte[] rgb = new byte[view.Camera.Width * view.Camera.Height * 3];
        rgb.AsSpan().Fill(Ground);
        GroundProjection ground = view.Projection(new ErrorBudget());
        foreach (PrintedTag tag in tags)
            tag.Draw(view, ground, rgb);
        return rgb;
    }

    private void Draw(TestView view, in GroundProjection ground, byte[] rgb)
    {
        Assert.True(view.TryProject(North, East, out double column, out double row));
        double metresPerPixel = view.HeightMetres / view.Camera.FocalX;
        int reach = (int)Math.Ceiling(1.3 * sideMetres / metresPerPixel);
        for (int y = Math.Max(0, (int)row - reach); y < Math.Min(view.Camera.Height, row + reach); y++)
        {
            for (int x = Math.Max(0, (int)column - reach); x < Math.Min(view.Camera.Width, column + reach); x++)
                DrawPixel(ground, x, y, rgb.AsSpan(3 * ((y * view.Camera.Width) + x), 3));
        }
    }

    private void DrawPixel(in GroundProjection ground, int x, int y, Span<byte> pixel)
    {
        int sum = 0;
        for (int i = 0; i < Samples * Samples; i++)
        {
            double column = x - 0.5 + (((i % Samples) + 0.5) / Samples);
            double row = y - 0.5 + (((i / Samples) + 0.5) / Samples);
            Assert.True(ground.TryProjectToGround(column, row, out Rabit.Geodesy.NedPosition place));
            sum += GreyAt(place.East - East, North - place.North) ?? pixel[0];
        }

        pixel.Fill((byte)(sum / (Samples * Samples)));
    }

    // Null beside the paper.
    private byte? GreyAt(double right, double down)
    {
        double cell = sideMetres / Cells;
        (int column, int row) = ((int)Math.Floor((right / cell) + 4), (int)Math.Floor((down / cell) + 4));
        if (column < -1 || column > Cells || row < -1 || row > Cells)
            return null;
        if (column < 0 || column >= Cells || row < 0 || row >= Cells)
            return White;
        if (column is 0 or Cells - 1 || row is 0 or Cells - 1)
            return Black;
        return ((Code >> (35 - ((row - 1) * 6) - (column - 1))) & 1) != 0 ? White : Black;
    }

}
