using System;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>One look of one source: what is the same for all its points. A plain value.</summary>
/// <param name="Time">When.</param>
/// <param name="Source">Of which vehicle.</param>
/// <param name="DetectionProbability">How likely a target that it shows is reported, above 0 and below 1.</param>
internal readonly record struct Scan(TimeSpan Time, byte Source, double DetectionProbability)
{
    /// <summary>
    /// How much ground it shows, square metres; 0 where that is not known: it then says nothing on the clutter.
    /// </summary>
    public double AreaSquareMetres { get; init; }

    /// <summary>What ground it shows; unknown where a target without a report is no miss.</summary>
    public Footprint Footprint { get; init; }

    /// <summary>Whether it shows every target there is; needs no footprint then.</summary>
    public bool ShowsAll { get; init; }
}
