using System;
using System.Collections.Immutable;
using System.Linq;
using System.Runtime.InteropServices;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The default detector: finds squares of the colours and sizes of the declared classes, by their form on the ground.
/// Fixed memory, no allocation; one thread at a time.
/// </summary>
/// <example>
/// A picture of 640 x 480 from 40 m above, searched without the rest of Image Processing:
/// <code>
/// var detector = new ColourTargetDetector(TargetClass.Defaults);
/// var found = new TargetDetection[16];
/// var input = new DetectorInput(pixels, 640, 480, TargetClass.Defaults, PictureGroundScale.Uniform(0.075));
/// int count = detector.Detect(input, found).Count;
/// </code>
/// </example>
public sealed class ColourTargetDetector : ITargetDetector
{
    /// <summary>How many classes it can distinguish.</summary>
    public const int MaxClasses = 32;

    internal const string TooManySpots = "the picture shows too many coloured spots to be searched";

    // A smaller blob cannot have the smallest side in pixels that the options allow (4 and more), even at its edges.
    private const int MinPixels = 4;

    // The lens may bend the middle of the picture a little more than its corners.
    private const double SlackForCorners = 1.5;

    private readonly ImmutableArray<TargetClass> _classes;
    private readonly ColourTable _colours;
    private readonly BlobFinder _finder = new();
    private readonly BlobMeasure _measure = new();
    private readonly TargetGates _gates;
    private readonly PixelCovariance _covariance;
    private byte[] _copy = [];
    private double _maxPixelArea;   // of the picture, square metres on the ground

    /// <summary>Makes the detector.</summary>
    /// <param name="classes">
    /// All classes that it shall distinguish, each with a colour: also those that are not searched for, so that a
    /// colour between two is taken for the nearer one.
    /// </param>
    /// <param name="options">What else a target is like; null for the defaults.</param>
    /// <param name="centreSigmaPixels">How uncertain a centre is, one standard deviation per axis, pixels.</param>
    /// <exception cref="ArgumentException">
    /// A class has no colour, there are too many, or options are out of their range.
    /// </exception>
    public ColourTargetDetector(
        ImmutableArray<TargetClass> classes, ColourDetectorOptions? options = null, double centreSigmaPixels = 0.5)
    {
        options = options?.Copy() ?? new ColourDetectorOptions();
        string[] faults = TargetClass.FindFaults(classes).Concat(options.FindFaults()).ToArray();
        if (faults.Length == 0)
            faults = FindColourFaults(classes).ToArray();
        if (faults.Length > 0)
            throw new ArgumentException("Colour detector: " + string.Join("; ", faults) + ".", nameof(classes));
        _classes = classes;
        _colours = new ColourTable(classes.Select(c => c.Colour!).ToArray());
        _gates = new TargetGates(options);
        _covariance = PixelCovariance.FromSigma(centreSigmaPixels);
    }

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (input.Format != PixelFormat.Rgb24)
            return DetectorResult.NotSearched(DetectorResult.NoColourPicture);
        byte[] pixels = ArrayOf(input.Pixels);
        _colours.Select(BitsOf(input.Classes));
        if (!_finder.TryFind(pixels, input.Width, input.Height, _colours))
            return DetectorResult.NotSearched(TooManySpots);
        _measure.SetPicture(pixels, input.Width, input.Height, _colours);
        _maxPixelArea = MaxPixelArea(input);
        (int count, int dropped) = (0, 0);
        foreach (ref readonly Blob blob in _finder.Blobs)
        {
            if (TryDetect(blob, input.GroundScale, out TargetDetection detection))
                DetectionOrder.Insert(detection, detections, ref count, ref dropped);
        }

        return DetectorResult.Found(count, dropped);
    }

    internal static System.Collections.Generic.IEnumerable<string> FindColourFaults(ImmutableArray<TargetClass> classes)
    {
        if (classes.Length > MaxClasses)
            yield return $"there are {classes.Length} target classes; the colour detector takes at most {MaxClasses}";
        foreach (TargetClass targetClass in classes.Where(c => c is not null && c.Colour is null))
            yield return $"target class {targetClass.Name} has no colour, which the colour detector needs";
    }

    // A pixel reaches furthest on the ground at one of the corners: what is too small there is too small anywhere.
    private static double MaxPixelArea(in DetectorInput input)
    {
        double max = 0;
        for (int corner = 0; corner < 4; corner++)
        {
            if (!input.GroundScale.TryAt(
                corner % 2 * (input.Width - 1), corner / 2 * (input.Height - 1), out GroundScale scale))
                return double.PositiveInfinity;
            max = Math.Max(max, scale.PixelArea);
        }

        return max;
    }

    // The pixels at the edge, which are half ground, may be missing: of a small target that is most of its area.
    private static bool IsTooSmall(in Blob blob, double pixelArea, TargetClass target)
        => Math.Sqrt(blob.Pixels * pixelArea) < target.MinSideMetres / 2;

    // What costs least comes first: a meadow may have thousands of coloured spots.
    private bool TryDetect(in Blob blob, in PictureGroundScale ground, out TargetDetection detection)
    {
        detection = default;
        TargetClass target = _classes[blob.Class - 1];
        if (blob.Pixels < MinPixels || IsTooSmall(blob, SlackForCorners * _maxPixelArea, target)
            || _measure.TouchesBorder(blob))
            return false;
        if (!ground.TryAt((blob.Left + blob.Right) / 2.0, (blob.Top + blob.Bottom) / 2.0, out GroundScale scale)
            || IsTooSmall(blob, scale.PixelArea, target)
            || Math.Sqrt(blob.Pixels * scale.PixelArea) > target.MaxSideMetres
            || !_measure.TryMeasure(blob, out BlobShape shape))
            return false;
        double score = _gates.Score(shape, scale, target);
        if (score <= 0)
            return false;
        detection.Class = target.Name;
        (detection.CentreX, detection.CentreY) = (shape.CentreX, shape.CentreY);
        (detection.WidthPixels, detection.HeightPixels) = (blob.Right - blob.Left + 1, blob.Bottom - blob.Top + 1);
        detection.SideMetres = BlobOnGround.SideMetres(shape, scale);
        detection.Score = score;
        detection.Covariance = _covariance;
        return true;
    }

    private uint BitsOf(ImmutableArray<TargetClass> wanted)
    {
        uint bits = 0;
        for (int i = 0; i < _classes.Length; i++)
        {
            foreach (TargetClass one in wanted)
            {
                if (one.Name == _classes[i].Name)
                    bits |= 1u << i;
            }
        }

        return bits;
    }

    // Image Processing's buffers begin at the start of an array; others are copied.
    private byte[] ArrayOf(ReadOnlyMemory<byte> pixels)
    {
        if (MemoryMarshal.TryGetArray(pixels, out ArraySegment<byte> segment) && segment.Offset == 0)
            return segment.Array!;
        if (_copy.Length < pixels.Length)
            _copy = new byte[pixels.Length];
        pixels.CopyTo(_copy);
        return _copy;
    }
}
