using System.Text.Json;

namespace VisionBench;

/// <summary>Something that looks like a target and is none.</summary>
internal sealed class ListedDistractor
{
    public ListedDistractor(JsonElement json)
    {
        Kind = json.TextOf("kind");
        double[] centre = json.NumbersOf("center_px", 2);
        (X, Y) = (centre[0], centre[1]);
        Size = json.NumberOf("size_px");
    }

    public string Kind { get; }

    public double X { get; }

    public double Y { get; }

    /// <summary>Pixels.</summary>
    public double Size { get; }

    public bool Covers(double x, double y)
    {
        double reach = (0.75 * Size) + 3;
        return ((x - X) * (x - X)) + ((y - Y) * (y - Y)) <= reach * reach;
    }
}
