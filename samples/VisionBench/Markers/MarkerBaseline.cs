using System.Globalization;

namespace VisionBench;

/// <summary>
/// The figures of the reference for the markers of one set, as text: OpenCV with settings for small markers, which find
/// the most.
/// </summary>
internal sealed class MarkerBaseline
{
    private const string Setting = "small-marker";

    private MarkerBaseline(BaselineField field)
    {
        Found = $"{field.Of("found").Integer()}/{field.Of("of").Integer()}";
        Wrong = field.Of("wrong_ids").Integer().ToString(CultureInfo.InvariantCulture);
        CornerRms = field.Of("corner_rms_px").Number().ToString("0.00", CultureInfo.InvariantCulture);
    }

    public string Found { get; }

    public string Wrong { get; }

    public string CornerRms { get; }

    /// <summary>Null where there is none beside the set.</summary>
    /// <exception cref="System.FormatException">It cannot be understood; names file and field.</exception>
    public static MarkerBaseline? Load(string folder)
        => BaselineField.OfSet(folder) is { } figures
            && (figures.Find("markers") ?? figures).Find(Setting) is { } found
            ? new MarkerBaseline(found)
            : null;
}
