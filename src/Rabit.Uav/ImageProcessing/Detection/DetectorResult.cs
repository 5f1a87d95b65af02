using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What a detector returns for one picture. A plain value.</summary>
public readonly struct DetectorResult : IEquatable<DetectorResult>
{
    internal const string NoColourPicture = "the picture of a thermal camera shows no colours";

    private DetectorResult(int count, int dropped, string? refusal)
        => (Count, Dropped, Refusal) = (count, dropped, refusal);

    /// <summary>How many detections were written to the span, from its start.</summary>
    public int Count { get; }

    /// <summary>How many more there were, for which the span had no room.</summary>
    public int Dropped { get; }

    /// <summary>Why the picture could not be searched; null where it was.</summary>
    public string? Refusal { get; }

    /// <summary>Whether two are the same.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator ==(DetectorResult left, DetectorResult right) => left.Equals(right);

    /// <summary>Whether two differ.</summary>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    public static bool operator !=(DetectorResult left, DetectorResult right) => !left.Equals(right);

    /// <summary>The picture was searched.</summary>
    /// <param name="count">How many detections were written to the span, from its start: 0 to its length.</param>
    /// <param name="dropped">How many more there were, for which it had no room.</param>
    public static DetectorResult Found(int count, int dropped = 0) => new(count, dropped, refusal: null);

    /// <summary>The picture could not be searched, and is no observation of the ground that it shows.</summary>
    /// <param name="reason">
    /// Why, for people: it goes into <c>ImagingStatus.LastRefusal</c>. A constant costs no allocation.
    /// </param>
    public static DetectorResult NotSearched(string reason)
        => new(0, 0, reason ?? throw new ArgumentNullException(nameof(reason)));

    /// <inheritdoc/>
    public bool Equals(DetectorResult other)
        => Count == other.Count && Dropped == other.Dropped
            && string.Equals(Refusal, other.Refusal, StringComparison.Ordinal);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is DetectorResult other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((Count * 397) ^ Dropped);
}
