using System;
using System.Collections.Immutable;
using System.Runtime.InteropServices;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds what is warmer than the ground around it in 16-bit pictures of a thermal camera
/// (<see cref="PixelFormat.Grey16"/>), as persons: by contrast, size and form on the ground, in metres. The ground is
/// that of each picture, so that a step of the camera's calibration or gain does not matter. No allocation after the
/// first picture; one thread at a time.
/// </summary>
/// <example>
/// <code>
/// ImmutableArray&lt;TargetClass&gt; classes =
/// [
///     new TargetClass("person")
///     {
///         HotSpot = new HotSpotTarget { MinContrastCounts = 40 }, MinSideMetres = 0.4, MaxSideMetres = 1.3,
///         MaxAspect = 4.5,
///     },
/// ];
/// var detector = new HotSpotTargetDetector(classes);
/// </code>
/// </example>
public sealed class HotSpotTargetDetector : ITargetDetector
{
    internal const string NoThermalPicture = "hot spots are searched for in 16-bit pictures only, and this is none";
    internal const string TooManySpots = "the picture shows too many warm spots to be searched";

    // Spots smaller than that in the picture have no size that could be measured: only an upper one.
    private const double MinMeasuredPixels = 4;

    // The lens spreads what is small, which makes its area larger: by so much, pixels.
    private const double SpreadPixels = 2;

    // What no model of the sensor and the lens says of a centre, pixels.
    private const double ResidualSigma = 0.07;

    // Where the end of the range hides which part is the warmest, by the side of the spot.
    private const double SaturatedSigma = 0.08;

    // Of its outline, which the lens blurs, for its direction, pixels.
    private const double EdgeSigma = 0.2;

    // Of a filled rectangle area = 12 times both spreads; of a ring or an angle much less.
    private const double RectangleFactor = 12;
    private const double MinFill = 0.4;
    private const double MaxAspectSlack = 1.2;

    private readonly ImmutableArray<TargetClass> _classes;
    private readonly HotSpotFinder _finder = new();

    /// <summary>Makes the detector.</summary>
    /// <param name="classes">The classes that it is to find, each a hot spot.</param>
    /// <exception cref="ArgumentException">A class is no hot spot, or says what cannot be.</exception>
    public HotSpotTargetDetector(ImmutableArray<TargetClass> classes)
    {
        DetectorClasses.Demand(classes, "hot spot", c => c.HotSpot is not null, nameof(classes));
        _classes = classes;
    }

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (input.Format != PixelFormat.Grey16)
            return DetectorResult.NotSearched(NoThermalPicture);
        HotSpotLimits limits = LimitsFor(input, out double pixelSide);
        if (pixelSide <= 0)
            return DetectorResult.Found(0);
        ReadOnlySpan<ushort> pixels = MemoryMarshal.Cast<byte, ushort>(input.Pixels.Span);
        ReadOnlySpan<HotSpot> spots = _finder.Find(pixels, input.Width, input.Height, limits);
        if (_finder.Dropped > 0)
            return DetectorResult.NotSearched(TooManySpots);
        (int count, int dropped) = (0, 0);
        foreach (ref readonly HotSpot spot in spots)
        {
            if (TryDetect(spot, input, out TargetDetection detection))
                DetectionOrder.Insert(detection, detections, ref count, ref dropped);
        }

