using System;
using System.Collections.Generic;

namespace Rabit.Vision;

/// <summary>What a <see cref="MarkerDetector"/> looks for.</summary>
public sealed class MarkerDetectorOptions
{
    /// <summary>The families; a picture takes little longer for a second one.</summary>
    /// <value>The default is all.</value>
    public IReadOnlyList<MarkerFamily> Families { get; set; } =
        [MarkerFamily.ArUco4x4, MarkerFamily.AprilTag36h11];

    /// <summary>Shortest side of the black square, pixels; 6 or more.</summary>
    /// <value>The default is 8.</value>
    public double MinSidePixels { get; set; } = 8;

    /// <summary>White less black, grey levels, 5 to 200.</summary>
    /// <value>The default is 25.</value>
    public int MinContrast { get; set; } = 25;

    internal MarkerDetectorOptions Copy() => new()
    {
        Families = [.. Families ?? []],
        MinSidePixels = MinSidePixels,
        MinContrast = MinContrast,
    };

    internal IEnumerable<string> FindFaults()
    {
        if (Families is not { Count: > 0 })
            yield return $"{nameof(Families)} names none";
        foreach (MarkerFamily family in Families ?? [])
        {
            if (family is not (MarkerFamily.ArUco4x4 or MarkerFamily.AprilTag36h11))
                yield return $"{nameof(Families)} has the unknown family {(int)family}";
        }

        if (!(MinSidePixels >= 6 && MinSidePixels <= 10_000))
        {
            yield return FormattableString.Invariant(
                $"{nameof(MinSidePixels)} is {MinSidePixels}; it must be 6 to 10000");
        }

        if (MinContrast is < 5 or > 200)
            yield return $"{nameof(MinContrast)} is {MinContrast}; it must be 5 to 200";
    }
}
