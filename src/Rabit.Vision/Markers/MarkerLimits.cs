using System;

namespace Rabit.Vision;

/// <summary>
/// How clear a marker of a family must be. Where codes are few cells apart, windows, writing and boards come near to
/// one of them in every picture of a town: DICT_4X4_50's id 17 is a white patch in a black square. Immutable.
/// </summary>
internal sealed class MarkerLimits
{
    /// <summary>36h11: 11 cells apart; the code itself is proof.</summary>
    public static readonly MarkerLimits AprilTag36h11 = new()
    {
        MaxCorrected = 2,
        MinMargin = 0.6,
        MinCell = 0,
        MaxUnevenness = 0.4,
        MaxMisfit = 0.22,
        MaxMisfitPixels = double.PositiveInfinity,
        MinGrowth = -0.3,
    };

    /// <summary>DICT_4X4_50: 4 cells apart; one that is corrected is more often something else.</summary>
    public static readonly MarkerLimits ArUco4x4 = new()
    {
        MaxCorrected = 0,
        MinMargin = 0.8,
        MinCell = 0.25,
        MaxUnevenness = 0.22,
        MaxMisfit = 0.14,
        MaxMisfitPixels = 0.3,
        MinGrowth = -0.05,
        MinSimpleCellPixels = 4,
        MinSimpleMargin = 0.97,
    };

    /// <summary>How many cells may be read wrong.</summary>
    public int MaxCorrected { get; private init; }

    /// <summary>How far the cells are from the middle grey in the mean: 1 for black and white.</summary>
    public double MinMargin { get; private init; }

    /// <summary>The same of the worst cell.</summary>
    public double MinCell { get; private init; }

    /// <summary>
    /// How far the ring is from even black and the margin around it from even white, root of the sum of their mean
    /// squares; 1 is from black to white.
    /// </summary>
    public double MaxUnevenness { get; private init; }

    /// <summary>How far the edges between the cells lie from where they belong, cells.</summary>
    public double MaxMisfit { get; private init; }

    /// <summary>The same in pixels, for those with large cells.</summary>
    public double MaxMisfitPixels { get; private init; }

    /// <summary>What both limits leave, cells; blur may take a little of large cells too.</summary>
    public double MaxMisfitOf(double cellPixels) => Math.Min(MaxMisfit, Math.Max(0.06, MaxMisfitPixels / cellPixels));

    /// <summary>How far white grows over black, cells: in no picture of a camera does black grow.</summary>
    public double MinGrowth { get; private init; }

    /// <summary>
    /// Whether a marker of a simple code (<see cref="MarkerDictionary.IsSimple"/>) is clear enough: squares in squares
    /// make such a code, and where its cells are small nothing but their sharpness distinguishes them.
    /// </summary>
    public bool AcceptsSimple(double cellPixels, double margin)
        => cellPixels >= MinSimpleCellPixels && margin >= MinSimpleMargin;

    private double MinSimpleCellPixels { get; init; }

    private double MinSimpleMargin { get; init; }
}
