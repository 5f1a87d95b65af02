using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>A detector, and the classes that it is for.</summary>
internal sealed class PartDetector(ITargetDetector detector, ImmutableArray<TargetClass> classes)
{
    public ITargetDetector Detector { get; } = detector;

    public ImmutableArray<TargetClass> Classes => classes;

    public bool IsWanted { get; private set; }

    /// <summary>Takes the classes that are searched for.</summary>
    public void Select(ImmutableArray<TargetClass> wanted)
    {
        IsWanted = false;
        foreach (TargetClass one in wanted)
            IsWanted |= Has(one.Name);
    }

    /// <summary>Whether it is for a class.</summary>
    public bool Has(TargetClassName name) => Find(name) is not null;

    /// <summary>The class of a name; null where it is not for such a one.</summary>
    public TargetClass? Find(TargetClassName name)
    {
        foreach (TargetClass own in classes)
        {
            if (own.Name == name)
                return own;
        }

        return null;
    }
}
