using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds the printed markers of the declared classes, and reports their ids. The default detector uses it for classes
/// with a <see cref="TargetClass.Marker"/>. No allocation once it has seen the fullest picture; one thread at a time.
/// </summary>
/// <remarks>
/// A class that names an id comes before one that takes any of the family. The side on the ground must be within the
/// class's: a small print of the same marker is another thing.
/// </remarks>
/// <example>
/// <code>
/// ImmutableArray&lt;TargetClass&gt; classes =
/// [
///     new TargetClass("pad")
///     {
///         Marker = new TargetMarker(MarkerFamily.AprilTag36h11, 7), MinSideMetres = 0.4, MaxSideMetres = 0.6,
///     },
/// ];
/// var detector = new MarkerTargetDetector(classes);
/// </code>
/// </example>
public sealed class MarkerTargetDetector : ITargetDetector
{
    // Pixels: the direction of none is known without error.
    private const double MinCornerSigma = 0.02;

    private readonly MarkerDetector _detector;
    private byte[] _grey = [];

    /// <summary>Makes the detector.</summary>
    /// <param name="classes">The classes that it is to distinguish, each with a marker.</param>
    /// <exception cref="ArgumentException">A class has no marker, or one that there is not.</exception>
    public MarkerTargetDetector(ImmutableArray<TargetClass> classes)
    {
        DetectorClasses.Demand(classes, "marker", c => c.Marker is not null, nameof(classes));
        _detector = new MarkerDetector(new MarkerDetectorOptions
        {
            Families = classes.Select(c => c.Marker!.Family).Distinct().ToArray(),
        });
    }

    /// <inheritdoc/>
    public DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections)
    {
        if (input.Format != PixelFormat.Rgb24)
            return DetectorResult.NotSearched(DetectorResult.NoColourPicture);
        int size = input.Width * input.Height;
        if (_grey.Length < size)
            _grey = new byte[size];
        GreyPixels.FromRgb(input.Pixels.Span.Slice(0, size * 3), _grey);
        (int count, int dropped) = (0, 0);
        foreach (DetectedMarker marker in _detector.Find(_grey, input.Width, input.Height))
        {
            if (TryDetect(marker, input, out TargetDetection detection))
                DetectionOrder.Insert(detection, detections, ref count, ref dropped);
        }

        return DetectorResult.Found(count, dropped);
    }

    private static bool TryDetect(in DetectedMarker marker, in DetectorInput input, out TargetDetection detection)
    {
        detection = default;
        PicturePoint centre = marker.Corners.Centre;
        if (!input.GroundScale.TryAt(centre.X, centre.Y, out GroundScale scale))
            return false;
        double side = Math.Sqrt(AreaOf(marker.Corners) * scale.PixelArea);
        TargetClass? target = null;
        foreach (TargetClass one in input.Classes)
        {
            if (one.Marker?.Is(marker.Family, marker.Id) != true
                || side < one.MinSideMetres || side > one.MaxSideMetres)
                continue;
            if (target is null || one.Marker.Id is not null)
                target = one;
        }

        if (target is null)
            return false;
        detection.Class = target.Name;
        detection.MarkerId = marker.Id;
        (detection.CentreX, detection.CentreY) = (centre.X, centre.Y);
        SetBox(marker.Corners, input, ref detection);
        detection.SideMetres = side;
        detection.Score = Math.Min(1, marker.Margin);

        // The centre is where the diagonals meet: of four corners in the mean, half of what is uncertain of each.
        detection.Covariance = PixelCovariance.FromSigma(marker.CornerSigmaPixels / 2);
        detection.Bearing = BearingOf(marker, scale, side);
        return true;
    }

    private static void SetBox(in MarkerCorners corners, in DetectorInput input, ref TargetDetection detection)
    {
        (double left, double right) = (double.MaxValue, double.MinValue);
        (double top, double bottom) = (double.MaxValue, double.MinValue);
        for (int i = 0; i < 4; i++)
        {
            (left, right) = (Math.Min(left, corners[i].X), Math.Max(right, corners[i].X));
            (top, bottom) = (Math.Min(top, corners[i].Y), Math.Max(bottom, corners[i].Y));
        }

        detection.WidthPixels = Math.Min(right - left, input.Width);
        detection.HeightPixels = Math.Min(bottom - top, input.Height);
    }

    // From the lower edge to the upper one. The middle of an edge is more certain than a corner, by the root of two.
    private static TargetBearing BearingOf(in DetectedMarker marker, in GroundScale scale, double side)
    {
        MarkerCorners q = marker.Corners;
        double column = q.TopLeft.X + q.TopRight.X - q.BottomLeft.X - q.BottomRight.X;
        double row = q.TopLeft.Y + q.TopRight.Y - q.BottomLeft.Y - q.BottomRight.Y;
        double north = (scale.NorthByColumn * column) + (scale.NorthByRow * row);
        double east = (scale.EastByColumn * column) + (scale.EastByRow * row);
        double sigma = Math.Max(MinCornerSigma, marker.CornerSigmaPixels) * Math.Sqrt(scale.PixelArea) / side;
        return new TargetBearing(
            Angle.FromRadians(Math.Atan2(east, north)), Angle.FromRadians(sigma), BearingSymmetry.None);
    }

    private static double AreaOf(in MarkerCorners q)
        => (((q.BottomRight.X - q.TopLeft.X) * (q.BottomLeft.Y - q.TopRight.Y))
            - ((q.BottomRight.Y - q.TopLeft.Y) * (q.BottomLeft.X - q.TopRight.X))) / 2;
}
