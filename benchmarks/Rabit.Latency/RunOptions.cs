namespace Rabit.Latency;

/// <summary>How much is measured.</summary>
internal sealed class RunOptions
{
    /// <summary>A few seconds for everything: only shows that every mode works.</summary>
    public bool IsQuick { get; set; }

    /// <summary>Interleaved rounds; the tables show their medians.</summary>
    public int Rounds { get; set; } = 7;

    /// <summary>How long the soak lasts.</summary>
    public double SoakMinutes { get; set; } = 1;

    /// <summary>Leaves something behind on purpose, to see that the soak finds it.</summary>
    public bool PlantsLeak { get; set; }

    /// <summary>One of the two, by how much is measured.</summary>
    public T Pick<T>(T quick, T full) => IsQuick ? quick : full;
}
