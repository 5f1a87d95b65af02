using System;
using System.Linq;

namespace Rabit.Vision;

/// <summary>
/// Finds square markers in grey pictures: ArUco's DICT_4X4_50 and AprilTag's 36h11, upright as OpenCV draws them. Keeps
/// its memory from picture to picture and allocates nothing once it has seen the fullest; for one thread.
/// </summary>
/// <remarks>
/// <para>
/// Pixels darker than their surroundings are joined to regions; of a region whose convex outline is a quadrilateral the
/// sides are moved to where the grey changes most, the black ring and the white around it are checked, and the cells
/// are read. White areas look larger than they are (blur, the curve of the camera, clipped light): by how much, the
/// edges between the cells show, and the corners are corrected for it.
/// </para>
/// <para>
/// A marker needs a white margin of about a cell. It is not found where it touches the edge of the picture, where
/// something hides a part of its ring, or as a mirror image. In 4 x 4 no cell is corrected, in 36h11 two are: an
/// ArUco id with a wrong cell is more often something else. The ids 10, 17, 34 and 37 of DICT_4X4_50 are what squares
/// in squares and frames behind others look like: they need cells of 4 pixels and a clear reading. The others are the
/// better choice for what is seen from afar.
/// </para>
/// </remarks>
/// <example>
/// <code>
/// var detector = new MarkerDetector();              // kept from picture to picture
/// byte[] grey = new byte[picture.Width * picture.Height];
/// GreyPixels.FromRgb(picture.Pixels, grey);
/// foreach (DetectedMarker marker in detector.Find(grey, picture.Width, picture.Height))
///     Console.WriteLine($"{marker.Family} {marker.Id} at {marker.Corners.Centre}");
/// </code>
/// </example>
public sealed class MarkerDetector
{
    private readonly MarkerDetectorOptions _options;
    private readonly MarkerDictionary[] _dictionaries;
    private readonly LocalThreshold _threshold = new();
    private readonly DarkRegions _regions = new();
    private readonly RegionOutline _outline = new();
    private readonly MarkerReader _reader = new();
    private DetectedMarker[] _found = new DetectedMarker[16];
    private int _count;

    /// <summary>Makes a detector.</summary>
    /// <param name="options">What to look for, read now; null for the defaults.</param>
    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    public MarkerDetector(MarkerDetectorOptions? options = null)
    {
        _options = options?.Copy() ?? new MarkerDetectorOptions();
        string[] faults = _options.FindFaults().ToArray();
        if (faults.Length > 0)
            throw new ArgumentException("Marker detector: " + string.Join("; ", faults) + ".", nameof(options));
        _dictionaries = _options.Families.Distinct().Select(MarkerDictionary.Of).ToArray();
    }

    /// <summary>Finds all markers of a picture.</summary>
    /// <param name="grey">One byte a pixel, row by row from the top left, without padding.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <returns>The markers, from the top of the picture; valid until the next call.</returns>
    /// <exception cref="ArgumentException">The buffer is too small for the size, or the size is none.</exception>
    public ReadOnlySpan<DetectedMarker> Find(ReadOnlySpan<byte> grey, int width, int height)
    {
        if (width < 1 || height < 1 || grey.Length / width < height)
        {
            throw new ArgumentException(
                $"A buffer of {grey.Length} bytes does not hold a grey picture of {width} x {height} pixels.",
                nameof(grey));
        }

        _count = 0;
        if (Math.Min(width, height) < _options.MinSidePixels)
            return default;
        _threshold.Compute(grey, width, height, _options.MinContrast);
        _regions.Find(grey, width, height, _threshold);
        _outline.Collect(_regions, _options.MinSidePixels, width, height);
        var view = new GreyView(grey, width, height);
        for (int i = 0; i < _outline.Count; i++)
        {
            if (QuadFitter.TryFit(_outline.HullOf(i), _options.MinSidePixels, out MarkerCorners quad))
                Read(view, quad);
        }

        return new ReadOnlySpan<DetectedMarker>(_found, 0, _count);
    }

    private void Read(in GreyView view, MarkerCorners quad)
    {
        // The second time from nearer: the samples then lie across the side.
        double minRise = _options.MinContrast / 2.0;
        if (!EdgeRefiner.TryRefine(view, ref quad, minRise, out _)
            || !EdgeRefiner.TryRefine(view, ref quad, minRise, out double roughness)
            || quad.MinSide < _options.MinSidePixels)
            return;
        foreach (MarkerDictionary dictionary in _dictionaries)
        {
            if (!_reader.TryRead(view, quad, dictionary, _options.MinContrast, out DetectedMarker marker))
                continue;
            MarkerCorners corners = marker.Corners;
            double misfit = WhiteGrowth.Correct(
                view, ref corners, dictionary, dictionary.CodeOf(marker.Id), out double growth);
            double cell = corners.MinSide / dictionary.Cells;
            if (misfit > dictionary.Limits.MaxMisfitOf(cell) || growth < dictionary.Limits.MinGrowth * cell
                || (dictionary.IsSimple(marker.Id) && !dictionary.Limits.AcceptsSimple(cell, marker.Margin)))
                continue;
            marker.Corners = corners;
            marker.CornerSigmaPixels = CornerSigma(cell, roughness);
            Add(marker);
        }
    }

    // Measured on generated pictures: below three pixels a cell, edges disturb each other.
    private static double CornerSigma(double cell, double roughness)
    {
        double disturbed = 0.1 + (1 / (cell * cell));
        return Math.Sqrt((disturbed * disturbed) + (roughness * roughness));
    }

    // Twice only where a region lies in another: the clearer reading stays.
    private void Add(in DetectedMarker marker)
    {
        for (int i = 0; i < _count; i++)
        {
            ref DetectedMarker other = ref _found[i];
            if (other.Family != marker.Family || other.Id != marker.Id
                || other.Corners.Centre.DistanceTo(marker.Corners.Centre) > marker.Corners.MinSide / 2)
                continue;
            if (marker.Margin > other.Margin)
                other = marker;
            return;
        }

        if (_count == _found.Length)
            Array.Resize(ref _found, 2 * _count);
        _found[_count++] = marker;
    }
}
