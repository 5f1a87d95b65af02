using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Something on this computer, at its place among the others.</summary>
internal sealed class LocalStep(Func<string?> act) : SetupStep
{
    public override bool TryStart(TimeSpan now) => true;

    public override bool TryFinish(TimeSpan now, out string? fault)
    {
        fault = act();
        return true;
    }
}
