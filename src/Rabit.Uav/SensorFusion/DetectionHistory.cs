namespace Rabit.Uav.SensorFusion;

/// <summary>In which of the last observations of its place a track was detected. A plain value.</summary>
internal struct DetectionHistory
{
    /// <summary>How many observations it remembers.</summary>
    public const int Capacity = 16;

    private uint _hits;

    /// <summary>How many observations it remembers now, at most <see cref="Capacity"/>.</summary>
    public int Observations { get; private set; }

    public void Add(bool isHit)
    {
        _hits = (_hits << 1) | (isHit ? 1u : 0u);
        if (Observations < Capacity)
            Observations++;
    }

    /// <summary>In how many of the last observations it was detected.</summary>
    public readonly int HitsInLast(int observations)
    {
        int hits = 0;
        for (int i = 0; i < observations && i < Observations; i++)
            hits += (int)((_hits >> i) & 1);
        return hits;
    }

    /// <summary>In how many of the last observations it was not.</summary>
    public readonly int MissesInLast(int observations)
        => (observations < Observations ? observations : Observations) - HitsInLast(observations);
}
