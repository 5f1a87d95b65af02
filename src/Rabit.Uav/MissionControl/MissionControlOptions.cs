using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.MissionControl;

/// <summary>What Mission Control flies, and how patient it is. Read once, when the manager is made.</summary>
public sealed class MissionControlOptions
{
    /// <summary>The mission; null to observe and command nothing.</summary>
    public MissionPlan? Mission { get; set; }

    /// <summary>Whether a mission needs a camera to begin.</summary>
    /// <value>The default is true: a search that sees nothing is none.</value>
    public bool RequiresCamera { get; set; } = true;

    /// <summary>How long to wait for the vehicle to be heard, healthy and to know where it is, before the mission is given up.</summary>
    /// <value>The default is 5 min: a cold receiver needs a minute or two for its first fix.</value>
    public TimeSpan ReadyWithin { get; set; } = TimeSpan.FromMinutes(5);

    /// <summary>How long arming is tried.</summary>
    /// <value>The default is 60 s: the checks of a vehicle that just started pass one after the other.</value>
    public TimeSpan ArmWithin { get; set; } = TimeSpan.FromSeconds(60);

    /// <summary>How much of the area must have been looked at for the search to be complete, 0 to 1.</summary>
    /// <value>The default is 0.985.</value>
    public double CoverageGoal { get; set; } = 0.985;

    /// <summary>How often what was missed is flown over again.</summary>
    /// <value>The default is 2.</value>
    public int GapPasses { get; set; } = 2;

    /// <exception cref="ArgumentException">Options are out of their range, or the mission cannot be flown; the text names all faults.</exception>
    internal MissionControlOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Mission Control: " + string.Join("; ", faults) + ".", parameter);
        return (MissionControlOptions)MemberwiseClone();
    }

    internal MissionControlOptions Copy() => (MissionControlOptions)MemberwiseClone();

    private IEnumerable<string> FindFaults()
    {
        if (ReadyWithin <= TimeSpan.Zero)
            yield return $"{nameof(ReadyWithin)} is {ReadyWithin}; it must be above zero";
        if (ArmWithin <= TimeSpan.Zero)
            yield return $"{nameof(ArmWithin)} is {ArmWithin}; it must be above zero";
        if (!(CoverageGoal >= 0 && CoverageGoal <= 1))
            yield return FormattableString.Invariant($"{nameof(CoverageGoal)} is {CoverageGoal}; it must be 0 to 1");
        if (GapPasses is < 0 or > 10)
            yield return FormattableString.Invariant($"{nameof(GapPasses)} is {GapPasses}; it must be 0 to 10");
        foreach (string fault in Mission is null ? [] : MissionPlanRules.FindFaults(Mission))
            yield return $"{nameof(Mission)}: {fault}";
    }
}
