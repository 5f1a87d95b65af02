using System;

namespace Rabit.Uav.SensorFusion;

/// <summary>The identity of a report: who saw it, in which picture, the how many-th. A plain value.</summary>
internal readonly struct ReportKey(byte source, long look, int index) : IEquatable<ReportKey>
{
    public byte Source { get; } = source;

    public long Look { get; } = look;

    public int Index { get; } = index;

    public bool Equals(ReportKey other) => Source == other.Source && Look == other.Look && Index == other.Index;

    public override bool Equals(object? obj) => obj is ReportKey other && Equals(other);

    public override int GetHashCode() => unchecked((((Look.GetHashCode() * 397) ^ Source) * 397) ^ Index);
}