        return DetectorResult.Found(count, dropped);
    }

    // The least of all wanted classes; each is judged by its own afterwards.
    private HotSpotLimits LimitsFor(in DetectorInput input, out double pixelSide)
    {
        pixelSide = FinestPixel(input);
        var limits = new HotSpotLimits { MinContrast = double.MaxValue, MinSigmas = double.MaxValue };
        bool isAny = false;
        foreach (TargetClass one in _classes)
        {
            if (!IsWanted(one.Name, input.Classes))
                continue;
            isAny = true;
            limits.MinContrast = Math.Min(limits.MinContrast, one.HotSpot!.MinContrastCounts);
            limits.MinSigmas = Math.Min(limits.MinSigmas, one.HotSpot.MinSigmas);
            limits.MaxSide = Math.Max(
                limits.MaxSide, one.MaxSideMetres * Math.Sqrt(one.MaxAspect) / Math.Max(pixelSide, 1e-6));
        }

        if (!isAny)
            pixelSide = 0;
        return limits;
    }

    private static double FinestPixel(in DetectorInput input)
    {
        double finest = double.MaxValue;
        for (int i = 0; i < 5; i++)
        {
            (double column, double row) = i == 4
                ? ((input.Width - 1) / 2.0, (input.Height - 1) / 2.0)
                : (i % 2 * (input.Width - 1.0), i / 2 * (input.Height - 1.0));
            if (input.GroundScale.TryAt(column, row, out GroundScale scale))
                finest = Math.Min(finest, Math.Sqrt(scale.PixelArea));
        }

        return finest < double.MaxValue ? finest : 0;
    }

    private static bool IsWanted(TargetClassName name, ImmutableArray<TargetClass> wanted)
    {
        foreach (TargetClass one in wanted)
        {
            if (one.Name == name)
                return true;
        }

        return false;
    }

    private bool TryDetect(in HotSpot spot, in DetectorInput input, out TargetDetection detection)
    {
        detection = default;
        bool isCut = spot.Left == 0 || spot.Top == 0
            || spot.Right == input.Width - 1 || spot.Bottom == input.Height - 1;
        if (isCut || !input.GroundScale.TryAt(spot.CentreX, spot.CentreY, out GroundScale scale))
            return false;
        double side = Math.Sqrt(Math.Max(spot.Area - SpreadPixels, spot.Area / 2) * scale.PixelArea);
        TargetClass? best = null;
        double bestScore = 0;
        foreach (TargetClass one in _classes)
        {
            double score = IsWanted(one.Name, input.Classes) ? Score(spot, side, scale, one) : 0;
            if (score > bestScore)
                (best, bestScore) = (one, score);
        }

        if (best is null)
            return false;
        detection.Class = best.Name;
        (detection.CentreX, detection.CentreY) = (spot.CentreX, spot.CentreY);
        (detection.WidthPixels, detection.HeightPixels) = (spot.Right - spot.Left + 1, spot.Bottom - spot.Top + 1);
        detection.SideMetres = side;
        detection.Score = bestScore;
        if (spot.Area >= MinMeasuredPixels && spot.SaturatedPixels == 0)
            detection.Bearing = BlobOnGround.BearingOf(ShapeOf(spot), scale, EdgeSigma);
        double residual = ResidualSigma * ResidualSigma;
        if (spot.SaturatedPixels > 0)
            residual += SaturatedSigma * SaturatedSigma * spot.Area;
        detection.Covariance = new PixelCovariance(
            spot.VarianceX + residual, spot.CovarianceXY, spot.VarianceY + residual);
        return true;
    }

    // 0 where it is none of the class; else by how clear it is, and how near its size is to the middle of the range.
    private static double Score(in HotSpot spot, double side, in GroundScale scale, TargetClass target)
    {
        double sigmas = spot.Contrast / spot.Noise;
        HotSpotTarget hot = target.HotSpot!;
        if (sigmas < hot.MinSigmas || spot.Contrast < hot.MinContrastCounts || side > target.MaxSideMetres)
            return 0;

        // What is smaller than some pixels may be any small thing, but not a large one.
        bool isMeasured = spot.Area >= MinMeasuredPixels;
        if (side < target.MinSideMetres
            && (isMeasured || Math.Sqrt(MinMeasuredPixels * scale.PixelArea) < target.MinSideMetres))
            return 0;
        if (isMeasured && !HasForm(spot, side, scale, target))
            return 0;
        double size = isMeasured
            ? Math.Log(side / Math.Sqrt(target.MinSideMetres * target.MaxSideMetres))
                / Math.Log(Math.Sqrt(target.MaxSideMetres / target.MinSideMetres))
            : 1;
        double clear = 1 - Math.Exp(-sigmas / (2 * hot.MinSigmas));
        return clear * Math.Exp(-0.5 * size * size);
    }

    private static BlobShape ShapeOf(in HotSpot spot) => new()
    {
        MomentXX = spot.MomentXX,
        MomentXY = spot.MomentXY,
        MomentYY = spot.MomentYY,
    };

    private static bool HasForm(in HotSpot spot, double side, in GroundScale scale, TargetClass target)
    {
        // The blur of the lens makes what is small rounder than it is: only large ones have a smallest aspect.
        (double longSpread, double shortSpread) = BlobOnGround.SpreadMetres(ShapeOf(spot), scale);
        double pixel = Math.Sqrt(scale.PixelArea);
        double aspect = longSpread / Math.Max(shortSpread, 0.2 * pixel);
        if (aspect > target.MaxAspect * MaxAspectSlack)
            return false;
        bool isLarge = side > 6 * pixel;
        double fill = side * side / (RectangleFactor * longSpread * Math.Max(shortSpread, 0.2 * pixel));
        return !isLarge || (aspect >= target.MinAspect / MaxAspectSlack && fill >= MinFill);
    }
}
