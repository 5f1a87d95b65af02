namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>How many targets in pictures were seen, and how many reports are of none.</summary>
internal sealed class SurveyCount
{
    public int Expected { get; set; }

    public int Found { get; set; }

    public int Wrong { get; set; }

    public void Add(SurveyCount other)
    {
        Expected += other.Expected;
        Found += other.Found;
        Wrong += other.Wrong;
    }

    public override string ToString() => $"{Found} of {Expected} found, {Wrong} wrong";
}
