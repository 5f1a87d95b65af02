using System;
using System.Collections.Immutable;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Where the middle of a target lies of which the border of the picture cuts a part off. A detector gives the middle of
/// what is seen; how far the target goes on beyond the border is known by the sizes and aspects of its class alone.
/// </summary>
internal static class CutTarget
{
    // How far from the border a box that it cuts may seem to end: the centre is that of the form, not that of the box.
    private const double Slack = 1;
    private const double SlackOfSide = 0.2;

    // Of a square that stands on its corner, the box is so much wider than its side: in the mean of all directions.
    private const double BoxOfSide = 1.2;

    // Of its box: what is turned, and a cross, has its middle elsewhere along the border than what is seen of it.
    private const double FormSigma = 0.03;

    /// <summary>
    /// The same with the middle and the box of the whole, and a covariance with what is not known of that.
    /// </summary>
    /// <param name="seen">What was detected, valid.</param>
    /// <param name="input">Of the picture.</param>
    public static TargetDetection Whole(in TargetDetection seen, in DetectorInput input)
    {
        TargetDetection whole = seen;
        if (!input.GroundScale.TryAt(seen.CentreX, seen.CentreY, out GroundScale scale)
            || Find(input.Classes, seen.Class) is not { } target)
            return whole;
        double pixel = Math.Sqrt(scale.PixelArea);
        int across = SideOfBorder(seen.CentreX, seen.WidthPixels, input.Width);
        int down = SideOfBorder(seen.CentreY, seen.HeightPixels, input.Height);
        (double offX, double varianceX) = Beyond(
            across, seen.WidthPixels, down == 0 ? seen.HeightPixels : null, target, pixel);
        (double offY, double varianceY) = Beyond(
            down, seen.HeightPixels, across == 0 ? seen.WidthPixels : null, target, pixel);
        whole.CentreX = Within(seen.CentreX + offX, input.Width, ref varianceX);
        whole.CentreY = Within(seen.CentreY + offY, input.Height, ref varianceY);
        whole.WidthPixels += 2 * Math.Abs(offX);
        whole.HeightPixels += 2 * Math.Abs(offY);
        PixelCovariance own = seen.Covariance;
        double form = FormSigma * FormSigma * seen.WidthPixels * seen.HeightPixels;
        whole.Covariance = new PixelCovariance(
            own.ColumnColumn + form + varianceX, own.ColumnRow, own.RowRow + form + varianceY);
        return whole;
    }

    private static TargetClass? Find(ImmutableArray<TargetClass> classes, TargetClassName name)
    {
        foreach (TargetClass one in classes)
        {
            if (one.Name == name)
                return one;
        }

        return null;
    }

    // -1 where it goes on beyond the first column or row, 1 beyond the last, 0 where it does not.
    private static int SideOfBorder(double centre, double extent, int size)
    {
        double slack = Slack + (SlackOfSide * extent);
        return centre - (extent / 2) + 0.5 < slack ? -1
            : size - 0.5 - centre - (extent / 2) < slack ? 1
            : 0;
    }

    // By the box: any extent that the class may have, and that is not too long or short for the other one, where all
    // of that is seen.
    private static (double Off, double Variance) Beyond(
        int side, double seen, double? other, TargetClass target, double pixel)
    {
        if (side == 0)
            return (0, 0);
        double root = Math.Sqrt(target.MaxAspect);
        double least = target.MinSideMetres / root / pixel;
        double most = BoxOfSide * target.MaxSideMetres * root / pixel;
        if (other is { } whole)
            (least, most) = (Math.Max(least, whole / target.MaxAspect), Math.Min(most, whole * target.MaxAspect));
        least = Math.Max(least, seen);
        most = Math.Max(least, most);
        double hidden = ((least + most) / 2) - seen;
        return (side * hidden / 2, (most - least) * (most - least) / 48);
    }

    // A report lies in its picture. What is beyond counts as uncertain.
    private static double Within(double place, int size, ref double variance)
    {
        double within = Math.Max(0, Math.Min(size - 1, place));
        variance += (within - place) * (within - place);
        return within;
    }
}
