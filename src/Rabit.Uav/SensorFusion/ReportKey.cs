using System;

namespace Rabit.Uav.SensorFusion;

/// <summary>The identity of a report: source, picture and index. A plain value.</summary>
internal readonly struct ReportKey(byte source, long picture, int index) : IEquatable<ReportKey>
{
    public byte Source { get; } = source;

    public long Picture { get; } = picture;

    public int Index { get; } = index;

    public bool Equals(ReportKey other) => Source == other.Source && Picture == other.Picture && Index == other.Index;

    public override bool Equals(object? obj) => obj is ReportKey other && Equals(other);

    public override int GetHashCode() => unchecked((((Picture.GetHashCode() * 397) ^ Source) * 397) ^ Index);
}
