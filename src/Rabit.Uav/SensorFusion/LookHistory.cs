namespace Rabit.Uav.SensorFusion;

/// <summary>In which of the last looks that could see it something was reported. A plain value.</summary>
internal struct LookHistory
{
    /// <summary>How many looks it remembers.</summary>
    public const int Capacity = 16;

    private uint _hits;

    /// <summary>How many looks it has seen, at most <see cref="Capacity"/>.</summary>
    public int Looks { get; private set; }

    public void Add(bool isHit)
    {
        _hits = (_hits << 1) | (isHit ? 1u : 0u);
        if (Looks < Capacity)
            Looks++;
    }

    /// <summary>How many of the last looks reported it.</summary>
    public readonly int HitsInLast(int looks)
    {
        int hits = 0;
        for (int i = 0; i < looks && i < Looks; i++)
            hits += (int)((_hits >> i) & 1);
        return hits;
    }

    /// <summary>How many of the last looks did not.</summary>
    public readonly int MissesInLast(int looks) => (looks < Looks ? looks : Looks) - HitsInLast(looks);
}
