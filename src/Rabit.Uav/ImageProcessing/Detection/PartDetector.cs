using System.Collections.Immutable;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>A detector, and the classes that it is for.</summary>
internal sealed class PartDetector(ITargetDetector detector, ImmutableArray<TargetClass> classes)
{
    public ITargetDetector Detector { get; } = detector;

    public bool IsWanted { get; private set; }

    /// <summary>Takes the classes that are searched for.</summary>
    public void Select(ImmutableArray<TargetClass> wanted)
    {
        IsWanted = false;
        foreach (TargetClass one in wanted)
        {
            foreach (TargetClass own in classes)
                IsWanted |= own.Name == one.Name;
        }
    }
}
