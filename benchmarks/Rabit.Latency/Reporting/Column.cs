using System.Globalization;

namespace Rabit.Latency.Reporting;

/// <summary>A column of figures.</summary>
/// <param name="name">What it is, with its unit.</param>
/// <param name="format">How a figure is written.</param>
/// <param name="hasRatio">Whether its ratio to the limit's figure stands beside it.</param>
/// <param name="isGrowth">
/// Whether it is what something added that cannot be taken away. A figure below zero then says only that more of
/// something else went meanwhile.
/// </param>
internal sealed class Column(string name, string format = "0.0", bool hasRatio = true, bool isGrowth = false)
{
    public string Name => name;

    public bool HasRatio => hasRatio;

    /// <summary>The figure as text.</summary>
    public string Text(double figure)
        => IsMeasured(figure) ? figure.ToString(format, CultureInfo.InvariantCulture) : "not measurable";

    /// <summary>Whether the figure says something.</summary>
    public bool IsMeasured(double figure) => !isGrowth || figure >= 0;
}
