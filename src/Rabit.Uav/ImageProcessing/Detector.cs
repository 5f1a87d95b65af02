using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Finds squares of the colours of targets in a picture. Fixed memory; for one thread.</summary>
internal sealed class Detector(ImageProcessingOptions options)
{
    // A smaller blob cannot have the least size in pixels that the options allow (4 and more), even at its edges.
    private const int MinPixels = 4;

    // The lens may bend the middle of the picture a little more than its corners.
    private const double SlackForCorners = 1.5;

    private readonly ColourTable _colours = new(NominalColours.Ranges);
    private readonly BlobFinder _finder = new();
    private readonly BlobMeasure _measure = new();
    private readonly TargetGates _gates = new(options);
    private readonly Detection[] _found = new Detection[options.MaxReportsPerPicture];
    private int _count;
    private double _largestPixelArea;   // of the last picture, square metres on the ground

    /// <summary>What the last picture showed, the surest first.</summary>
    public ReadOnlySpan<Detection> Found => new(_found, 0, _count);

    /// <summary>Targets of the last picture that had no room among those.</summary>
    public int Cut { get; private set; }

    /// <summary>Searches a picture; false if it shows so many coloured spots that it could not be searched.</summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="colours">What is looked for.</param>
    /// <param name="projection">Of this picture to the ground.</param>
    public bool TrySearch(byte[] pixels, int width, int height, TargetColours colours, in GroundProjection projection)
    {
        _count = 0;
        Cut = 0;
        _colours.Select((uint)colours);
        if (!_finder.TryFind(pixels, width, height, _colours))
            return false;
        _measure.SetPicture(pixels, width, height, _colours);
        _largestPixelArea = LargestPixelArea(width, height, projection);
        foreach (ref readonly Blob blob in _finder.Blobs)
            Judge(blob, projection);
        return true;
    }

    // A pixel reaches furthest on the ground at one of the corners: what is too small there is too small anywhere.
    private static double LargestPixelArea(int width, int height, in GroundProjection projection)
    {
        double largest = 0;
        for (int corner = 0; corner < 4; corner++)
        {
            if (!projection.TryScale(corner % 2 * (width - 1), corner / 2 * (height - 1), out GroundScale scale))
                return double.PositiveInfinity;
            largest = Math.Max(largest, scale.PixelArea);
        }

        return largest;
    }

    // What costs least comes first: a meadow may have thousands of coloured spots.
    private void Judge(in Blob blob, in GroundProjection projection)
    {
        if (blob.Pixels < MinPixels || IsTooSmall(blob, SlackForCorners * _largestPixelArea) || _measure.TouchesBorder(blob))
            return;
        if (!projection.TryScale((blob.Left + blob.Right) / 2.0, (blob.Top + blob.Bottom) / 2.0, out GroundScale scale)
            || IsTooSmall(blob, scale.PixelArea) || Math.Sqrt(blob.Pixels * scale.PixelArea) > options.MaxSideMetres
            || !_measure.TryMeasure(blob, out BlobShape shape))
            return;
        double score = _gates.Score(shape, scale, NominalColours.Ranges[blob.Class - 1]);
        if (score <= 0)
            return;
        Put(new Detection
        {
            Colour = (TargetColours)(1 << (blob.Class - 1)),
            CentreX = shape.CentreX,
            CentreY = shape.CentreY,
            SideMetres = BlobOnGround.SideMetres(shape, scale),
            Score = score,
        });
    }

    // The pixels at the edge, which are half ground, may be missing: of a small target that is most of its area.
    private bool IsTooSmall(in Blob blob, double pixelArea) => Math.Sqrt(blob.Pixels * pixelArea) < options.MinSideMetres / 2;

    // In the order of the scores; with equal ones, the one that was found first.
    private void Put(in Detection detection)
    {
        int place = _count;
        while (place > 0 && _found[place - 1].Score < detection.Score)
            place--;
        if (_count == _found.Length)
            Cut++;
        else
            _count++;
        if (place >= _count)
            return;
        for (int i = _count - 1; i > place; i--)
            _found[i] = _found[i - 1];
        _found[place] = detection;
    }
}
