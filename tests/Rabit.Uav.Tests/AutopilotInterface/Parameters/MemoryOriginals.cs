using Rabit.Uav.AutopilotInterface;

namespace Rabit.Uav.Tests.AutopilotInterface.Parameters;

/// <summary>Keeps originals in memory, and counts.</summary>
internal sealed class MemoryOriginals : IOriginalsStore
{
    public Originals? Kept { get; set; }

    public int Saves { get; private set; }

    /// <summary>Why nothing can be saved; null where it can.</summary>
    public string? Fault { get; set; }

    /// <summary>Called at each save, before it is kept.</summary>
    public System.Action? Saving { get; set; }

    public string? Load(out Originals? originals)
    {
        originals = Kept;
        return null;
    }

    public string? Save(Originals originals)
    {
        Saving?.Invoke();
        if (Fault is not null)
            return Fault;
        Saves++;
        Kept = originals;
        return null;
    }

    public string? Delete()
    {
        Kept = null;
        return null;
    }
}
