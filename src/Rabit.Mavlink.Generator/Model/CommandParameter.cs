namespace Rabit.Mavlink.Generator.Model;

/// <summary>What one of the seven parameters of a MAV_CMD entry means. What is not given is null.</summary>
/// <param name="Index">1 to 7.</param>
public sealed record CommandParameter(int Index)
{
    /// <summary>Its name.</summary>
    public string? Label { get; init; }

    /// <summary>Unit.</summary>
    public string? Units { get; init; }

    /// <summary>Name of the enum that its values are of.</summary>
    public string? Enum { get; init; }

    /// <summary>Smallest allowed value.</summary>
    public string? MinValue { get; init; }

    /// <summary>Largest allowed value.</summary>
    public string? MaxValue { get; init; }

    /// <summary>The definition's own words.</summary>
    public string? Description { get; init; }
}
