using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds panels of two colours, of black and of white (<see cref="TargetClass.IsPanel"/>): rectangles on the ground of
/// the size of their class, in which both colours are seen, with bare ground around. Also their direction is measured.
/// No allocation after the first picture; one thread at a time.
/// </summary>
/// <example>
/// <code>
/// ImmutableArray&lt;TargetClass&gt; classes =
/// [
///     new TargetClass("chequered")
///     {
///         Colour = new ColourRange(20, 20, 20), SecondColour = new ColourRange(240, 240, 240),
///         MinSideMetres = 0.3, MaxSideMetres = 0.52,
///     },
/// ];
/// var detector = new PanelTargetDetector(classes);
/// </code>
/// </example>
public sealed class PanelTargetDetector : ITargetDetector
{
    internal const string TooMany = "the picture shows too much that may be a panel to be searched";

    private readonly PanelClass[] _classes;
    private readonly PanelFinder _finder = new();
    private readonly PanelChoice _choice = new();
    private readonly OutlineOnGround _onGround = new();
    private readonly PixelArray _pixels = new();

    /// <summary>Makes the detector.</summary>
    /// <param name="classes">The classes that it is to find, each a panel.</param>
    /// <exception cref="ArgumentException">
    /// A class is no panel of that kind, or says what cannot be.
    /// </exception>
    public PanelTargetDetector(ImmutableArray<TargetClass> classes)
    {
        DetectorClasses.Demand(classes, "panel", c => c.IsPanel, nameof(classes));

        // Those of two colours first: a part of one in one of its colours is no panel of that colour.
        _classes = classes.Select(c => new PanelClass(c)).OrderBy(c => c.HasTwoColours ? 0 : 1).ToArray();
    }

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (input.Format != PixelFormat.Rgb24)
            return DetectorResult.NotSearched(DetectorResult.NoColourPicture);
        byte[] pixels = _pixels.Of(input.Pixels);
        PixelSides sides = PixelSides.Of(input);
        _choice.Clear();
        foreach (PanelClass one in _classes)
        {
            if (!one.IsIn(input.Classes) || !one.IsResolved(sides))
                continue;
            ReadOnlySpan<PanelShape> shapes = _finder.Find(
                pixels, input.Width, input.Height, one.Colours, one.LimitsFor(sides));
            if (_finder.Dropped > 0)
                return DetectorResult.NotSearched(TooMany);
            foreach (ref readonly PanelShape shape in shapes)
            {
                if (TryDetect(shape, one, input, out TargetDetection detection)
                    && !_choice.TryAdd(detection, one.HasTwoColours))
                    return DetectorResult.NotSearched(TooMany);
            }
        }

        (int count, int dropped) = (0, 0);
        foreach (ref readonly TargetDetection detection in _choice.Chosen)
            DetectionOrder.Insert(detection, detections, ref count, ref dropped);
        return DetectorResult.Found(count, dropped);
    }

    private bool TryDetect(
        in PanelShape shape, PanelClass panel, in DetectorInput input, out TargetDetection detection)
    {
        detection = default;
        if (shape.TouchesBorder || !input.GroundScale.TryAt(shape.CentreX, shape.CentreY, out GroundScale scale))
            return false;
        double pixel = Math.Sqrt(scale.PixelArea);
        FittedRectangle rectangle = FittedRectangle.Of(
            _onGround.Project(_finder.OutlineOf(shape), shape.CentreX, shape.CentreY, scale), pixel);
        double score = panel.Score(shape, rectangle, pixel);
        if (score <= 0)
            return false;
        detection.Class = panel.Name;
        (detection.CentreX, detection.CentreY) = (shape.CentreX, shape.CentreY);
        (detection.WidthPixels, detection.HeightPixels) = (shape.Width, shape.Height);
        detection.SideMetres = pixel * Math.Sqrt(shape.Area);
        detection.Score = score;
        detection.Bearing = panel.BearingOfPanel(rectangle, pixel);
        detection.Covariance = PanelClass.CovarianceOf(shape);
        return true;
    }
}
