namespace Rabit.Uav.AutopilotInterface;

/// <summary>Keeps what the autopilot had before anything was written. One thread.</summary>
internal interface IOriginalsStore
{
    /// <summary>Reads what is kept.</summary>
    /// <param name="originals">What is kept; null where nothing is.</param>
    /// <returns>Why what is there cannot be used, as text; null where it can, or where nothing is there.</returns>
    string? Load(out Originals? originals);

    /// <summary>Keeps it so that it is complete on disk, or what was kept before is unchanged.</summary>
    /// <returns>Why it cannot be kept, as text; null where it is.</returns>
    string? Save(Originals originals);

    /// <summary>Forgets it: all of it is written back.</summary>
    /// <returns>Why it is still there, as text; null where it is not.</returns>
    string? Delete();
}
