namespace Rabit.Latency.Reporting;

/// <summary>A column of figures.</summary>
/// <param name="name">What it is, with its unit.</param>
/// <param name="format">How a figure is written.</param>
/// <param name="hasRatio">Whether its ratio to the limit's figure stands beside it.</param>
internal sealed class Column(string name, string format = "0.0", bool hasRatio = true)
{
    public string Name => name;

    public string Format => format;

    public bool HasRatio => hasRatio;
}
