using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Paints the rectangles on the ground over it, each pixel by the part of it that they cover: 4 x 4 rays to a pixel,
/// from two poses within the exposure, so that a panel is smeared as the camera moves and turns. (The ground is
/// not: it has no sharp edges.) Allocates nothing.
/// </summary>
internal sealed class SheetPainter(LensRays lens, IEnumerable<SimulatedTarget> sheets)
{
    private const int RaysPerSide = 4;
    private const int RaysPerPose = RaysPerSide * RaysPerSide;

    private readonly SimulatedTarget[] _sheets = sheets.ToArray();

    public void Paint(in CameraPose first, in CameraPose second, byte[] pixels)
    {
        if (first.Height < GroundPainter.MinHeight || second.Height < GroundPainter.MinHeight)
            return;
        foreach (SimulatedTarget sheet in _sheets)
        {
            bool isInFirst = PixelBox.TryFind(sheet, first, lens, out PixelBox box);
            bool isInSecond = PixelBox.TryFind(sheet, second, lens, out PixelBox other);
            if (isInFirst || isInSecond)
            {
                box = !isInFirst ? other : isInSecond ? box.With(other) : box;
                (SheetView early, SheetView late) = (new SheetView(sheet, first), new SheetView(sheet, second));
                if (sheet.Pattern is { } pattern)
                    Paint(pattern, early, late, box, pixels);
                else
                    Paint(sheet.Surface, early, late, box, pixels);
            }
        }
    }

    private void Paint(SurfaceColour surface, in SheetView first, in SheetView second, PixelBox box, byte[] pixels)
    {
        for (int v = box.Top; v <= box.Bottom; v++)
        {
            for (int u = box.Left; u <= box.Right; u++)
            {
                var cone = new PixelCone(lens, u, v);
                int covered = RaysIn(first, cone) + RaysIn(second, cone);
                if (covered > 0)
                    Cover(pixels, ((v * lens.Width) + u) * 3, surface, covered);
            }
        }
    }

    private void Paint(SurfacePattern pattern, in SheetView first, in SheetView second, PixelBox box, byte[] pixels)
    {
        for (int v = box.Top; v <= box.Bottom; v++)
        {
            for (int u = box.Left; u <= box.Right; u++)
            {
                var cone = new PixelCone(lens, u, v);
                if (!IsMissed(first, cone) || !IsMissed(second, cone))
                {
                    var sum = default(ColourSum);
                    Add(pattern, first, cone, ref sum);
                    Add(pattern, second, cone, ref sum);
                    sum.Cover(pixels, ((v * lens.Width) + u) * 3, 2 * RaysPerPose);
                }
            }
        }
    }

    private static bool IsMissed(in SheetView view, in PixelCone cone)
        => (view.SidesMissed(cone.X(-0.5, -0.5), cone.Y(-0.5, -0.5))
            & view.SidesMissed(cone.X(0.5, -0.5), cone.Y(0.5, -0.5))
            & view.SidesMissed(cone.X(-0.5, 0.5), cone.Y(-0.5, 0.5))
            & view.SidesMissed(cone.X(0.5, 0.5), cone.Y(0.5, 0.5))) != 0;

    private static void Add(SurfacePattern pattern, in SheetView view, in PixelCone cone, ref ColourSum sum)
    {
        for (int ray = 0; ray < RaysPerPose; ray++)
        {
            double du = (((ray % RaysPerSide) + 0.5) / RaysPerSide) - 0.5;
            double dv = (((ray / RaysPerSide) + 0.5) / RaysPerSide) - 0.5;
            if (view.TryLocate(cone.X(du, dv), cone.Y(du, dv), out double back, out double right)
                && pattern.TryAt(back, right, out SurfaceColour colour))
                sum.Add(colour);
        }
    }

    // The picture of a rectangle has straight edges within a pixel: a pixel whose corners are all inside, or all
    // beyond one side, needs no closer look.
    private static int RaysIn(in SheetView view, in PixelCone cone)
    {
        int missed = view.SidesMissed(cone.X(-0.5, -0.5), cone.Y(-0.5, -0.5));
        int upperRight = view.SidesMissed(cone.X(0.5, -0.5), cone.Y(0.5, -0.5));
        int lowerLeft = view.SidesMissed(cone.X(-0.5, 0.5), cone.Y(-0.5, 0.5));
        int lowerRight = view.SidesMissed(cone.X(0.5, 0.5), cone.Y(0.5, 0.5));
        if ((missed | upperRight | lowerLeft | lowerRight) == 0)
            return RaysPerPose;
        if ((missed & upperRight & lowerLeft & lowerRight) != 0)
            return 0;

        int inside = 0;
        for (int row = 0; row < RaysPerSide; row++)
        {
            for (int column = 0; column < RaysPerSide; column++)
            {
                double du = ((column + 0.5) / RaysPerSide) - 0.5;
                double dv = ((row + 0.5) / RaysPerSide) - 0.5;
                if (view.Contains(cone.X(du, dv), cone.Y(du, dv)))
                    inside++;
            }
        }

        return inside;
    }

    private static void Cover(byte[] pixels, int at, SurfaceColour surface, int covered)
    {
        const int All = 2 * RaysPerPose;
        pixels[at] = (byte)(((pixels[at] * (All - covered)) + (surface.Red * covered)) / All);
        pixels[at + 1] = (byte)(((pixels[at + 1] * (All - covered)) + (surface.Green * covered)) / All);
        pixels[at + 2] = (byte)(((pixels[at + 2] * (All - covered)) + (surface.Blue * covered)) / All);
    }
}
