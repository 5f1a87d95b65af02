using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds what looks like templates trained from labelled pictures (<c>rabit train</c>, <see cref="TemplateTrainer"/>),
/// as cars from above at any heading. The ground scale gives their size; where it changes over the picture, parts of
/// about the same scale are searched one after the other, those too coarse for the template not at all. No allocation
/// after the first picture; one thread at a time.
/// </summary>
/// <example>
/// <code>
/// ImmutableArray&lt;TargetClass&gt; classes =
/// [
///     new TargetClass("car")
///     {
///         Template = ObjectTemplate.Load("car.template"), MinSideMetres = 2.4, MaxSideMetres = 3.8,
///     },
/// ];
/// var detector = new TemplateTargetDetector(classes);
/// </code>
/// </example>
public sealed class TemplateTargetDetector : ITargetDetector
{
    internal const string TooCoarse = "the pixels are too coarse on the ground for the templates";

    // How far off the best of the headings that a template is compared at may be, one standard deviation, steps.
    private const double HeadingSteps = 0.5;

    private readonly ImmutableArray<TargetClass> _classes;
    private readonly TemplateScanner[] _scanners;
    private readonly ScaleParts _parts = new();

    /// <summary>Makes the detector.</summary>
    /// <param name="classes">The classes that it is to find, each with a template.</param>
    /// <exception cref="ArgumentException">A class has no template, or is of another size than that.</exception>
    public TemplateTargetDetector(ImmutableArray<TargetClass> classes)
    {
        DetectorClasses.Demand(classes, "template", c => c.Template is not null, nameof(classes));
        _classes = classes;
        _scanners = classes.Select(c => new TemplateScanner(c.Template!)).ToArray();
    }

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (input.Format != PixelFormat.Rgb24)
            return DetectorResult.NotSearched(DetectorResult.NoColourPicture);
        _parts.Find(input.GroundScale, input.Width, input.Height);
        (int count, int dropped) = (0, 0);
        bool isAnySearched = false;
        bool isAnyWanted = false;
        for (int i = 0; i < _classes.Length; i++)
        {
            if (!IsWanted(_classes[i].Name, input.Classes))
                continue;
            isAnyWanted = true;
            if (!Scan(_scanners[i], input))
                continue;
            isAnySearched = true;
            foreach (ref readonly TemplateMatch match in _scanners[i].Finish())
            {
                if (TryDetect(match, _classes[i], input, out TargetDetection detection))
                    DetectionOrder.Insert(detection, detections, ref count, ref dropped);
            }

            dropped += _scanners[i].Dropped;
        }

        return isAnySearched || !isAnyWanted
            ? DetectorResult.Found(count, dropped)
            : DetectorResult.NotSearched(TooCoarse);
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

    private bool Scan(TemplateScanner scanner, in DetectorInput input)
    {
        scanner.Begin(input.Pixels, input.Width, input.Height);
        bool isAny = false;
        foreach (ref readonly ScalePart part in _parts.Found)
            isAny |= scanner.Scan(part.Scale, part.Left, part.Top, part.Right, part.Bottom);
        return isAny;
    }

    private static bool TryDetect(
        in TemplateMatch match, TargetClass target, in DetectorInput input, out TargetDetection detection)
    {
        detection = default;
        if (!input.GroundScale.TryAt(match.CentreX, match.CentreY, out GroundScale scale))
            return false;
        ObjectTemplate template = target.Template!;
        double determinant = (scale.NorthByColumn * scale.EastByRow) - (scale.NorthByRow * scale.EastByColumn);
        (double cos, double sin) = (Trig.Cos(match.HeadingRadians), Trig.Sin(match.HeadingRadians));

        // Pixels for a metre along and across.
        double alongX = ((scale.EastByRow * cos) - (scale.NorthByRow * sin)) / determinant;
        double alongY = ((scale.NorthByColumn * sin) - (scale.EastByColumn * cos)) / determinant;
        double acrossX = ((scale.EastByRow * -sin) - (scale.NorthByRow * cos)) / determinant;
        double acrossY = ((scale.NorthByColumn * cos) + (scale.EastByColumn * sin)) / determinant;
        (double length, double width) = (template.LengthMetres, template.WidthMetres);
        detection.Class = target.Name;
        (detection.CentreX, detection.CentreY) = (match.CentreX, match.CentreY);
        detection.WidthPixels = Math.Min(
            input.Width, (Math.Abs(alongX) * length) + (Math.Abs(acrossX) * width));
        detection.HeightPixels = Math.Min(
            input.Height, (Math.Abs(alongY) * length) + (Math.Abs(acrossY) * width));
        detection.SideMetres = Math.Sqrt(length * width);
        detection.Score = match.Probability;
        detection.Bearing = new TargetBearing(
            Angle.FromRadians(match.HeadingRadians),
            Angle.FromRadians(HeadingSteps * match.HeadingStepRadians), BearingSymmetry.HalfTurn);
        double variance = template.SigmaMetres * template.SigmaMetres;
        detection.Covariance = new PixelCovariance(
            variance * ((alongX * alongX) + (acrossX * acrossX)),
            variance * ((alongX * alongY) + (acrossX * acrossY)),
            variance * ((alongY * alongY) + (acrossY * acrossY)));
        return true;
    }
}
